// One digest per named field of a state, cheap enough for every frame.
//
// Two states are compared field by field without keeping either: a recording holds the digests of
// each frame, and the first one that differs names the field. Fields of the same path (the
// displacements of several organs) share a digest. 0.1 ms per MB of state.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/state/state_visitor.h"

namespace resect {

class FieldHashes final : public StateVisitor {
 public:
  FieldHashes() = default;
  // With the paths that another object had, sealed.
  explicit FieldHashes(std::vector<std::string> paths);

  // From now on there are no other paths. A list that had no entries so far is one field with all
  // that its entries hold, so that the number of digests does not depend on what happened.
  void seal();
  // Whether a field was visited that no path stands for: its state is of another program.
  bool strange() const { return strange_; }

  // Paths as "organs.tissue.u", in the order in which visit() first names them.
  const std::vector<std::string>& paths() const { return paths_; }
  // One digest per path.
  const std::vector<std::uint64_t>& values() const { return values_; }

  // Ready for the next state; paths are kept, so a field keeps its number.
  void clear();

 protected:
  void numbers(const char* name, void* data, std::size_t count, std::size_t size) override;
  std::size_t enterList(const char* name, std::size_t count) override;
  void enter(const char* name) override;
  void leave() override;

 private:
  std::uint64_t& at(const char* name);

  bool sealed_ = false, strange_ = false;
  std::vector<char> leaf_;  // 1: no path lies below this one
  // Depth inside a list that is one field, and the number of that field.
  std::size_t inField_ = 0, field_ = 0;
  std::uint64_t ignored_ = 0;
  std::string path_;
  std::vector<std::size_t> lengths_;  // of path_ before each enter()
  std::vector<std::string> paths_;
  std::vector<std::uint64_t> values_;
  std::size_t next_ = 0;  // where the coming field is expected: visits repeat their order
};

// Digest of bytes, in four lanes for speed. A single change in a word always changes it.
std::uint64_t fastHash(const void* data, std::size_t bytes, std::uint64_t start = 0);

}  // namespace resect
