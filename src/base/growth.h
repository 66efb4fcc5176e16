// Grows large arrays by a thirty-second (3 %) instead of doubling them, so that memory stays small
// and reallocation rare.
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

// Calls array.resize(size) and keeps a thirty-second of spare capacity from the first call on. A
// cut adds a little surface; without the spare capacity, tens of megabytes would be copied, which
// takes as long as a frame. New elements are uninitialised; the caller writes them.
template <typename T>
void growTo(RawArray<T>& array, std::size_t size) {
  if (size > array.capacity()) reserveFor(array, size + size / 32);
  array.resize(size);
}

}  // namespace resect
