#include "formats/meshes/vtk_file.h"

#include <bit>
#include <limits>
#include <optional>
#include <type_traits>

#include "base/error.h"
#include "base/text/shown_text.h"
#include "formats/meshes/word_reader.h"
#include "geometry/polygon.h"

namespace resect {
namespace {

constexpr std::string_view kMagic = "# vtk DataFile Version";

// Bytes per number of a VTK type name; 0 if unsupported.
struct NumberType {
  int bytes = 0;
  bool isFloat = false, isSigned = true;
};

NumberType numberType(const std::string& anyCase) {
  const std::string name = lowerCase(anyCase);
  if (name == "float") return {4, true};
  if (name == "double") return {8, true};
  if (name == "char" || name == "signed_char") return {1, false};
  if (name == "unsigned_char") return {1, false, false};
  if (name == "short") return {2, false};
  if (name == "unsigned_short") return {2, false, false};
  if (name == "int") return {4, false};
  if (name == "unsigned_int") return {4, false, false};
  if (name == "long" || name == "long_long" || name == "vtktypeint64" || name == "vtkidtype")
    return {8, false};
  if (name == "unsigned_long" || name == "unsigned_long_long" || name == "vtktypeuint64")
    return {8, false, false};
  return {};
}

class VtkReader {
 public:
  VtkReader(const std::string& path, std::string_view bytes)
      : path_(path), bytes_(bytes), words_(path, bytes) {}

