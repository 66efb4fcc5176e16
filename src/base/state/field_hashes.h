// One digest per named field of a state, cheap enough for every frame.
//
// With the digests two states can be compared field by field, even if the states themselves are not
// kept. For example, a recording holds the digests of each frame. If the digests of a field differ,
// the field differs. A field is named by its path, such as "organs.tissue.u". Fields with the same
// path, such as the displacements of several organs, share a digest. Cost: 0.1 ms per MB of state.
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
  // Starts with the paths of another FieldHashes object, and seals them.
  explicit FieldHashes(std::vector<std::string> paths);

  // Fixes the set of paths, so that the number of digests never changes again. If a list has been
  // empty so far, the paths of the fields in its entries are not known. From now on such a list
  // counts as a single field: one digest covers the list and everything in its later entries.
  void seal();
  // Whether a visited state had a field whose path is not in the sealed set. If so, another version
  // of the program made this state.
  bool strange() const { return strange_; }

  // Paths in the order in which visit() first names them.
  const std::vector<std::string>& paths() const { return paths_; }
  // One digest per path.
  const std::vector<std::uint64_t>& values() const { return values_; }

  // Resets the digests for the next state. The paths are kept, so each field keeps its number.
  void clear();

 protected:
  void numbers(const char* name, void* data, std::size_t count, std::size_t size) override;
  std::size_t enterList(const char* name, std::size_t count) override;
  void enter(const char* name) override;
  void leave() override;

 private:
  std::uint64_t& at(const char* name);

  bool sealed_ = false, strange_ = false;
  std::vector<char> leaf_;  // per path; 1: no other path begins with this path
  // Used inside a list that counts as a single field. inField_: nesting depth inside the list; 0:
  // outside such a list. field_: index of the list's digest in values_.
  std::size_t inField_ = 0, field_ = 0;
  std::uint64_t ignored_ = 0;
  std::string path_;
  std::vector<std::size_t> lengths_;  // length of path_ before each enter()
  std::vector<std::string> paths_;
  std::vector<std::uint64_t> values_;
  std::size_t next_ = 0;  // expected index of the next field; all visits have the same order
};

// Digest of bytes, computed in four lanes for speed. If a single 8-byte word changes, the digest
// always changes.
std::uint64_t fastHash(const void* data, std::size_t bytes, std::uint64_t start = 0);

}  // namespace resect
