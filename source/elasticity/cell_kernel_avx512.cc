#define STICTION_VECTOR_BYTES 64
#include "cell_kernel_table.h"

namespace stiction::cell_kernel
{
  const KernelPair avx512 = {kernels<float>(), kernels<double>()};
}
