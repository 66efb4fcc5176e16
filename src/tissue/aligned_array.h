// Arrays over the cells of a tissue, laid out for loops that read some forty of them at one index.
//
// They start on a cache line, as wide vector instructions like it, and lie in a few large blocks of
// memory: the system may give those large pages, so that forty arrays need few entries of the
// address cache. No two neighbours in a block start at the same place of a page; else the same
// index of all of them would fall into one set of the first-level cache, which holds eight.
#pragma once

#include <cstddef>
#include <vector>

namespace resect {

// Memory for one array, on a cache line; throws std::bad_alloc. A block goes back to the system
// with the last array in it. Any thread.
void* takeArray(std::size_t bytes);
void giveArray(void* array);

template <typename T>
struct ArrayAllocator {
  using value_type = T;
  ArrayAllocator() = default;
  template <typename U>
  ArrayAllocator(const ArrayAllocator<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(takeArray(n * sizeof(T))); }
  void deallocate(T* p, std::size_t) { giveArray(p); }
  friend bool operator==(const ArrayAllocator&, const ArrayAllocator&) { return true; }
};

template <typename T>
using AlignedArray = std::vector<T, ArrayAllocator<T>>;

}  // namespace resect
