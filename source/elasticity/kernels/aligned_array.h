#pragma once

#include <cstddef>
#include <vector>

namespace stiction::cell_kernel
{
  /// Numbers in memory that a register of any width can be loaded from.
  template<typename Number> class AlignedArray
  {
  public:
    /// Keeps the first numbers and gives back memory that is not needed.
    void resize(const std::size_t size)
    {
      lines_.resize((size * sizeof(Number) + sizeof(Line) - 1) / sizeof(Line));
      lines_.shrink_to_fit();
    }

    Number *data() { return reinterpret_cast<Number *>(lines_.data()); }

    const Number *data() const { return reinterpret_cast<const Number *>(lines_.data()); }

  private:
    struct alignas(64) Line
    {
      unsigned char bytes[64];
    };
    std::vector<Line> lines_;
  };
} // namespace stiction::cell_kernel
