// Of AVX-512 the 32 registers help, not so their 512 bits: with twice the
// cells in a batch, what is read and written for them no longer keeps up.
#define STICTION_VECTOR_BYTES 32
#include "cell_kernel_table.h"

namespace stiction::cell_kernel
{
  const KernelPair avx512 = {kernels<float>(), kernels<double>()};
}
