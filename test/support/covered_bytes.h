// Finds the bytes of a struct that are in neither visit() nor visitMade().
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/state/state_visitor.h"

namespace resect::test {

// Notes where the fields lie that are named in the object itself, not in what they hold.
class CoveredBytes final : public StateVisitor {
 public:
  CoveredBytes(const void* object, std::size_t bytes)
      : begin_(static_cast<const char*>(object)), covered_(bytes, false) {}
  std::vector<bool> covered() const { return covered_; }

 protected:
  void object(const void* address, std::size_t bytes) override {
    const std::ptrdiff_t at = static_cast<const char*>(address) - begin_;
    if (at < 0 || std::size_t(at) + bytes > covered_.size()) return;
    std::fill_n(covered_.begin() + at, bytes, true);
  }
  void numbers(const char*, void*, std::size_t, std::size_t) override {}
  std::size_t enterList(const char*, std::size_t count) override { return count; }
  void enter(const char*) override {}
  void leave() override {}

 private:
  const char* begin_;
  std::vector<bool> covered_;
};

// "" when all are named; else the first gap. What the alignment of the next field explains, at most
// seven bytes up to a multiple of eight or four, is no gap, nor is the table of virtual functions.
template <typename State>
std::string uncoveredBytes(const State& state) {
  CoveredBytes visitor(&state, sizeof state);
  const_cast<State&>(state).visit(visitor);
  const_cast<State&>(state).visitMade(visitor);
  const std::vector<bool> covered = visitor.covered();
  for (std::size_t i = std::is_polymorphic_v<State> ? sizeof(void*) : 0; i < covered.size();) {
    if (covered[i]) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < covered.size() && !covered[end]) ++end;
    if (end - i >= 8 || end % 4 != 0) return fmt::format("bytes {} to {}", i, end);
    i = end;
  }
  return "";
}

}  // namespace resect::test
