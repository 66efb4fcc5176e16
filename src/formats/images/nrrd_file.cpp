#include "formats/images/nrrd_file.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>

#include "base/error.h"
#include "formats/gzip.h"
#include "formats/images/image_text.h"
#include "formats/images/voxel_values.h"
#include "formats/meshes/word_reader.h"

namespace resect {
namespace {

// The lines of the header: fields by their names in lower case, and what files add as keys.
struct NrrdHeader {
  std::map<std::string, std::string> fields, keys;
  std::size_t end = 0;  // where the voxels begin

  std::string field(const std::string& name, const char* otherwise = "") const {
    const auto found = fields.find(name);
    return found == fields.end() ? otherwise : found->second;
  }
};

NrrdHeader nrrdHeaderOf(const std::string& path, std::string_view bytes) {
  NrrdHeader header;
  WordReader lines(path, bytes);
  lines.line();  // NRRD0005
  for (;;) {
    if (lines.atEnd()) break;  // the header of voxels that lie in another file
    const std::string_view line = lines.line();
    if (trimmed(line).empty()) break;
    if (line.starts_with('#')) continue;
    if (const std::size_t key = line.find(":="); key != line.npos)
      header.keys[std::string(line.substr(0, key))] = line.substr(key + 2);
    else if (const std::size_t field = line.find(": "); field != line.npos)
      header.fields[lowerCase(line.substr(0, field))] = trimmed(line.substr(field + 2));
    else
      throw lines.fail("the NRRD header has a line that is neither a field nor a key");
  }
  header.end = lines.place();
  return header;
}

VoxelType nrrdTypeOf(const std::string& path, const std::string& name) {
  struct Named {
    std::string_view name;
    VoxelType type;
  };
  constexpr Named kNames[]{{"uchar", VoxelType::U8},
                           {"unsigned char", VoxelType::U8},
                           {"uint8", VoxelType::U8},
                           {"uint8_t", VoxelType::U8},
                           {"signed char", VoxelType::I8},
                           {"int8", VoxelType::I8},
                           {"int8_t", VoxelType::I8},
                           {"short", VoxelType::I16},
                           {"short int", VoxelType::I16},
                           {"signed short", VoxelType::I16},
                           {"signed short int", VoxelType::I16},
                           {"int16", VoxelType::I16},
                           {"int16_t", VoxelType::I16},
                           {"ushort", VoxelType::U16},
                           {"unsigned short", VoxelType::U16},
                           {"unsigned short int", VoxelType::U16},
                           {"uint16", VoxelType::U16},
                           {"uint16_t", VoxelType::U16},
                           {"int", VoxelType::I32},
                           {"signed int", VoxelType::I32},
                           {"int32", VoxelType::I32},
                           {"int32_t", VoxelType::I32},
                           {"uint", VoxelType::U32},
                           {"unsigned int", VoxelType::U32},
                           {"uint32", VoxelType::U32},
                           {"uint32_t", VoxelType::U32},
                           {"longlong", VoxelType::I64},
                           {"int64", VoxelType::I64},
                           {"int64_t", VoxelType::I64},
                           {"uint64", VoxelType::U64},
                           {"uint64_t", VoxelType::U64},
                           {"float", VoxelType::F32},
                           {"double", VoxelType::F64}};
  const auto found = std::ranges::find(kNames, lowerCase(name), &Named::name);
  if (found == std::end(kNames))
    throw error("{}: its voxels have type '{}', which is not read; export it with whole numbers",
                path, name);
  return found->type;
}

// "(1,0,0) none (0,1,0)": one entry an axis, nothing for "none".
std::vector<std::optional<Vec3>> vectorsIn(const std::string& path, const std::string& text) {
  std::vector<std::optional<Vec3>> vectors;
  for (std::size_t at = text.find_first_not_of(' '); at < text.size();
       at = text.find_first_not_of(' ', at)) {
    const bool none = text.compare(at, 4, "none") == 0;
    const std::size_t end = none ? at + 4 : text.find(')', at);
    if (!none && (text[at] != '(' || end == text.npos))
      throw error("{}: '{}' are no vectors of an NRRD header; export it again", path, text);
    if (none)
      vectors.emplace_back();
    else
      vectors.emplace_back(threeNumbers(path, text.substr(at + 1, end - at - 1)));
    at = end + (none ? 0 : 1);
  }
  return vectors;
}

// Whether an axis of the file is one of space.
std::vector<bool> spaceAxes(const NrrdHeader& header, std::size_t axes,
                            const std::vector<std::optional<Vec3>>& directions) {
  std::vector<bool> space(axes, true);
  if (directions.size() == axes) {
    for (std::size_t a = 0; a < axes; ++a) space[a] = directions[a].has_value();
  } else if (axes == 4) {
    const std::vector<std::string> kinds = words(header.field("kinds"));
    for (std::size_t a = 0; a < kinds.size() && a < axes; ++a)
      space[a] = kinds[a] == "domain" || kinds[a] == "space";
  }
  return space;
}

// What turns coordinates of the named space into left, posterior, superior.
Vec3 signsOf(const std::string& path, const std::string& named) {
  std::string space = lowerCase(named);
  if (space.empty()) return Vec3::Ones();
  std::string letters;
  if (space.size() == 3) {
    letters = space;
  } else {
    std::ranges::replace(space, '-', ' ');
    for (const std::string& word : words(space)) letters += word[0];
  }
  const bool known = letters.size() >= 3 && (letters[0] == 'l' || letters[0] == 'r') &&
                     (letters[1] == 'a' || letters[1] == 'p') && letters[2] == 's';
  if (!known)
    throw error("{}: its space '{}' is not read; export it in left-posterior-superior", path,
                named);
  return {letters[0] == 'l' ? 1.0 : -1.0, letters[1] == 'p' ? 1.0 : -1.0, 1.0};
}

std::string unpacked(const std::string& path, const NrrdHeader& header, std::string_view data,
                     VoxelType type) {
  const std::string encoding = lowerCase(header.field("encoding", "raw"));
  if (encoding == "raw") return std::string(data);
  if (encoding == "gzip" || encoding == "gz") return unpackGzip(path, data, kMostImageBytes);
  if (encoding == "ascii" || encoding == "text" || encoding == "txt")
    return numbersFromText(path, data, type);
  throw error("{}: its encoding '{}' is not read; save it with gzip or without compression", path,
              encoding);
}

// The part of the file, or of the file beside it, that holds the voxels.
std::string_view dataOf(const std::string& path, const NrrdHeader& header, std::string_view bytes,
                        const BesideFiles& beside) {
  const std::string name = header.field("data file", header.field("datafile").c_str());
  std::string_view data = bytes.substr(header.end);
  if (!name.empty()) data = besideVoxels(path, name, beside);
  for (std::int64_t skip = wholeNumberOf(header.field("line skip", "0")).value_or(0); skip > 0;
       --skip) {
    const std::size_t end = data.find('\n');
    if (end == data.npos) throw error("{}: ends early; copy or export it again", path);
    data.remove_prefix(end + 1);
  }
  const std::int64_t skip = wholeNumberOf(header.field("byte skip", "0")).value_or(0);
  if (skip < 0 || std::size_t(skip) > data.size())
    throw error("{}: its 'byte skip' of {} is not read; save it in one file", path, skip);
  return data.substr(std::size_t(skip));
}

// Segments of 3D Slicer that stand in the given layer: their names by value.
std::map<std::int64_t, std::string> segmentsIn(const NrrdHeader& header, int layer) {
  std::map<std::int64_t, std::string> names;
  for (int i = 0; i < kMostLabels; ++i) {
    const auto key = [&](const char* what) {
      const auto found = header.keys.find(fmt::format("Segment{}_{}", i, what));
      return found == header.keys.end() ? std::string() : found->second;
    };
    const std::optional<std::int64_t> value = wholeNumberOf(key("LabelValue"));
    if (!value) continue;
    if (wholeNumberOf(key("Layer")).value_or(0) == layer) names[*value] = key("Name");
  }
  return names;
}

}  // namespace

bool startsAsNrrd(std::string_view bytes) { return bytes.starts_with("NRRD0"); }

LabelImage readNrrdFile(const std::string& path, std::string_view bytes,
                        const BesideFiles& beside) {
  const NrrdHeader header = nrrdHeaderOf(path, bytes);
  const std::vector<std::string> sizes = words(header.field("sizes"));
  const auto directions = vectorsIn(path, header.field("space directions"));
  const std::vector<bool> space = spaceAxes(header, sizes.size(), directions);
  if ((sizes.size() != 3 && sizes.size() != 4) || std::ranges::count(space, true) != 3)
    throw error(
        "{}: is an image of {} axes, {} of them in space; take one volume of it, with three", path,
        sizes.size(), std::ranges::count(space, true));

  LabelImage image;
  image.format = "NRRD";
  const Vec3 signs = signsOf(path, header.field("space"));
  const std::vector<std::string> spacings = words(header.field("spacings"));
  std::int64_t layers = 1, stride = 1, perLayer = 1;
  for (std::size_t a = 0, axis = 0; a < sizes.size(); ++a) {
    const std::int64_t n = wholeNumberOf(sizes[a]).value_or(0);
    if (n < 1 || n > kMostVoxels)
      throw error("{}: its sizes '{}' are none; export it again", path, header.field("sizes"));
    if (!space[a]) {
      if (a != 0 && a + 1 != sizes.size())
        throw error("{}: its layers stand between axes of space; export it again", path);
      layers = n;
      if (a == 0) stride = n;
      continue;
    }
    image.dims[Eigen::Index(axis)] = int(n);
    if (directions.size() == sizes.size() && directions[a])
      image.step.col(Eigen::Index(axis)) = 1e-3 * signs.cwiseProduct(*directions[a]);
    else
      image.step.col(Eigen::Index(axis)) =
          1e-3 * (a < spacings.size() ? numberOf(spacings[a]).value_or(1) : 1) *
          Vec3::Unit(Eigen::Index(axis));
    ++axis;
  }
  if (const auto origin = vectorsIn(path, header.field("space origin"));
      !origin.empty() && origin[0])
    image.origin = 1e-3 * signs.cwiseProduct(*origin[0]);
  checkGrid(path, image);
  if (layers > kMostLayers)
    throw error("{}: has {} layers, more than {}; take one volume of it", path, layers,
                kMostLayers);
  if (stride == 1) perLayer = image.voxelCount();

  VoxelNumbers numbers;
  numbers.type = nrrdTypeOf(path, header.field("type"));
  numbers.bigEndian = lowerCase(header.field("endian")) == "big";
  numbers.stride = stride;
  const std::string data =
      unpacked(path, header, dataOf(path, header, bytes, beside), numbers.type);
  numbers.bytes = data;
  for (int layer = 0; layer < int(layers); ++layer) {
    numbers.first = layer * perLayer;
    addLayer(path, image, numbers, segmentsIn(header, layer));
  }
  return image;
}

}  // namespace resect
