#include "io/cells/discretization_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <vector>

#include "base/error.h"
#include "base/stop.h"
#include "base/text/shown_text.h"
#include "io/output/atomic_file.h"
#include "io/whole_file.h"
#include "organ/discretize.h"
#include "sph/lattice_extent.h"

namespace resect {
namespace {

constexpr double kLargestOffset = 0.02;    // of a cell: tolerance for rounded positions
constexpr double kFarthestParticle = 1e9;  // m

std::vector<std::string_view> splitWords(std::string_view line) {
  constexpr std::string_view kBlank = " \t\r";
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(kBlank); at != line.npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlank, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kBlank, end);
  }
  return words;
}

// The text line by line; every Error names its line.
class Lines {
 public:
  // Lines end in \n, as a rule after \r; in old files of the Macintosh in \r alone.
  Lines(std::string_view text, const std::string& name)
      : rest_(text), name_(name), end_(text.find('\n') == text.npos ? '\r' : '\n') {}

  // False at the end of the text.
  bool next() {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find(end_);
    words_ = splitWords(rest_.substr(0, end));
    rest_.remove_prefix(end == rest_.npos ? rest_.size() : end + 1);
    ++number_;
    return true;
  }
  int number() const { return number_; }
  const std::vector<std::string_view>& words() const { return words_; }

  template <typename... Args>
  [[nodiscard]] Error complaint(fmt::format_string<Args...> format, Args&&... args) const {
    return complaintAt(number_, format, std::forward<Args>(args)...);
  }
  template <typename... Args>
  [[nodiscard]] Error complaintAt(int line, fmt::format_string<Args...> format,
                                  Args&&... args) const {
    return error("{}:{}: {}", name_, line, fmt::format(format, std::forward<Args>(args)...));
  }

  // The numbers after the words of `key`, with which the next line must begin.
  std::vector<std::string_view> expect(std::string_view key, std::size_t count) {
    if (!next()) {
      ++number_;
      throw complaint("the file ends where \"{}\" should stand; it is cut off", key);
    }
    const std::vector<std::string_view> keyWords = splitWords(key);
    if (words_.size() < keyWords.size() ||
        !std::equal(keyWords.begin(), keyWords.end(), words_.begin()))
      throw complaint("\"{}\" should stand here; this is no discretisation file as it should be",
                      key);
    if (words_.size() != keyWords.size() + count)
      throw complaint("{} numbers should follow \"{}\", not {}", count, key,
                      words_.size() - keyWords.size());
    return {words_.begin() + std::ptrdiff_t(keyWords.size()), words_.end()};
  }

  template <typename Number>
  Number number(std::string_view word) const {
    Number value{};
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (fault == std::errc::result_out_of_range && end == word.data() + word.size())
      throw complaint("{} is too large or too small a number", shown(word));
    if (fault != std::errc() || end != word.data() + word.size())
      throw complaint("\"{}\" is not {} number", shown(word),
                      std::is_integral_v<Number> ? "a whole" : "a");
    if constexpr (std::is_floating_point_v<Number>)
      if (!std::isfinite(value)) throw complaint("\"{}\" is not a finite number", shown(word));
    return value;
  }

  // Text of the file, shortened for messages.
  static std::string shown(std::string_view word) { return shownText(word, 24); }

 private:
  std::string_view rest_;
  const std::string& name_;
  char end_;
  std::vector<std::string_view> words_;
  int number_ = 0;
};

struct Row {
  Vec3 position;
  float value;
};

// One interpretation of the corners, tested row by row as long as it fits.
struct Grid {
  Lattice lattice;
  double largestOffset = 0;  // of a cell, over all rows
  int misfit = -1;           // first row that does not fit

  Vec3i cellOf(const Vec3& position) const {
    return lattice.toCellSpace(position).array().round().cast<int>();
  }
  void follow(const Vec3& position, int row) {
    if (misfit >= 0) return;
    const Vec3 cell = lattice.toCellSpace(position);
    const Vec3 nearest = cell.array().round();
    const double offset = (cell - nearest).cwiseAbs().maxCoeff();
    const bool within = (nearest.array() >= 0).all() &&
                        (nearest.array() < lattice.dims.cast<double>().array()).all();
    if (!within || !(offset <= kLargestOffset)) misfit = row;
    largestOffset = std::max(largestOffset, offset);
  }
};

