#ifndef S_IS
#define S_IS
namespace stiction
{
  enum class InstructionSet
  {
    baseline,
    avx2,
    avx512
  };
  inline InstructionSet
  best_instruction_set()
  {
    return InstructionSet::baseline;
  }
} // namespace stiction
#endif
