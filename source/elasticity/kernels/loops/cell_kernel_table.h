#pragma once

#include "cell_kernel_general.h"

namespace stiction::cell_kernel
{
  namespace
  {
    template<typename Number> constexpr Kernels<Number> kernels()
    {
      return {Register<Number>::lanes,
              Register<Number>::repeats ? Register<Number>::lanes : 1,
              add_affine<Number, 2, false>,
              add_affine<Number, 3, false>,
              add_affine<Number, 2, true>,
              add_affine<Number, 3, true>,
              add_general<Number>};
    }
  } // namespace
} // namespace stiction::cell_kernel
