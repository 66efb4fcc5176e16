// A vector whose resize() leaves new elements uninitialised, for data that are overwritten
// immediately.
#pragma once

#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace resect {

// Default-initialises elements that are given no value, as `new T` does. So numbers stay
// uninitialised.
template <typename T>
struct UnwrittenAllocator : std::allocator<T> {
  template <typename U>
  struct rebind {
    using other = UnwrittenAllocator<U>;
  };
  template <typename U>
  void construct(U* element) noexcept(std::is_nothrow_default_constructible_v<U>) {
    ::new (static_cast<void*>(element)) U;
  }
  template <typename U, typename... Args>
  void construct(U* element, Args&&... args) {
    ::new (static_cast<void*>(element)) U(std::forward<Args>(args)...);
  }
};

// A std::vector whose resize(n) writes nothing to new elements. All other functions do the same as
// in any std::vector; this includes resize(n, value) and assign().
template <typename T>
using RawArray = std::vector<T, UnwrittenAllocator<T>>;

}  // namespace resect
