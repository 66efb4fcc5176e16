#include "formats/vtk_file.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cstring>
#include <optional>

#include "base/error.h"
#include "base/text/shown_text.h"
#include "geometry/polygon.h"

namespace resect {
namespace {

constexpr std::string_view kMagic = "# vtk DataFile Version";

// Bytes per number of a VTK type name; 0 if unsupported.
struct NumberType {
  int bytes = 0;
  bool isFloat = false, isSigned = true;
};

NumberType numberType(std::string_view name) {
  if (name == "float") return {4, true};
  if (name == "double") return {8, true};
  if (name == "char") return {1, false};
  if (name == "unsigned_char") return {1, false, false};
  if (name == "short") return {2, false};
  if (name == "unsigned_short") return {2, false, false};
  if (name == "int") return {4, false};
  if (name == "unsigned_int") return {4, false, false};
  if (name == "long" || name == "vtktypeint64" || name == "vtkIdType") return {8, false};
  if (name == "unsigned_long") return {8, false, false};
  return {};
}

class VtkReader {
 public:
  VtkReader(const std::string& path, std::string_view bytes) : path_(path), bytes_(bytes) {}

  TriangleMesh read() {
    readHeader();
    for (std::string section = word(); !section.empty(); section = word()) {
      section_ = shortened(section);
      if (section == "POINTS") {
        readPoints();
      } else if (section == "POLYGONS" || section == "TRIANGLE_STRIPS" || section == "LINES" ||
                 section == "VERTICES") {
        readCells(section);
      } else if (section == "METADATA") {
        skipMetadata();
      } else if (section == "FIELD") {
        skipField();
      } else if (section == "POINT_DATA" || section == "CELL_DATA") {
        break;  // attributes come last
      } else {
        throw fail("is unknown");
      }
    }
    section_ = "POINTS";
    if (!havePoints_) throw fail("is missing");
    return std::move(mesh_);
  }

 private:
  template <typename... Args>
  Error fail(fmt::format_string<Args...> format, Args&&... args) const {
    return error("{}{}: section {} {}; export the file again as legacy VTK PolyData", path_,
                 lineNumber(), section_, fmt::format(format, std::forward<Args>(args)...));
  }
  // Of what was read last, as ":12"; a binary file has lines in its header only.
  std::string lineNumber() const {
    if (binary_) return "";
    const std::string_view read = bytes_.substr(0, read_);
    return fmt::format(":{}", 1 + std::ranges::count(read, '\n'));
  }
  static std::string shortened(std::string_view text) { return shownText(text, 30); }

  std::string_view line() {
    read_ = at_;
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    std::string_view text = bytes_.substr(at_, end - at_);
    at_ = std::min(end + 1, bytes_.size());
    if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
    return text;
  }
  static bool isSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  std::string_view token() {
    while (at_ < bytes_.size() && isSpace(bytes_[at_])) ++at_;
    const std::size_t begin = read_ = at_;
    while (at_ < bytes_.size() && !isSpace(bytes_[at_])) ++at_;
    return bytes_.substr(begin, at_ - begin);
  }
  std::string word() { return std::string(token()); }

  std::int64_t count(const char* what) {
    const std::string_view text = token();
    std::int64_t value = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc() || end != text.data() + text.size())
      throw fail("has '{}' where the number of {} should be", shortened(text), what);
    if (value < 0) throw fail("has {} {}", value, what);
    return value;
  }

  void readHeader() {
    section_ = "header";
    if (!isVtkFile(bytes_)) throw fail("does not begin with '{}'", kMagic);
    line();
    line();  // title
    const std::string form = word();
    if (form != "ASCII" && form != "BINARY")
      throw fail("says '{}' instead of ASCII or BINARY", shortened(form));
    binary_ = form == "BINARY";
    if (word() != "DATASET") throw fail("names no DATASET");
    const std::string kind = word();
    if (kind != "POLYDATA")
      throw error("{}{}: holds {} and not a surface; extract the surface and save it as POLYDATA",
                  path_, lineNumber(), shortened(kind));
  }

  // `count` numbers of that type as doubles or integers.
  template <typename T>
  std::vector<T> numbers(std::int64_t count, const NumberType& type) {
    const std::size_t left = bytes_.size() - at_;
    // Each number needs its bytes, or one digit and a space.
    const std::size_t need = binary_ ? std::size_t(type.bytes) : 2;
    if (std::uint64_t(count) > (left + 1) / need)
      throw fail("needs {} numbers, but the file ends before", count);
    std::vector<T> values;
    values.resize(std::size_t(count));
    if (binary_) {
      line();  // the rest of the line that names the section
      if (std::uint64_t(count) > (bytes_.size() - at_) / need)
        throw fail("needs {} numbers, but the file ends before", count);
      for (T& value : values) value = bigEndian<T>(type);
    } else {
      for (T& value : values) {
        const std::string_view text = token();
        const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (status != std::errc() || end != text.data() + text.size()) {
          if (text.empty()) throw fail("needs {} numbers, but the file ends before", count);
          throw fail("has '{}' where a number should be", shortened(text));
        }
      }
    }
    return values;
  }

  template <typename T>
  T bigEndian(const NumberType& type) {
    std::uint64_t raw = 0;
    for (int i = 0; i < type.bytes; ++i) raw = raw << 8 | std::uint8_t(bytes_[at_++]);
    if (type.isFloat)
      return type.bytes == 4 ? T(std::bit_cast<float>(std::uint32_t(raw)))
                             : T(std::bit_cast<double>(raw));
    if (!type.isSigned) return T(raw);
    const int unused = 64 - 8 * type.bytes;
    return T(std::int64_t(raw << unused) >> unused);
  }

