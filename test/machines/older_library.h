// What Resect uses of C++20's library and emscripten 3.1.6, of Debian 12, does not have. Included
// before every source file by test/machines/CMakeLists.txt where the library is that old; no part
// of Resect.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

// Decimal numbers, in the C locale that a program starts with.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const string text(first, last);
  const char c = text.empty() ? ' ' : text[0];
  char* end = nullptr;
  const double read = c == ' ' || c == '+' || c == '\t' ? 0 : strtod(text.c_str(), &end);
  if (end == nullptr || end == text.c_str()) return {first, errc::invalid_argument};
  value = read;
  return {first + (end - text.c_str()), errc()};
}
inline from_chars_result from_chars(const char* first, const char* last, float& value) {
  double wide = value;
  const auto result = from_chars(first, last, wide);
  value = float(wide);
  return result;
}
template <class Number, enable_if_t<is_floating_point_v<Number>, int> = 0>
to_chars_result to_chars(char* first, char* last, Number value) {
  return {fmt::format_to_n(first, size_t(last - first), "{}", value).out, errc()};
}
template <class Number, enable_if_t<is_floating_point_v<Number>, int> = 0>
to_chars_result to_chars(char* first, char* last, Number value, chars_format, int precision) {
  return {fmt::format_to_n(first, size_t(last - first), "{:.{}e}", value, precision).out, errc()};
}

// No thread is ever started on this machine, but the type is named.
class jthread : public thread {
 public:
  using thread::thread;
  jthread(jthread&&) = default;
  ~jthread() {
    if (joinable()) join();
  }
};

namespace ranges {

template <class Range, class T>
constexpr auto find(Range&& range, const T& value) {
  return std::find(std::begin(range), std::end(range), value);
}
template <class Range, class T, class Projection>
constexpr auto find(Range&& range, const T& value, Projection of) {
  return std::find_if(std::begin(range), std::end(range),
                      [&](auto&& x) { return invoke(of, x) == value; });
}
template <class Range, class Test>
constexpr auto find_if(Range&& range, Test test) {
  return std::find_if(std::begin(range), std::end(range), test);
}
template <class Range, class Test>
constexpr bool any_of(Range&& range, Test test) {
  return std::any_of(std::begin(range), std::end(range), [&](auto&& x) { return invoke(test, x); });
}
template <class Range, class Test>
constexpr bool all_of(Range&& range, Test test) {
  return std::all_of(std::begin(range), std::end(range), [&](auto&& x) { return invoke(test, x); });
}
template <class Range, class Test>
constexpr auto count_if(Range&& range, Test test) {
  return std::count_if(std::begin(range), std::end(range),
                       [&](auto&& x) { return invoke(test, x); });
}
template <class Range, class T>
constexpr auto count(Range&& range, const T& value) {
  return std::count(std::begin(range), std::end(range), value);
}
template <class Range, class T, class Projection>
constexpr auto count(Range&& range, const T& value, Projection of) {
  return std::count_if(std::begin(range), std::end(range),
                       [&](auto&& x) { return invoke(of, x) == value; });
}
template <class Range>
constexpr auto max_element(Range&& range) {
  return std::max_element(std::begin(range), std::end(range));
}
template <class Range, class T>
constexpr void fill(Range&& range, const T& value) {
  std::fill(std::begin(range), std::end(range), value);
}
template <class Range, class Out>
constexpr void copy(Range&& range, Out out) {
  std::copy(std::begin(range), std::end(range), out);
}
template <class Range, class T>
constexpr void replace(Range&& range, const T& before, const T& after) {
  std::replace(std::begin(range), std::end(range), before, after);
}
template <class Range, class Out, class Function>
constexpr void transform(Range&& range, Out out, Function function) {
  std::transform(std::begin(range), std::end(range), out,
                 [&](auto&& x) { return invoke(function, x); });
}
template <class A, class B, class Same = std::equal_to<>>
constexpr bool equal(A&& a, B&& b, Same same = {}) {
  return std::equal(std::begin(a), std::end(a), std::begin(b), std::end(b), same);
}
template <class A, class B>
constexpr auto mismatch(A&& a, B&& b) {
  struct {
    decltype(std::begin(a)) in1;
    decltype(std::begin(b)) in2;
  } result{};
  tie(result.in1, result.in2) =
      std::mismatch(std::begin(a), std::end(a), std::begin(b), std::end(b));
  return result;
}

// Sorted ranges: `of` gives what elements are compared by.
template <class Range, class Less = std::less<>, class Projection = identity>
constexpr void sort(Range&& range, Less compare = {}, Projection of = {}) {
  std::sort(std::begin(range), std::end(range),
            [&](auto&& a, auto&& b) { return invoke(compare, invoke(of, a), invoke(of, b)); });
}
template <class Range, class Less = std::less<>, class Projection = identity>
constexpr bool is_sorted(Range&& range, Less compare = {}, Projection of = {}) {
  return std::is_sorted(std::begin(range), std::end(range), [&](auto&& a, auto&& b) {
    return invoke(compare, invoke(of, a), invoke(of, b));
  });
}
template <class Range, class T, class Less = std::less<>, class Projection = identity>
constexpr auto lower_bound(Range&& range, const T& value, Less compare = {}, Projection of = {}) {
  return std::lower_bound(std::begin(range), std::end(range), value,
                          [&](auto&& x, const T& v) { return invoke(compare, invoke(of, x), v); });
}
template <class Range, class T, class Less = std::less<>, class Projection = identity>
constexpr auto upper_bound(Range&& range, const T& value, Less compare = {}, Projection of = {}) {
  return std::upper_bound(std::begin(range), std::end(range), value,
                          [&](const T& v, auto&& x) { return invoke(compare, v, invoke(of, x)); });
}
template <class Range, class T, class Less = std::less<>, class Projection = identity>
constexpr bool binary_search(Range&& range, const T& value, Less compare = {}, Projection of = {}) {
  const auto at = lower_bound(range, value, compare, of);
  return at != std::end(range) && !invoke(compare, value, invoke(of, *at));
}
template <class Iterator>
struct Between {
  Iterator first, last;
  Iterator begin() const { return first; }
  Iterator end() const { return last; }
  size_t size() const { return size_t(last - first); }
};
template <class Range, class T, class Less = std::less<>, class Projection = identity>
constexpr auto equal_range(Range&& range, const T& value, Less compare = {}, Projection of = {}) {
  const auto first = lower_bound(range, value, compare, of);
  return Between<decltype(std::begin(range))>{first, upper_bound(range, value, compare, of)};
}

}  // namespace ranges
}  // namespace std
