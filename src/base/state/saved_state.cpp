#include "base/state/saved_state.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "base/error.h"
#include "base/state/state_hash.h"

namespace resect {
namespace {

constexpr std::string_view kMagic = "resect-state";
constexpr std::size_t kMostBytes = std::size_t(1) << 31;  // of all numbers, unpacked
constexpr int kMostDepth = 16;
constexpr std::size_t kMostFields = 256, kLongestName = 64;

constexpr std::size_t kDigestBytes = 8;

std::uint64_t digestOf(std::span<const std::byte> bytes) {
  StateHash hash;
  hash.addBytes(bytes.data(), bytes.size());
  return hash.value();
}

void append(Bytes& to, const StateColumn& column) {
  appendNumber(to, column.name.size());
  for (const char c : column.name) to.push_back(std::byte(c));
  appendNumber(to, std::uint64_t(column.size) << 1 | std::uint64_t(column.isList));
  if (column.isList) {
    appendNumber(to, column.counts.size());
    appendRuns(to, std::as_bytes(std::span(column.counts)), 8);
  }
  if (column.size > 0) {
    appendNumber(to, column.data.size());
    appendRuns(to, column.data, column.size);
  } else {
    appendNumber(to, column.fields.size());
    for (const StateColumn& field : column.fields) append(to, field);
  }
}

StateColumn readColumn(ByteReader& from, std::size_t& bytesLeft, int depth) {
  const auto lengthAtMost = [&](std::size_t most) {
    const std::uint64_t length = from.number();
    if (length > most) throwDamagedState();
    return std::size_t(length);
  };
  const auto taken = [&](std::size_t bytes) {
    bytesLeft -= bytes;
    return bytes;
  };
  StateColumn column;
  if (depth > kMostDepth) throwDamagedState();
  for (const std::byte c : from.bytes(lengthAtMost(kLongestName))) column.name += char(c);
  const std::size_t kind = lengthAtMost(17);
  column.isList = kind & 1;
  column.size = std::uint8_t(kind >> 1);
  if (column.size != 0 && column.size != 1 && column.size != 2 && column.size != 4 &&
      column.size != 8)
    throwDamagedState();
  if (column.isList) {
    Bytes counts;
    from.runs(counts, taken(8 * lengthAtMost(bytesLeft / 8)), 8);
    column.counts.resize(counts.size() / 8);
    if (!counts.empty()) std::memcpy(column.counts.data(), counts.data(), counts.size());
  }
  if (column.size > 0)
    from.runs(column.data, taken(lengthAtMost(bytesLeft)), column.size);
  else
    for (std::size_t n = lengthAtMost(kMostFields); n > 0; --n)
      column.fields.push_back(readColumn(from, bytesLeft, depth + 1));
  return column;
}

// Readable path of number `number` of a column.
std::string pathOf(const StateColumn& column, std::span<const CellOrder> orders,
                   std::size_t number) {
  std::uint64_t entries = 0;
  for (const std::uint64_t count : column.counts) entries += count;
  const std::size_t numbers = column.data.size() / column.size;
  if (entries == 0 || numbers % entries != 0 || orders.size() != column.counts.size())
    return fmt::format(", number {}", number);
  std::uint64_t entry = number / (numbers / entries);
  std::size_t list = 0;
  for (; entry >= column.counts[list]; ++list) entry -= column.counts[list];
  const CellOrder& order = orders[list];
  const std::int64_t i = std::int64_t(entry) - order.front;
  return (orders.size() > 1 ? fmt::format(", list {}", list) : "") +
         fmt::format(", cell ({}, {}, {})", i % order.strideY, i % order.strideZ / order.strideY,
                     i / order.strideZ);
}

std::optional<std::string> difference(const StateColumn& a, const StateColumn& b,
                                      const std::string& path) {
  const std::string here = path.empty() ? a.name : path + "." + a.name;
  if (a.name != b.name) return here + " is another field";
  if (a.counts != b.counts) return here + ", its length";
  if (a.size != b.size || a.fields.size() != b.fields.size()) return here + " is another field";
  if (a.data.size() != b.data.size()) return here + ", its length";
  if (!std::ranges::equal(a.data, b.data)) {
    const auto at = std::size_t(std::ranges::mismatch(a.data, b.data).in1 - a.data.begin());
    return here + pathOf(a, a.orders.empty() ? b.orders : a.orders, at / a.size);
  }
  for (std::size_t i = 0; i < a.fields.size(); ++i)
    if (auto found = difference(a.fields[i], b.fields[i], here)) return found;
  return {};
}

}  // namespace

void throwOtherCount(const char* name, std::size_t here) {
  throw error(
      "the state has another number of {} than the {} there are; restore it into the operation it "
      "was saved from",
      name, here);
}

Bytes toBytes(const SavedState& saved) {
  Bytes bytes;
  for (const char c : kMagic) bytes.push_back(std::byte(c));
  appendNumber(bytes, saved.version);
  appendNumber(bytes, saved.fingerprint);
  append(bytes, saved.root);
  const std::uint64_t digest = digestOf(bytes);
  const auto* end = reinterpret_cast<const std::byte*>(&digest);
  bytes.insert(bytes.end(), end, end + kDigestBytes);
  return bytes;
}

SavedState stateFromBytes(std::span<const std::byte> bytes) {
  if (bytes.size() < kMagic.size() || std::memcmp(bytes.data(), kMagic.data(), kMagic.size()) != 0)
    throw error("these bytes are no saved state; give what Simulation::save() returned");
  if (bytes.size() < kMagic.size() + kDigestBytes) throwDamagedState();
  const std::size_t sealed = bytes.size() - kDigestBytes;
  std::uint64_t digest = 0;
  std::memcpy(&digest, bytes.data() + sealed, kDigestBytes);
  if (digest != digestOf(bytes.first(sealed))) throwDamagedState();
  ByteReader from(bytes.first(sealed).subspan(kMagic.size()));
  SavedState saved;
  saved.version = std::uint32_t(std::min<std::uint64_t>(from.number(), 0xffffffff));
  saved.fingerprint = from.number();
  std::size_t bytesLeft = kMostBytes;
  saved.root = readColumn(from, bytesLeft, 0);
  if (!from.atEnd()) throwDamagedState();
  return saved;
}

std::optional<std::string> firstDifference(const SavedState& a, const SavedState& b) {
  if (a.fingerprint != b.fingerprint) return "what they are states of";
  return difference(a.root, b.root, "");
}

StateColumn& ColumnWriter::field(const char* name) {
  std::vector<StateColumn>& fields = path_.back()->fields;
  std::size_t& next = next_.back();
  if (next >= fields.size() || fields[next].name != name) {
    const auto known = std::ranges::find(fields, name, &StateColumn::name);
    next = std::size_t(known - fields.begin());
    if (known == fields.end()) fields.emplace_back().name = name;
  }
  return fields[next++];
}

void ColumnWriter::numbers(const char* name, void* data, std::size_t count, std::size_t size) {
  StateColumn& column = *name ? field(name) : *path_.back();
  column.size = std::uint8_t(size);
  const auto* from = static_cast<const std::byte*>(data);
  column.data.insert(column.data.end(), from, from + count * size);
}

std::size_t ColumnWriter::enterList(const char* name, std::size_t count) {
  enter(name);
  path_.back()->isList = true;
  path_.back()->counts.push_back(count);
  if (order()) path_.back()->orders.push_back(*order());
  return count;
}

void ColumnWriter::enter(const char* name) {
  StateColumn& column = field(name);
  path_.push_back(&column);
  next_.push_back(0);
}

ColumnReader::ColumnReader(const SavedState& saved)
    : older_(saved.version < kStateVersion), root_(cursorOf(saved.root)), path_{&root_} {}

ColumnReader::Cursor ColumnReader::cursorOf(const StateColumn& column) {
  Cursor cursor;
  cursor.column = &column;
  cursor.fields.reserve(column.fields.size());
  for (const StateColumn& field : column.fields) cursor.fields.push_back(cursorOf(field));
  return cursor;
}

// Null where the state is of an older version that lacks it.
ColumnReader::Cursor* ColumnReader::find(const char* name) {
  Cursor* in = path_.back();
  if (!in) return nullptr;
  const auto is = [&](const Cursor& cursor) { return cursor.column->name == name; };
  if (in->next >= in->fields.size() || !is(in->fields[in->next]))
    in->next = std::size_t(std::ranges::find_if(in->fields, is) - in->fields.begin());
  if (in->next < in->fields.size()) return &in->fields[in->next++];
  if (older_) return nullptr;
  throw error(
      "the state has no \"{}\": it was saved by another version of Resect; open it with that one",
      pathTo(name));
}

// How many more times a field can be visited.
std::size_t ColumnReader::left(const Cursor& cursor) {
  const StateColumn& column = *cursor.column;
  if (column.isList) return column.counts.size() - cursor.lists;
  return entriesLeft(cursor);
}

// For how many more entries a list has all fields: a damaged count then takes no memory.
std::size_t ColumnReader::entriesLeft(const Cursor& list) {
  const StateColumn& column = *list.column;
  if (column.size > 0) return (column.data.size() - list.read) / column.size;
  if (list.fields.empty()) return 0;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const Cursor& field : list.fields) least = std::min(least, left(field));
  return least;
}

