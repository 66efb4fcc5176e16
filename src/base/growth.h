// How does a large array grow without copying itself at every frame, nor doubling?
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/large_pages.h"

namespace resect {

// reserve(size), on large pages where the system has them.
template <typename T>
void reserveFor(std::vector<T>& array, std::size_t size) {
  if (size <= array.capacity()) return;
  array.reserve(size);
  wantLargePages(array.data() + array.size(), (size - array.size()) * sizeof(T));
}

// resize(size, value) with room for a thirty-second more, from the first time on: an organ that is
// cut gets some more surface, and copying tens of megabytes would cost it a frame.
template <typename T>
void growTo(std::vector<T>& array, std::size_t size, const T& value) {
  const std::size_t before = array.size();
  if (size > array.capacity()) reserveFor(array, size + size / 32);
  array.resize(size);
  // Not by resize(size, value): for a type of three numbers that is many times slower.
  if (size > before) std::fill(array.begin() + std::ptrdiff_t(before), array.end(), value);
}

}  // namespace resect
