// A state as columns, for saving, loading and comparing.
//
// Each named field of a struct has one column. A state may hold several structs of one type, such
// as a list of organs. Then the column holds the field's value in the first struct, followed by its
// value in the second struct, and so on.
//
// Columns are found by name. So a state that an older version of the program saved can still be
// read after a struct gained fields or changed the order of its fields. Two states are compared
// field by field.
//
// The format has these parts, in this order:
// - the text "resect-state",
// - the version,
// - a fingerprint of the operation that the state belongs to,
// - the columns; a column comes immediately before the columns of its own fields,
// - a digest of all bytes before the digest (base/state/state_hash.h). If the digest does not match
//   these bytes, the state is refused as truncated or damaged.
// Numbers are packed by base/state/run_length.h in the byte order of the processor (little endian
// on all machines that Resect runs on).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/state/run_length.h"
#include "base/state/state_visitor.h"

namespace resect {

// The column of one field. The field consists of numbers, or it is a struct with fields of its own.
// In both cases the field may be a list.
struct StateColumn {
  std::string name;
  std::uint8_t size = 0;  // bytes per number; 0: a struct
  // Only for a list. A list may occur in several structs. counts: the length of the list in each of
  // these structs, in the order in which the structs were visited.
  std::vector<std::uint64_t> counts;
  bool isList = false;
  Bytes data;                       // the numbers; empty for a struct
  std::vector<StateColumn> fields;  // the columns of a struct's fields; else empty
  // Only for a list with one entry per cell. A CellOrder says how the coordinates of cells map to
  // positions in the list. There is one CellOrder for each entry of `counts`. The orders are not
  // saved.
  std::vector<CellOrder> orders;
};

inline constexpr std::uint32_t kStateVersion = 7;

struct SavedState {
  std::uint32_t version = kStateVersion;
  std::uint64_t fingerprint = 0;  // of the operation that the state belongs to
  StateColumn root;
};

template <typename State>
SavedState saveState(const State& state, std::uint64_t fingerprint);
Bytes toBytes(const SavedState& saved);
// Throws Error if the bytes are not a saved state, or are truncated or damaged.
SavedState stateFromBytes(std::span<const std::byte> bytes);

// Overwrites the fields of `state`. If `saved` lacks a field of `state`, the effect depends on the
// version of `saved`. If the version is kStateVersion, loadState() throws an Error that names the
// field. If the version is older, the field of `state` keeps its value. If `saved` has a field that
// `state` does not have, loadState() throws an Error that names the field, for every version. The
// caller must check whether the values make sense.
template <typename State>
void loadState(State& state, const SavedState& saved);

// The name of the first field in which two states differ; no value if the states are equal. If the
// field is a list with one entry per cell, the cell is named too: "organs.tissue.u.1, cell (12, 3,
// 40)". If this list occurs in several structs (for example in several organs), the field is
// followed by the number of the list, counted from 0: "organs.tissue.u.1, list 0, cell (12, 3,
// 40)". If both states were made by stateFromBytes(), the cells are not known. Then the field is
// followed by the position of the value in the field's column, counted from 0: "organs.tissue.u.1,
// number 4711".
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
  std::vector<StateColumn*> path_;    // columns from the root to the one being visited
  std::vector<std::size_t> next_{0};  // per entry of path_: index of the field expected next
};

class ColumnReader final : public StateVisitor {
 public:
  explicit ColumnReader(const SavedState& saved);
  // To be called after all fields were visited. Throws Error if a column was not read to its end.
  void finish() const;

 protected:
  void numbers(const char* name, void* data, std::size_t count, std::size_t size) override;
  std::size_t enterList(const char* name, std::size_t count) override;
  void enter(const char* name) override;
  void leave() override { path_.pop_back(); }

 private:
  struct Cursor {
    const StateColumn* column = nullptr;
    // read: number of bytes of column->data read so far. lists: number of entries of column->counts
    // read so far.
    std::size_t read = 0, lists = 0;
    std::size_t next = 0;  // index in `fields` of the field expected next
    std::vector<Cursor> fields;
  };
  Cursor* find(const char* name);
  std::string pathTo(const char* name) const;
  static std::size_t left(const Cursor& cursor);
  static std::size_t entriesLeft(const Cursor& list);
  static Cursor cursorOf(const StateColumn& column);
  void finish(const Cursor& cursor, const std::string& path) const;

  const bool older_;  // the saved state is of an older version than kStateVersion
  Cursor root_;
  // The columns from the root to the struct or list being visited. Null: the saved state is older
  // and lacks this struct or list.
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
