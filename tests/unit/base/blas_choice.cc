// A process whose OpenBLAS takes the processor for an old one starts itself
// again, once, if the processor knows AVX2.

#include <stiction/base/blas_choice.h>

#include <cstdlib>
#include <iostream>
#include <string>

// Stands in for OpenBLAS: believes in a Prescott unless it is told otherwise.
extern "C" __attribute__((visibility("default"))) const char *openblas_get_corename()
{
  const char *const told = std::getenv("OPENBLAS_CORETYPE");
  return told != nullptr ? told : "Prescott";
}

int main()
{
  // what the tester's own machine is told to take
  if (std::getenv("STICTION_OPENBLAS_CORE_WAS") == nullptr)
    unsetenv("OPENBLAS_CORETYPE");
  stiction::choose_blas_kernels();

  bool is_old = true;
#ifdef __x86_64__
  is_old = !__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma");
#endif
  const std::string core = openblas_get_corename();
  const bool is_right    = is_old ? core == "Prescott" && stiction::blas_remark().empty()
                                  : core != "Prescott" && !stiction::blas_remark().empty();
  std::cout << "kernels for this processor: " << (is_right ? "yes" : "NO") << std::endl;

  // whoever chose kernels has them
  unsetenv("STICTION_OPENBLAS_CORE_WAS");
  setenv("OPENBLAS_CORETYPE", "Prescott", 1);
  stiction::choose_blas_kernels();
  std::cout << "a choice is left alone: "
            << (stiction::blas_remark().empty() ? "yes" : "NO") << std::endl;
}