void ColumnReader::numbers(const char* name, void* data, std::size_t count, std::size_t size) {
  Cursor* from = *name ? find(name) : path_.back();
  if (!from || count == 0) return;
  const StateColumn& column = *from->column;
  if (column.size != size || (*name && column.isList) ||
      count > (column.data.size() - from->read) / size)
    throw error("the state's \"{}\" holds other numbers than it should; give one as it was saved",
                pathTo(name));
  std::memcpy(data, column.data.data() + from->read, count * size);
  from->read += count * size;
}

std::size_t ColumnReader::enterList(const char* name, std::size_t count) {
  Cursor* from = find(name);
  path_.push_back(from);
  if (!from) return count;
  const StateColumn& column = *from->column;
  if (!column.isList || from->lists == column.counts.size() ||
      column.counts[from->lists] > entriesLeft(*from))
    throw error("the state's \"{}\" is no list as it should be; give one as it was saved",
                pathTo(""));
  return std::size_t(column.counts[from->lists++]);
}

void ColumnReader::enter(const char* name) {
  Cursor* from = find(name);
  if (from && from->column->size != 0) throwDamagedState();
  path_.push_back(from);
}

std::string ColumnReader::pathTo(const char* name) const {
  std::string path;
  for (std::size_t i = 1; i < path_.size(); ++i)
    path += (i > 1 ? "." : "") + (path_[i] ? path_[i]->column->name : std::string("?"));
  if (*name) path += (path.empty() ? "" : ".") + std::string(name);
  return path;
}

void ColumnReader::finish() const { finish(root_, ""); }

void ColumnReader::finish(const Cursor& cursor, const std::string& path) const {
  const StateColumn& column = *cursor.column;
  if (cursor.read != column.data.size() || cursor.lists != column.counts.size())
    throw error(
        "the state's \"{}\" is not known here: it was saved by another version of Resect; open it "
        "with that one",
        path);
  for (const Cursor& field : cursor.fields)
    finish(field, (path.empty() ? "" : path + ".") + field.column->name);
}

}  // namespace resect
