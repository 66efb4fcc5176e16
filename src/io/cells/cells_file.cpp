#include "io/cells/cells_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>

#include "base/crc32.h"
#include "base/error.h"
#include "io/cells/byte_runs.h"
#include "io/output/atomic_file.h"
#include "io/scenario/toml_table.h"
#include "io/vessels_file.h"
#include "io/whole_file.h"
#include "organ/discretize.h"

namespace resect {
namespace {

constexpr std::string_view kFirstLine = "resect-cells 1\n";
constexpr std::string_view kHeaderEnd = "\n---\n";
constexpr std::string_view kChecksum = "\ncrc32 ";
constexpr std::size_t kTrailer = 7 + 8 + 1;      // "\ncrc32 0123abcd\n"
constexpr std::size_t kLongestHeader = 1 << 20;  // bytes
constexpr std::size_t kMostPerCell = 3 * 1 + 6;  // bytes, if each cell is a run of its own
constexpr int kMostBytes = 2'000'000'000;        // of a block
constexpr double kFarthestCell = 1e6;            // m
constexpr int kLongestSide = 1'000'000;          // cells
constexpr double kLargestScale = 1e6;            // of the skin

std::string checksum(std::string_view bytes) { return fmt::format("{:08x}", crc32(bytes)); }

// With the fewest digits that restore it exactly, and never as a TOML integer.
std::string exact(double number) {
  char digits[40];
  std::string text(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
  if (text.find_first_of(".e") == text.npos) text += ".0";
  return text;
}

std::string exact(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", exact(v.x()), exact(v.y()), exact(v.z()));
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      (result += '\\') += c;
    else if (std::uint8_t(c) < 32 || c == 127)
      result += fmt::format("\\u{:04x}", std::uint8_t(c));
    else
      result += c;
  }
  return result + '"';
}

bool isPlain(const Lattice& lattice) {
  return (lattice.dims.array() >= 1).all() && lattice.dims.maxCoeff() < kLongestSide &&
         lattice.dims.cast<double>().prod() <= double(kMaxCells) && lattice.origin.allFinite() &&
         lattice.origin.cwiseAbs().maxCoeff() < kFarthestCell && lattice.spacing.allFinite() &&
         (lattice.spacing.array() > 0).all() && lattice.spacing.maxCoeff() < kFarthestCell;
}

std::string header(const KeptCells& kept, const std::string (&blocks)[4]) {
  const Discretization& d = kept.cells;
  std::string text(kFirstLine);
  text += fmt::format("program = {}\nsource = {}\nunit = {}\n", quoted(kept.origin.program),
                      quoted(kept.origin.source), exact(kept.origin.unit));
  text += fmt::format("dims = [{}, {}, {}]\norigin = {}\nspacing = {}\n", d.lattice.dims.x(),
                      d.lattice.dims.y(), d.lattice.dims.z(), exact(d.lattice.origin),
                      exact(d.lattice.spacing));
  text += fmt::format("skin_scale = {}\nparticles = {}\nvalues = \"{}\"\n", exact(d.skinScale),
                      d.particleCount(), d.value.areLevels() ? "levels" : "numbers");
  text += fmt::format("inside_bytes = {}\nvalue_bytes = {}\nlabel_bytes = {}\n", blocks[0].size(),
                      blocks[1].size(), blocks[2].size());
  if (!blocks[3].empty()) text += fmt::format("vessel_bytes = {}\n", blocks[3].size());
  for (std::size_t i = 0; i < d.labelNames.size(); ++i)
    if (!d.labelNames[i].empty())
      text += fmt::format("[[label]]\nnumber = {}\nname = {}\n", i, quoted(d.labelNames[i]));
  for (const Landmark& landmark : d.landmarks)
    text += fmt::format("[[landmark]]\nname = {}\nplace = {}\n", quoted(landmark.name),
                        exact(landmark.place));
  for (const CellsInput& input : kept.origin.inputs)
    text += fmt::format("[[input]]\nfile = {}\nrole = {}\nformat = {}\ncrc32 = {}\n",
                        quoted(input.file), quoted(input.role), quoted(input.format),
                        quoted(input.crc32));
  text.pop_back();
  return text += kHeaderEnd;
}

// The header as a table whose Errors have the file's line numbers.
TomlTable headerTable(std::string_view text, const std::string& name) {
  std::string comment = "#";
  comment += text;
  return TomlTable::parse(comment, name);
}

Lattice readLattice(const TomlTable& t) {
  Lattice lattice;
  const Vec3 dims = t.vec3("dims");
  for (int a = 0; a < 3; ++a)
    if (!(dims[a] >= 1 && dims[a] < kLongestSide) || dims[a] != std::floor(dims[a]))
      t.complain("dims", fmt::format("is not three whole numbers from 1 to {}", kLongestSide - 1));
  if (dims.prod() > double(kMaxCells))
    t.complain("dims", fmt::format("are more than {} cells", kMaxCells));
  lattice.dims = dims.cast<int>();
  lattice.origin = t.vec3("origin");
  lattice.spacing = t.vec3("spacing");
  if (!(lattice.spacing.array() > 0).all()) t.complain("spacing", "is not above 0 on each axis");
  return lattice;
}

void readInputs(const TomlTable& t, std::vector<CellsInput>& inputs) {
  for (const TomlTable& input : t.tables("input")) {
    inputs.push_back({input.freeText("file"), input.freeText("role"), input.freeText("format"),
                      input.freeText("crc32")});
    input.refuseUnknownKeys();
  }
}

void readNames(const TomlTable& t, Discretization& d) {
  for (const TomlTable& label : t.tables("label")) {
    const int number = label.integer("number", 0, 255);
    if (std::size_t(number) < d.labelNames.size() && !d.labelNames[std::size_t(number)].empty())
      label.complain("number", "has a name already");
    d.nameLabel(number, label.text("name"));
    label.refuseUnknownKeys();
  }
  for (const TomlTable& landmark : t.tables("landmark")) {
    d.landmarks.push_back({landmark.text("name"), landmark.vec3("place")});
    landmark.refuseUnknownKeys();
  }
}

// The values of one block; the number of values is checked before memory is allocated.
template <typename Array>
Array unpack(std::string_view bytes, std::int64_t cells, const char* what,
             const std::string& name) {
  using Value = typename Array::value_type;
  const std::int64_t count = countInRuns(bytes, sizeof(Value));
  if (count != cells)
    throw error("{}: its {} are {} and its cells {}; write the file anew", name, what,
                count < 0 ? "no whole runs" : fmt::format("{}", count), cells);
  Array values(static_cast<std::size_t>(cells));
  fromRuns(bytes, std::span<Value>(values));
  return values;
}

template <typename Values, typename Good>
void checkAll(const Values& values, Good good, const char* what, const std::string& name) {
  const auto bad = std::find_if_not(values.begin(), values.end(), good);
  if (bad != values.end())
    throw error("{}: cell {} has {}; write the file anew", name, bad - values.begin(), what);
}

}  // namespace

std::string formatCells(const KeptCells& kept) {
  const Discretization& d = kept.cells;
  if (!isPlain(d.lattice))
    throw error("cells cannot be kept: there must be 1 to {} of them within {} km", kMaxCells,
                kFarthestCell / 1000);
  const std::string blocks[4] = {
      toRuns(d.inside), d.value.areLevels() ? toRuns(d.value.levels()) : toRuns(d.value.numbers()),
      toRuns(d.label), kept.vessels.segments.empty() ? "" : formatVessels(kept.vessels)};
  std::string bytes = header(kept, blocks);
  try {
    headerTable(std::string_view(bytes).substr(0, bytes.size() - kHeaderEnd.size()), "header");
  } catch (const Error&) {
    throw error("cells cannot be kept: a name of a label, a landmark or a file is not UTF-8");
  }
  if (bytes.size() > kLongestHeader)
    throw error("cells cannot be kept: names of labels and landmarks are longer than {} kB",
                kLongestHeader >> 10);
  for (const std::string& block : blocks) bytes += block;
  const std::string sum = checksum(bytes);
  return bytes.append(kChecksum).append(sum).append("\n");
}

KeptCells parseCells(std::string_view bytes, const std::string& name) {
  if (!bytes.starts_with(kFirstLine)) {
    if (bytes.starts_with("resect-cells "))
      throw error("{}: it is of a later version of the format than this program reads", name);
    throw error("{}: it does not begin with \"resect-cells 1\", so it holds no cells of an organ",
                name);
  }
  if (bytes.size() < kFirstLine.size() + kTrailer ||
      bytes.substr(bytes.size() - kTrailer, kChecksum.size()) != kChecksum || bytes.back() != '\n')
    throw error("{}: its last line is no checksum; it is cut off, copy the file again", name);
  const std::string_view sum = bytes.substr(bytes.size() - 9, 8);
  bytes.remove_suffix(kTrailer);
  if (sum != checksum(bytes))
    throw error("{}: its checksum does not fit; it is damaged or was edited, copy the file again",
                name);

  const std::size_t end = bytes.substr(0, kLongestHeader).find(kHeaderEnd);
  if (end == bytes.npos)
    throw error("{}: its header does not end in a line \"---\"; write the file anew", name);
  const TomlTable t = headerTable(bytes.substr(0, end), name);
  bytes.remove_prefix(end + kHeaderEnd.size());

  KeptCells kept;
  Discretization& d = kept.cells;
  kept.origin = {t.freeText("program"), t.freeText("source"), t.number("unit", 1e-12, 1e12, 1)};
  d.lattice = readLattice(t);
  d.skinScale = t.number("skin_scale", 0, kLargestScale);
  const int particles = t.integer("particles", 0, int(kMaxCells));
  const std::string values = t.text("values");
  if (values != "levels" && values != "numbers")
    t.complain("values", "are neither \"levels\" nor \"numbers\"");
  std::string_view block[4];
  std::size_t at = 0;
  const char* keys[4] = {"inside_bytes", "value_bytes", "label_bytes", "vessel_bytes"};
  for (int i = 0; i < 4; ++i) {
    const auto size = std::size_t(i == 3 ? t.integer(keys[i], 0, kMostBytes, 0)
                                         : t.integer(keys[i], 0, kMostBytes));
    if (size > bytes.size() - at)
      t.complain(keys[i], fmt::format("is {}, and {} bytes are left", size, bytes.size() - at));
    block[i] = bytes.substr(at, size);
    at += size;
  }
  if (at != bytes.size())
    throw error("{}: {} bytes more than its header says; write the file anew", name,
                bytes.size() - at);
  readNames(t, d);
  readInputs(t, kept.origin.inputs);
  t.refuseUnknownKeys();

  const std::int64_t cells = d.lattice.cellCount();
  d.inside = unpack<std::vector<std::uint8_t>>(block[0], cells, "particle flags", name);
  checkAll(
      d.inside, [](std::uint8_t flag) { return flag <= 1; }, "a flag that is not 0 or 1", name);
  if (d.particleCount() != particles)
    throw error("{}: it has {} particles and its header says {}; write the file anew", name,
                d.particleCount(), particles);
  if (values == "levels") {
    auto levels = unpack<RawArray<std::uint8_t>>(block[1], cells, "values", name);
    checkAll(
        levels, [](std::uint8_t level) { return level <= kFullLevel; },
        "more than 128 levels of tissue", name);
    d.value = ColourValues(std::move(levels));
  } else {
    auto numbers = unpack<RawArray<float>>(block[1], cells, "values", name);
    checkAll(
        numbers, [](float value) { return value >= 0 && value <= 100; },
        "a value that is not from 0 to 100", name);
    d.value = ColourValues(std::move(numbers));
  }
  if (!block[2].empty())
    d.label = unpack<std::vector<std::uint8_t>>(block[2], cells, "labels", name);
  if (!block[3].empty()) kept.vessels = parseVessels(std::string(block[3]), name);
  return kept;
}

KeptCells readCells(const std::filesystem::path& path) {
  std::error_code fault;
  const auto size = std::filesystem::file_size(path, fault);
  if (!fault && size > kMostPerCell * std::size_t(kMaxCells) + kLongestHeader)
    throw error("{} is larger than {} cells can be; it holds no cells of an organ", path.string(),
                kMaxCells);
  return parseCells(readWholeFile(path), path.string());
}

void writeCells(const std::filesystem::path& path, const KeptCells& kept) {
  const std::string bytes = formatCells(kept);
  writeFileAtomically(path, [&](std::ostream& out) { out << bytes; });
}

}  // namespace resect