Grid cubicGrid(const Vec3& first, const Vec3& last, const Vec3i& dims) {
  int axis = 0;
  (last - first).maxCoeff(&axis);
  const Vec3 spacing = spacingBetween(Vec3::Constant(first[axis]), Vec3::Constant(last[axis]),
                                      Vec3i::Constant(dims[axis]));
  return {{first, spacing, dims}};
}

void appendNumber(std::string& text, auto number) {
  char digits[40];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
}

}  // namespace

Discretization parseDiscretization(std::string_view text, const std::string& name, double unit) {
  if (!(unit > 0) || !std::isfinite(unit))
    throw usageError("the unit of {} must be a length above zero, not {} m", name, unit);
  Lines lines(text, name);
  lines.expect("Discretization:", 0);
  const auto rowCount = lines.number<std::int64_t>(lines.expect("number of particles:", 1)[0]);
  if (rowCount < 0 || rowCount > kMaxCells)
    throw lines.complaint("the number of particles must be 0 to {}, not {}", kMaxCells, rowCount);
  const auto insideCount =
      lines.number<std::int64_t>(lines.expect("number of particles inside the object:", 1)[0]);
  if (insideCount < 0 || insideCount > rowCount)
    throw lines.complaint("of {} particles {} cannot be inside the object", rowCount, insideCount);

  const auto dimWords = lines.expect("boundingbox dimensions:", 3);
  Vec3i dims;
  for (int a = 0; a < 3; ++a) {
    dims[a] = lines.number<std::int32_t>(dimWords[a]);
    if (dims[a] < 1) throw lines.complaint("a grid cannot have {} samples on an axis", dims[a]);
  }
  const double cells = dims.cast<double>().prod();
  if (cells > double(kMaxCells))
    throw lines.complaint("a grid of {:.3g} cells is larger than {}; sample the organ coarser",
                          cells, kMaxCells);
  if (double(rowCount) > cells)
    throw lines.complaint("{} particles do not fit into {} cells", rowCount, std::int64_t(cells));

  const auto corners = lines.expect("boundingbox:", 6);
  Vec3 first, last;
  for (int a = 0; a < 3; ++a) {
    first[a] = lines.number<double>(corners[a]);
    last[a] = lines.number<double>(corners[a + 3]);
    const double spacing = (last[a] - first[a]) / dims[a] * unit;
    if (!(last[a] > first[a]) || !std::isfinite(spacing) || !(spacing > 0))
      throw lines.complaint("the box must have room between {} and {} on each axis", first[a],
                            last[a]);
    if (!(std::max(std::abs(first[a]), std::abs(last[a])) * unit <= kFarthestParticle))
      throw lines.complaint("the box reaches from {:g} to {:g}, farther than {:g} m; check --unit",
                            first[a], last[a], kFarthestParticle);
  }
  lines.expect("particle: x: y: z: LevelSet:", 0);

  Grid perAxis{{first, spacingBetween(first, last, dims), dims}};
  Grid cubic = cubicGrid(first, last, dims);
  const int firstRowLine = lines.number() + 1;
  std::vector<Row> rows;
  // A row has at least ten characters, so a false count reserves no memory.
  rows.reserve(std::min<std::size_t>(rowCount, text.size() / 10));
  std::int64_t positive = 0;
  for (std::int64_t i = 0; i < rowCount; ++i) {
    if (!lines.next() || lines.words().empty())
      throw lines.complaintAt(firstRowLine + int(i),
                              "particle {} is missing; {} were announced in line 2", i, rowCount);
    const auto& words = lines.words();
    if (words.size() != 5)
      throw lines.complaint("a particle's row has 5 numbers (number, x, y, z, LevelSet), not {}",
                            words.size());
    if (lines.number<std::int64_t>(words[0]) != i)
      throw lines.complaint("particle {} should stand here, not {}", i, Lines::shown(words[0]));
    checkStop();
    Row row;
    for (int a = 0; a < 3; ++a) row.position[a] = lines.number<double>(words[a + 1]);
    row.value = lines.number<float>(words[4]);
    if (!(row.value >= 0 && row.value <= 100))
      throw lines.complaint("the LevelSet must be 0 to 100, not {}", row.value);
    perAxis.follow(row.position, int(i));
    cubic.follow(row.position, int(i));
    if (perAxis.misfit >= 0 && cubic.misfit >= 0)
      throw lines.complaint(
          "({:g}, {:g}, {:g}) is no sample of the grid, neither with a spacing of {:g} x {:g} x "
          "{:g} nor with {:g} on all axes",
          row.position.x(), row.position.y(), row.position.z(), perAxis.lattice.spacing.x(),
          perAxis.lattice.spacing.y(), perAxis.lattice.spacing.z(), cubic.lattice.spacing.x());
    positive += row.value > 0;
    rows.push_back(row);
  }
  while (lines.next())
    if (!lines.words().empty())
      throw lines.complaint("nothing should follow the {} particles announced in line 2", rowCount);

  const bool takeCubic =
      perAxis.misfit >= 0 || (cubic.misfit < 0 && cubic.largestOffset < perAxis.largestOffset);
  const Grid& grid = takeCubic ? cubic : perAxis;
  Discretization result;
  result.lattice = grid.lattice;
  result.value = ColourValues(std::size_t(grid.lattice.cellCount()));
  constexpr std::uint8_t kUnlisted = 2;
  result.inside.assign(grid.lattice.cellCount(), kUnlisted);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const int line = firstRowLine + int(i);
    const std::int64_t cell = grid.lattice.index(grid.cellOf(rows[i].position));
    if (result.inside[cell] != kUnlisted)
      throw lines.complaintAt(line, "the sample at ({:g}, {:g}, {:g}) is listed twice",
                              rows[i].position.x(), rows[i].position.y(), rows[i].position.z());
    const bool inside = positive == insideCount ? rows[i].value > 0 : std::int64_t(i) < insideCount;
    if (inside && !(rows[i].value > 0))
      throw lines.complaintAt(
          line, "a particle inside the object needs a LevelSet above 0; line 3 announces {} inside",
          insideCount);
    result.value.set(cell, rows[i].value > 0 ? rows[i].value : 0);
    result.inside[cell] = inside;
  }
  std::replace(result.inside.begin(), result.inside.end(), kUnlisted, std::uint8_t(0));
  result.lattice.origin *= unit;
  result.lattice.spacing *= unit;
  return result;
}