  TriangleMesh read() {
    readHeader();
    for (std::string word = nextWord(); !word.empty(); word = nextWord()) {
      section_ = shortened(word);
      const std::string section = upperCase(word);
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
    return error("{}: section {} {}; export the file again as legacy VTK PolyData", where(),
                 section_, fmt::format(format, std::forward<Args>(args)...));
  }
  // A binary file has lines in its header only.
  std::string where() const { return binary_ ? path_ : words_.where(); }
  static std::string shortened(std::string_view text) { return shownText(text, 30); }
  static std::string upperCase(std::string_view text) {
    std::string upper(text);
    for (char& c : upper)
      if (c >= 'a' && c <= 'z') c = char(c - 'a' + 'A');
    return upper;
  }
  std::string nextWord() { return std::string(words_.word()); }

  std::int64_t count(const char* what) {
    const std::string_view text = words_.word();
    const std::optional<std::int64_t> value = wholeNumberOf(text);
    if (!value) throw fail("has '{}' where the number of {} should be", shortened(text), what);
    if (*value < 0) throw fail("has {} {}", *value, what);
    return *value;
  }

  void readHeader() {
    section_ = "header";
    if (!isVtkFile(bytes_)) throw fail("does not begin with '{}'", kMagic);
    words_.line();
    words_.line();  // title
    const std::string form = upperCase(words_.word());
    if (form != "ASCII" && form != "BINARY")
      throw fail("says '{}' instead of ASCII or BINARY", shortened(form));
    binary_ = form == "BINARY";
    if (upperCase(words_.word()) != "DATASET") throw fail("names no DATASET");
    const std::string kind = upperCase(words_.word());
    if (kind != "POLYDATA")
      throw error("{}: holds {} and not a surface; extract the surface and save it as POLYDATA",
                  where(), shortened(kind));
  }

  // `count` numbers of that type as doubles or integers.
  template <typename T>
  std::vector<T> numbers(std::int64_t count, const NumberType& type) {
    // Each number needs its bytes, or one digit and a space.
    const std::size_t need = binary_ ? std::size_t(type.bytes) : 2;
    if (binary_) words_.line();  // the rest of the line that names the section
    if (std::uint64_t(count) > (words_.left() + (binary_ ? 0 : 1)) / need)
      throw fail("needs {} numbers, but the file ends before", count);
    std::vector<T> values;
    values.resize(std::size_t(count));
    for (T& value : values) {
      if (binary_) {
        value = bigEndian<T>(type);
        continue;
      }
      const std::string_view text = words_.word();
      const auto read = [&] {
        if constexpr (std::is_floating_point_v<T>)
          return numberOf(text);
        else
          return wholeNumberOf(text);
      }();
      if (text.empty()) throw fail("needs {} numbers, but the file ends before", count);
      if (!read) throw fail("has '{}' where a number should be", shortened(text));
      value = *read;
    }
    return values;
  }

  template <typename T>
  T bigEndian(const NumberType& type) {
    const std::size_t at = words_.place();
    std::uint64_t raw = 0;
    for (std::size_t i = 0; i < std::size_t(type.bytes); ++i)
      raw = raw << 8 | std::uint8_t(bytes_[at + i]);
    words_.goTo(at + std::size_t(type.bytes));
    if (type.isFloat)
      return type.bytes == 4 ? T(std::bit_cast<float>(std::uint32_t(raw)))
                             : T(std::bit_cast<double>(raw));
    if (!type.isSigned) return T(raw);
    const int unused = 64 - 8 * type.bytes;
    return T(std::int64_t(raw << unused) >> unused);
  }

  void readPoints() {
    const std::int64_t points = count("points");
    const std::string name = nextWord();
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
    const std::size_t afterCounts = words_.place();
    std::vector<std::int64_t> offsets, corners;
    if (upperCase(words_.word()) == "OFFSETS") {  // since 5.1: `cells` is one more than there are
      offsets = numbers<std::int64_t>(cells, integerType());
      if (upperCase(words_.word()) != "CONNECTIVITY")
        throw fail("has OFFSETS without CONNECTIVITY");
      corners = numbers<std::int64_t>(size, integerType());
      for (std::size_t i = 0; i < offsets.size(); ++i)
        if (offsets[i] < (i ? offsets[i - 1] : 0) || offsets[i] > size)
          throw fail("has the offset {} out of order", offsets[i]);
    } else {
      words_.goTo(afterCounts);
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
    const std::string name = nextWord();
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
    words_.line();
    while (!words_.atEnd() && !words_.line().empty()) {
    }
  }

  void skipField() {
    words_.word();  // name
    const std::int64_t arrays = count("arrays");
    for (std::int64_t i = 0; i < arrays; ++i) {
      std::string name = nextWord();
      if (upperCase(name) == "METADATA") {  // follows the array before
        skipMetadata();
        name = nextWord();
      }
      if (name.empty()) throw fail("has fewer arrays than it says");
      const std::int64_t components = count("components"), tuples = count("tuples");
      if (components > 0 && tuples > std::int64_t(bytes_.size()) / components)
        throw fail("has an array longer than the file");
      skipArray(components * tuples, nextWord());
    }
  }

  void skipArray(std::int64_t values, const std::string& typeName) {
    const std::string type = lowerCase(typeName);
    const bool isText = type == "string" || type == "utf8_string" || type == "unicode_string";
    if (isText || (type == "variant" && !binary_)) {
      words_.line();  // the rest of the line that names the array
      for (std::int64_t i = 0; i < values; ++i) {
        if (words_.atEnd()) throw fail("has fewer texts than it says");
        if (binary_)
          skipBinaryText();
        else
          words_.line();  // may be empty
      }
      return;
    }
    const int each = numberType(type).bytes;
    if (each == 0 && type != "bit")
      throw fail("has an array of unknown type '{}'", shortened(typeName));
    if (!binary_) {
      for (std::int64_t i = 0; i < values; ++i)
        if (words_.word().empty()) throw fail("has fewer numbers than it says");
      return;
    }
    words_.line();
    skipBytes(each == 0 ? std::uint64_t(values + 7) / 8
                        : std::uint64_t(values) * std::uint64_t(each));
  }

  // Its length comes first: two bits say in how many bytes, 1, 2, 4 or 8, and the others are it.
  void skipBinaryText() {
    const auto first = std::uint8_t(bytes_[words_.place()]);
    const std::size_t bytes = std::size_t(8) >> (first >> 6);
    if (words_.left() < bytes) throw fail("has fewer texts than it says");
    std::uint64_t length = first & 0x3f;
    for (std::size_t i = 1; i < bytes; ++i)
      length = length << 8 | std::uint8_t(bytes_[words_.place() + i]);
    skipBytes(bytes);
    skipBytes(length);
  }

  void skipBytes(std::uint64_t count) {
    if (count > words_.left()) throw fail("has an array longer than the file");
    words_.goTo(words_.place() + std::size_t(count));
  }

  const std::string& path_;
  std::string_view bytes_;
  WordReader words_;
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
