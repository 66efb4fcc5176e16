// A state as columns, for saving, loading and comparing. Each named field has one column: its
// values in all structs that have this field, one after the other.
//
// So a state of an older version can be read after structs gained fields or changed their order,
// and a difference is reported by field. The format: "resect-state", the version, a fingerprint of
// the operation that the state belongs to, the columns depth first, and a digest of all these bytes
// (base/state/state_hash.h), by which truncated or damaged bytes are refused. Numbers are packed by
// base/state/run_length.h in the processor's byte order (little endian on all machines that Resect
// runs on).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/state/run_length.h"
#include "base/state/state_visitor.h"

namespace resect {

// A field, or a struct of fields.
struct StateColumn {
  std::string name;
  std::uint8_t size = 0;              // bytes per number; 0: a struct
  std::vector<std::uint64_t> counts;  // of a list: its length at each visit
  bool isList = false;
  Bytes data;  // numbers
  std::vector<StateColumn> fields;
  // Of a list with an entry per cell: the order of its cells at each visit. Not saved.
  std::vector<CellOrder> orders;
};

inline constexpr std::uint32_t kStateVersion = 1;

struct SavedState {
  std::uint32_t version = kStateVersion;
  std::uint64_t fingerprint = 0;  // of the operation that the state belongs to
  StateColumn root;
};

template <typename State>
SavedState saveState(const State& state, std::uint64_t fingerprint);
Bytes toBytes(const SavedState& saved);
// Throws Error if the bytes are no saved state, or are cut off or damaged.
SavedState stateFromBytes(std::span<const std::byte> bytes);

// Overwrites the state's fields. A field that a saved state of an older version lacks keeps its
// value. A saved state of the present version must have exactly the state's fields: an Error names
// the first that is missing or unknown. Whether the values make sense is for the caller to check.
template <typename State>
void loadState(State& state, const SavedState& saved);

// Names the first field in which two states differ, as "organs.tissue.u.1, cell (12, 3, 40)". Where
// several structs have such a list (several organs), the list is numbered: "organs.tissue.u.1, list
// 0, cell (12, 3, 40)". Cells are named unless both states were made from bytes.
std::optional<std::string> firstDifference(const SavedState& a, const SavedState& b);

class ColumnWriter final : public StateVisitor {
 public:
  explicit ColumnWriter(StateColumn& root) : path_{&root} {}

 protected:
  void numbers(const char* name, void* data, std::size_t count, std::size_t size) override;
  std::size_t enterList(const char* name, std::size_t count) override;
  void enter(const char* name) override;
  void leave() override { path_.pop_back(), next_.pop_back(); }

 private:
  StateColumn& field(const char* name);
  std::vector<StateColumn*> path_;
  std::vector<std::size_t> next_{0};  // where in the struct the next field is expected
};

class ColumnReader final : public StateVisitor {
 public:
  explicit ColumnReader(const SavedState& saved);
  // Call it after all fields were visited: throws Error if a column was not read to its end.
  void finish() const;

 protected:
  void numbers(const char* name, void* data, std::size_t count, std::size_t size) override;
  std::size_t enterList(const char* name, std::size_t count) override;
  void enter(const char* name) override;
  void leave() override { path_.pop_back(); }

 private:
  struct Cursor {
    const StateColumn* column = nullptr;  // null: the older state lacks this field
    std::size_t read = 0, lists = 0;      // bytes and counts read so far
    std::size_t next = 0;
    std::vector<Cursor> fields;
  };
  Cursor* find(const char* name);
  std::string pathTo(const char* name) const;
  static std::size_t left(const Cursor& cursor);
  static std::size_t entriesLeft(const Cursor& list);
  static Cursor cursorOf(const StateColumn& column);
  void finish(const Cursor& cursor, const std::string& path) const;

  const bool older_;
  Cursor root_;
  std::vector<Cursor*> path_;
};

template <typename State>
SavedState saveState(const State& state, std::uint64_t fingerprint) {
  SavedState saved{kStateVersion, fingerprint, {}};
  ColumnWriter writer(saved.root);
  visitState(state, writer);
  return saved;
}

template <typename State>
void loadState(State& state, const SavedState& saved) {
  ColumnReader reader(saved);
  state.visit(reader);
  reader.finish();
}

}  // namespace resect