Discretization readDiscretization(const std::filesystem::path& path, double unit) {
  return parseDiscretization(readWholeFile(path), path.string(), unit);
}

std::string formatDiscretization(const Discretization& d) {
  if (!d.lattice.origin.allFinite() || !farCorner(d.lattice).allFinite())
    throw error(
        "cells cannot be written: they lie at a place that is not a number; check unit and poses");
  std::vector<std::int64_t> cells;
  for (std::int64_t c = 0; c < d.lattice.cellCount(); ++c)
    if (d.inside[c] && d.value[c] > 0) cells.push_back(c);
  const std::size_t insideCount = cells.size();
  for (std::int64_t c = 0; c < d.lattice.cellCount(); ++c)
    if (!d.inside[c] && d.value[c] > 0) cells.push_back(c);

  std::string text = fmt::format(
      "Discretization:\nnumber of particles: {}\nnumber of particles inside the object: {}\n"
      "boundingbox dimensions: {} {} {}\nboundingbox:",
      cells.size(), insideCount, d.lattice.dims.x(), d.lattice.dims.y(), d.lattice.dims.z());
  const auto append = [&text](auto number) {
    text += ' ';
    appendNumber(text, number);
  };
  for (const Vec3& corner : {d.lattice.origin, farCorner(d.lattice)})
    for (int a = 0; a < 3; ++a) append(corner[a]);
  text += "\nparticle: x: y: z: LevelSet:\n";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    checkStop();
    appendNumber(text, i);
    const Vec3 centre = d.lattice.centre(d.lattice.cell(cells[i]));
    for (int a = 0; a < 3; ++a) append(centre[a]);
    append(d.value[cells[i]]);
    text += '\n';
  }
  return text;
}

void writeDiscretization(const std::filesystem::path& path, const Discretization& discretization) {
  writeFileAtomically(path, [&](std::ostream& out) {
    const std::string text = formatDiscretization(discretization);
    constexpr std::size_t kBlock = 1 << 20;
    for (std::size_t at = 0; at < text.size(); at += kBlock) {
      checkStop();
      out << std::string_view(text).substr(at, kBlock);
    }
  });
}

}  // namespace resect
