// The columns of five tables of a recording: `branch`, `frames`, `key_states`, `events` and
// `samples`. Writing and reading use the same list of columns.
#pragma once

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "record/file/recording_file.h"

namespace resect {

// A key state as it is stored.
struct StoredKeyState {
  std::int64_t branch = 0, frame = 0;
  std::string hash;       // 16 hexadecimal digits
  std::int64_t size = 0;  // bytes of `state` when it is decompressed
  Bytes state;            // compressed by zstd
};

// Each function columns() is for the rows of one table. It calls v with the name of the table,
// followed by the values of the row, in the order of the table's columns.
template <class Visitor>
void columns(Visitor&& v, Branch& r) {
  v("branch", r.number, r.parent, r.from, r.name);
}
template <class Visitor>
void columns(Visitor&& v, RecordedFrame& r) {
  v("frames", r.branch, r.frame, r.time, r.whole, r.input, r.hashes);
}
template <class Visitor>
void columns(Visitor&& v, StoredKeyState& r) {
  v("key_states", r.branch, r.frame, r.hash, r.size, r.state);
}
template <class Visitor>
void columns(Visitor&& v, OperationEvent& r) {
  v("events", r.branch, r.frame, r.time, r.tool, r.organ, r.kind, r.amount, r.text);
}
template <class Visitor>
void columns(Visitor&& v, RecordedSample& r) {
  v("samples", r.branch, r.frame, r.tool, r.tip[0], r.tip[1], r.tip[2], r.force[0], r.force[1],
    r.force[2]);
}

template <typename T>
void bindColumn(Statement& statement, int column, const T& value) {
  if constexpr (std::is_same_v<T, bool>)
    statement.bind(column, std::int64_t(value));
  else if constexpr (std::is_same_v<T, std::string>)
    statement.bind(column, std::string_view(value));
  else if constexpr (std::is_arithmetic_v<T>)
    statement.bind(column, value);
  else
    statement.bind(column, std::as_bytes(std::span(value)));
}

template <typename T>
void readColumn(const Statement& statement, int column, T& value) {
  if constexpr (std::is_same_v<T, double>) {
    value = statement.real(column);
  } else if constexpr (std::is_same_v<T, std::string>) {
    value = statement.text(column);
  } else if constexpr (std::is_arithmetic_v<T>) {
    value = static_cast<T>(statement.integer(column));
  } else {
    const auto blob = statement.blob(column);
    value.resize(blob.size() / sizeof value[0]);
    if (!value.empty()) std::memcpy(value.data(), blob.data(), value.size() * sizeof value[0]);
  }
}

template <class Row>
Row rowOf(const Statement& statement) {
  Row row;
  columns(
      [&](const char*, auto&... values) {
        int column = 0;
        (readColumn(statement, column++, values), ...);
      },
      row);
  return row;
}

// Runs a statement and returns all rows of the result. The statement must begin with SELECT *, and
// its parameters must be bound.
template <class Row>
std::vector<Row> rowsOf(Statement& statement) {
  std::vector<Row> rows;
  while (statement.step()) rows.push_back(rowOf<Row>(statement));
  return rows;
}

}  // namespace resect
