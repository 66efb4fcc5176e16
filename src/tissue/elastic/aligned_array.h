// Arrays aligned to cache lines. Arrays of 64 KiB or more ("large") begin at different offsets
// within a page, to avoid cache conflicts.
//
// The computation of elastic tissue reads some fifty arrays, each with an entry for every cell.
// Large blocks from the system all begin at the same offset in a page. If all arrays began at this
// offset, the entries of one cell would map to the same few sets of the first-level cache. These
// entries would evict each other, and access to memory would limit the speed of substeps
// (docs/methods/tissue.md).
#pragma once

#include <atomic>
#include <cstddef>
#include <cstring>
#include <new>
#include <vector>

namespace resect {

inline constexpr std::size_t kCacheLine = 64, kPage = 4096;

// The offset within a page of the next large array, bytes.
inline std::size_t nextShift() {
  static std::atomic<std::size_t> next = 0;
  constexpr std::size_t kStep = 5 * kCacheLine;  // 64 steps reach every cache line of a page
  return next.fetch_add(kStep, std::memory_order_relaxed) % kPage;
}

template <typename T>
struct LineAllocator {
  using value_type = T;
  static constexpr std::align_val_t kAlignment{kCacheLine};
  static bool large(std::size_t n) { return n * sizeof(T) >= 16 * kPage; }

  LineAllocator() = default;
  template <typename U>
  LineAllocator(const LineAllocator<U>&) {}

  // The cache line before a large array holds one number: the offset of the array from the start of
  // the allocated memory block, bytes.
  T* allocate(std::size_t n) {
    if (!large(n)) return static_cast<T*>(::operator new(n * sizeof(T), kAlignment));
    const std::size_t shift = nextShift() + kCacheLine;
    auto* block =
        static_cast<std::byte*>(::operator new(n * sizeof(T) + kPage + kCacheLine, kAlignment));
    std::memcpy(block + shift - kCacheLine, &shift, sizeof shift);
    return reinterpret_cast<T*>(block + shift);
  }
  void deallocate(T* p, std::size_t n) {
    auto* start = reinterpret_cast<std::byte*>(p);
    if (large(n)) {
      std::size_t shift = 0;
      std::memcpy(&shift, start - kCacheLine, sizeof shift);
      start -= shift;
    }
    ::operator delete(start, kAlignment);
  }
  friend bool operator==(const LineAllocator&, const LineAllocator&) { return true; }
};

template <typename T>
using AlignedArray = std::vector<T, LineAllocator<T>>;

}  // namespace resect
