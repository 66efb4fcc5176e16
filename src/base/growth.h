// How does a large array grow without copying itself at every frame, nor doubling?
#pragma once

#include <cstddef>
#include <vector>

namespace resect {

// resize(size, value) with room for a thirty-second more, from the first time on: an organ that is
// cut gets some more surface, and copying tens of megabytes would cost it a frame.
template <typename T>
void growTo(std::vector<T>& array, std::size_t size, const T& value) {
  if (size > array.capacity()) array.reserve(size + size / 32);
  array.resize(size, value);
}

}  // namespace resect
