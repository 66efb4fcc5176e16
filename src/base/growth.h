// Grows large arrays with a spare capacity of 1/32 (3 %). Doubling the capacity, as std::vector
// does, would waste memory. Without any spare capacity, every growth would copy the array.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/large_pages.h"
#include "base/raw_array.h"

namespace resect {

// Calls array.reserve(size) and requests large pages for the new memory.
template <typename T, typename Allocator>
void reserveFor(std::vector<T, Allocator>& array, std::size_t size) {
  if (size <= array.capacity()) return;
  array.reserve(size);
  wantLargePages(array.data() + array.size(), (size - array.size()) * sizeof(T));
}

// Calls array.resize(size). If the capacity is too small, it is first raised to size + size / 32.
// For example, a cut through an organ adds a few triangles to the arrays of the surface. These
// triangles nearly always fit into the spare capacity. Without spare capacity, a cut would copy
// tens of megabytes, which takes as long as a frame. New elements are uninitialised; the caller
// writes them.
template <typename T>
void growTo(RawArray<T>& array, std::size_t size) {
  if (size > array.capacity()) reserveFor(array, size + size / 32);
  array.resize(size);
}

}  // namespace resect
