#define STICTION_VECTOR_BYTES 16
#include "cell_kernel_table.h"

namespace stiction::cell_kernel
{
  const KernelPair baseline = {kernels<float>(), kernels<double>()};
}
