// How does a large array grow without copying itself at every frame, nor doubling?
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/large_pages.h"
#include "base/raw_array.h"

namespace resect {

// reserve(size), on large pages where the system has them.
template <typename T, typename Allocator>
void reserveFor(std::vector<T, Allocator>& array, std::size_t size) {
  if (size <= array.capacity()) return;
  array.reserve(size);
  wantLargePages(array.data() + array.size(), (size - array.size()) * sizeof(T));
}

// resize(size) with room for a thirty-second more, from the first time on: an organ that is cut
// gets some more surface, and copying tens of megabytes would cost it a frame. The caller writes
// what is new.
template <typename T>
void growTo(RawArray<T>& array, std::size_t size) {
  if (size > array.capacity()) reserveFor(array, size + size / 32);
  array.resize(size);
}

}  // namespace resect