  void readPoints() {
    const std::int64_t points = count("points");
    const std::string name = word();
    const NumberType type = numberType(name);
    if (type.bytes == 0) throw fail("has numbers of unknown type '{}'", shortened(name));
    if (points > std::numeric_limits<std::int32_t>::max() / 3) throw fail("has {} points", points);
    const std::vector<double> values = numbers<double>(3 * points, type);
    mesh_.points.clear();
    for (std::size_t i = 0; i + 2 < values.size(); i += 3)
      mesh_.points.emplace_back(values[i], values[i + 1], values[i + 2]);
    havePoints_ = true;
  }

  void readCells(const std::string& section) {
    const std::int64_t cells = count("cells");
    const std::int64_t size = count("numbers");
    const std::size_t afterCounts = at_;
    std::vector<std::int64_t> offsets, corners;
    if (word() == "OFFSETS") {  // since 5.1: `cells` is one more than there are
      offsets = numbers<std::int64_t>(cells, integerType());
      if (word() != "CONNECTIVITY") throw fail("has OFFSETS without CONNECTIVITY");
      corners = numbers<std::int64_t>(size, integerType());
      for (std::size_t i = 0; i < offsets.size(); ++i)
        if (offsets[i] < (i ? offsets[i - 1] : 0) || offsets[i] > size)
          throw fail("has the offset {} out of order", offsets[i]);
    } else {
      at_ = afterCounts;
      const std::vector<std::int64_t> packed = numbers<std::int64_t>(size, {4, false});
      offsets.push_back(0);
      std::size_t i = 0;
      for (std::int64_t cell = 0; cell < cells; ++cell) {
        if (i >= packed.size()) throw fail("has {} cells but numbers for only {}", cells, cell);
        const std::int64_t n = packed[i++];
        if (n < 0 || std::uint64_t(n) > packed.size() - i)
          throw fail("has a cell of {} corners, more than there are numbers", n);
        corners.insert(corners.end(), packed.begin() + std::ptrdiff_t(i),
                       packed.begin() + std::ptrdiff_t(i) + n);
        i += std::size_t(n);
        offsets.push_back(std::int64_t(corners.size()));
      }
      if (i != packed.size()) throw fail("has {} numbers too many", packed.size() - i);
    }
    if (section == "POLYGONS" || section == "TRIANGLE_STRIPS")
      addCells(offsets, corners, section == "TRIANGLE_STRIPS");
  }

  NumberType integerType() {
    const std::string name = word();
    const NumberType type = numberType(name);
    if (type.bytes == 0 || type.isFloat)
      throw fail("has numbers of unusable type '{}'", shortened(name));
    return type;
  }

  void addCells(const std::vector<std::int64_t>& offsets, const std::vector<std::int64_t>& corners,
                bool strips) {
    const auto points = std::int64_t(mesh_.points.size());
    std::vector<std::int32_t> loop;
    for (const std::int64_t corner : corners)
      if (corner < 0 || corner >= points)
        throw fail("uses point {} of only {}{}", corner, points,
                   havePoints_ ? "" : " (POINTS must come before)");
    for (std::size_t i = 0; i + 1 < offsets.size(); ++i) {
      loop.assign(corners.begin() + offsets[i], corners.begin() + offsets[i + 1]);
      if (!strips) {
        triangulatePolygon(mesh_.points, loop, mesh_.triangles);
        continue;
      }
      for (std::size_t k = 0; k + 2 < loop.size(); ++k)
        mesh_.triangles.push_back(k % 2 == 0 ? Triangle{loop[k], loop[k + 1], loop[k + 2]}
                                             : Triangle{loop[k + 1], loop[k], loop[k + 2]});
    }
  }

  // Ends at an empty line.
  void skipMetadata() {
    line();
    while (at_ < bytes_.size() && !line().empty()) {
    }
  }

  void skipField() {
    word();  // name
    const std::int64_t arrays = count("arrays");
    for (std::int64_t i = 0; i < arrays; ++i) {
      std::string name = word();
      if (name == "METADATA") {  // follows the array before
        skipMetadata();
        name = word();
      }
      if (name.empty()) throw fail("has fewer arrays than it says");
      const std::int64_t components = count("components"), tuples = count("tuples");
      const std::string typeName = word();
      const NumberType type = numberType(typeName);
      if (type.bytes == 0) throw fail("has an array of unknown type '{}'", shortened(typeName));
      if (components > 0 && tuples > std::int64_t(bytes_.size()) / components)
        throw fail("has an array longer than the file");
      numbers<double>(components * tuples, type);
    }
  }

  const std::string& path_;
  std::string_view bytes_;
  std::size_t at_ = 0, read_ = 0;  // the next byte; the first of what was read last
  std::string section_ = "header";
  bool binary_ = false, havePoints_ = false;
  TriangleMesh mesh_;
};

}  // namespace

bool isVtkFile(std::string_view bytes) { return bytes.starts_with(kMagic); }

Model readVtkFile(const std::string& path, std::string_view bytes) {
  Model model;
  model.path = path;
  model.format = "VTK legacy PolyData";
  addToPart(model, "", VtkReader(path, bytes).read());
  return model;
}

}  // namespace resect
