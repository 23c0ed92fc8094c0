#include <stiction/elasticity/kernels/instruction_set.h>

namespace stiction
{
  bool is_supported(const InstructionSet instruction_set)
  {
    switch (instruction_set)
      {
        case InstructionSet::baseline:
          return true;
#ifdef STICTION_WITH_AVX2_KERNELS
        case InstructionSet::avx2:
          return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#endif
#ifdef STICTION_WITH_AVX512_KERNELS
        case InstructionSet::avx512:
          return __builtin_cpu_supports("avx512f") &&
                 __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
#endif
        default:
          return false;
      }
  }

  InstructionSet best_instruction_set()
  {
    InstructionSet best = InstructionSet::baseline;
    for (const InstructionSet candidate : all_instruction_sets)
      if (is_supported(candidate))
        best = candidate;
    return best;
  }

  const char *name(const InstructionSet instruction_set)
  {
    switch (instruction_set)
      {
        case InstructionSet::avx2:
          return "AVX2";
        case InstructionSet::avx512:
          return "AVX-512";
        default:
          return "baseline";
      }
  }
} // namespace stiction
