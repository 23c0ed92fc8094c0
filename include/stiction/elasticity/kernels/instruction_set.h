#pragma once

namespace stiction
{
  /// What the kernels of CellStiffness are compiled for: the instructions that
  /// every CPU of this architecture has, or, on x86-64, AVX2 with fused
  /// multiply-add, or AVX-512.
  enum class InstructionSet
  {
    baseline,
    avx2,
    avx512
  };

  /// All of them, from the narrowest to the widest.
  constexpr InstructionSet all_instruction_sets[] = {
    InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512};

  /// Whether this build has kernels for it and this CPU can run them.
  bool is_supported(InstructionSet instruction_set);

  /// The widest one that is supported.
  InstructionSet best_instruction_set();

  /// "baseline", "AVX2" or "AVX-512".
  const char *name(InstructionSet instruction_set);
} // namespace stiction
