#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace stiction
{
  /// Sorts a list, and leaves each of its values in it once.
  template<typename Value> void sort_once(std::vector<Value> &list)
  {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  /// The place in such a list of a value that it has.
  template<typename Value, typename Sought>
  std::size_t place_in(const std::vector<Value> &sorted, const Sought &value)
  {
    return std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin();
  }
} // namespace stiction
