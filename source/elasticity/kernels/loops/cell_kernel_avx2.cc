#define STICTION_VECTOR_BYTES 32
#include "cell_kernel_table.h"

namespace stiction::cell_kernel
{
  const KernelPair avx2 = {kernels<float>(), kernels<double>()};
}
