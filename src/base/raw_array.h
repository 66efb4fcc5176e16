// A vector whose resize() leaves new elements uninitialised, for data that are overwritten
// immediately.
#pragma once

#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace resect {

// Elements that are given no value are default-initialised, as by `new T`: numbers stay
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

// A std::vector whose resize(n) writes nothing to new elements. All other functions are those of
// std::vector, resize(n, value) and assign() included.
template <typename T>
using RawArray = std::vector<T, UnwrittenAllocator<T>>;

}  // namespace resect
