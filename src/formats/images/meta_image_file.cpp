#include "formats/images/meta_image_file.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "base/error.h"
#include "formats/gzip.h"
#include "formats/images/image_text.h"
#include "formats/images/voxel_values.h"
#include "formats/meshes/word_reader.h"

namespace resect {
namespace {

struct Header {
  std::map<std::string, std::string> fields;  // by names in lower case
  std::size_t end = 0;                        // where the voxels begin

  // The first of the fields that the file has.
  std::string field(std::initializer_list<const char*> names, const char* otherwise = "") const {
    for (const char* name : names)
      if (const auto found = fields.find(name); found != fields.end()) return found->second;
    return otherwise;
  }
  bool isTrue(std::initializer_list<const char*> names) const {
    const std::string value = lowerCase(field(names));
    return value == "true" || value == "1";
  }
};

Header headerOf(const std::string& path, std::string_view bytes) {
  Header header;
  WordReader lines(path, bytes);
  while (!lines.atEnd()) {
    const std::string_view line = lines.line();
    const std::size_t equals = line.find('=');
    if (equals == line.npos) {
      if (trimmed(line).empty()) continue;
      throw lines.fail("the MetaImage header has a line without '='");
    }
    const std::string name = lowerCase(trimmed(line.substr(0, equals)));
    header.fields[name] = trimmed(line.substr(equals + 1));
    header.end = lines.place();
    if (name == "elementdatafile") return header;  // always the last
  }
  throw error("{}: its header has no ElementDataFile; export it again", path);
}

VoxelType typeOf(const std::string& path, const std::string& name) {
  struct Named {
    std::string_view name;
    VoxelType type;
  };
  constexpr Named kNames[]{{"met_uchar", VoxelType::U8},       {"met_char", VoxelType::I8},
                           {"met_ushort", VoxelType::U16},     {"met_short", VoxelType::I16},
                           {"met_uint", VoxelType::U32},       {"met_int", VoxelType::I32},
                           {"met_ulong", VoxelType::U32},      {"met_long", VoxelType::I32},
                           {"met_ulong_long", VoxelType::U64}, {"met_long_long", VoxelType::I64},
                           {"met_float", VoxelType::F32},      {"met_double", VoxelType::F64}};
  const auto found = std::ranges::find(kNames, lowerCase(name), &Named::name);
  if (found == std::end(kNames))
    throw error("{}: its voxels have type '{}', which is not read; export it with whole numbers",
                path, name);
  return found->type;
}

void place(const std::string& path, const Header& header, LabelImage& image) {
  const std::string dims = header.field({"dimsize"});
  const Vec3 size = threeNumbers(path, dims);
  if ((size.array() < 1).any() || (size.array() > double(kMostVoxels)).any())
    throw error("{}: its DimSize '{}' is none; export it again", path, dims);
  image.dims = size.cast<int>();
  const Vec3 spacing = threeNumbers(path, header.field({"elementspacing", "elementsize"}, "1 1 1"));
  const std::vector<std::string> matrix =
      words(header.field({"transformmatrix", "rotation", "orientation"}, "1 0 0 0 1 0 0 0 1"));
  if (matrix.size() != 9)
    throw error("{}: its TransformMatrix has {} numbers; export it again, with nine", path,
                matrix.size());
  for (int axis = 0; axis < 3; ++axis)
    for (int c = 0; c < 3; ++c)
      image.step(c, axis) =
          1e-3 * spacing[axis] * numberOf(matrix[std::size_t(3 * axis + c)]).value_or(0);
  image.origin = 1e-3 * threeNumbers(path, header.field({"offset", "position", "origin"}, "0 0 0"));
  checkGrid(path, image);
}

}  // namespace

bool startsAsMetaImage(std::string_view bytes) {
  const std::string start = lowerCase(bytes.substr(0, 40));
  for (const char* first : {"objecttype", "ndims", "comment"}) {
    const std::size_t length = std::string_view(first).size();
    if (!start.starts_with(first)) continue;
    const std::size_t next = start.find_first_not_of(" \t", length);
    if (next != start.npos && start[next] == '=') return true;
  }
  return false;
}

LabelImage readMetaImageFile(const std::string& path, std::string_view bytes,
                             const BesideFiles& beside) {
  const Header header = headerOf(path, bytes);
  if (header.field({"ndims"}) != "3" || header.field({"elementnumberofchannels"}, "1") != "1")
    throw error("{}: has {} dimensions and {} channels; take one volume of it, with three and one",
                path, header.field({"ndims"}), header.field({"elementnumberofchannels"}, "1"));
  LabelImage image;
  image.format = "MetaImage";
  place(path, header, image);

  VoxelNumbers numbers;
  numbers.type = typeOf(path, header.field({"elementtype"}));
  numbers.bigEndian = header.isTrue({"binarydatabyteordermsb", "elementbyteordermsb"});
  const std::string name = header.field({"elementdatafile"});
  std::string_view data =
      lowerCase(name) == "local" ? bytes.substr(header.end) : besideVoxels(path, name, beside);
  std::string made;
  if (header.isTrue({"compresseddata"}))
    data = made = unpackZlib(path, data, kMostImageBytes);
  else if (lowerCase(header.field({"binarydata"}, "true")) == "false")
    data = made = numbersFromText(path, data, numbers.type);
  const std::int64_t skip = wholeNumberOf(header.field({"headersize"}, "0")).value_or(0);
  const std::size_t wanted = std::size_t(image.voxelCount()) * bytesOf(numbers.type);
  if (skip == -1 && data.size() > wanted)  // the voxels are the last of the file
    data.remove_prefix(data.size() - wanted);
  else if (skip > 0)
    data.remove_prefix(std::min(data.size(), std::size_t(skip)));
  numbers.bytes = data;
  addLayer(path, image, numbers, {});
  return image;
}

}  // namespace resect
