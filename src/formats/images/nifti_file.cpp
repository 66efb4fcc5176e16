#include "formats/images/nifti_file.h"

#include <nifti2_io.h>

#include <charconv>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>

#include "base/error.h"
#include "formats/gzip.h"
#include "formats/images/voxel_values.h"

namespace resect {
namespace {

constexpr std::size_t kMagicOfTwo = 4;  // where the magic of version 2 stands
constexpr std::size_t kMagicOfOne = 344;

bool has(std::string_view bytes, std::size_t at, std::string_view magic) {
  return bytes.size() > at && bytes.substr(at).starts_with(magic);
}

bool isTwo(std::string_view bytes) {
  return has(bytes, kMagicOfTwo, "n+2") || has(bytes, kMagicOfTwo, "ni2");
}

bool isPair(std::string_view bytes) {
  return has(bytes, kMagicOfTwo, "ni2") || has(bytes, kMagicOfOne, "ni1");
}

using Header = std::unique_ptr<nifti_image, decltype(&nifti_image_free)>;

Header headerOf(const std::string& path, std::string_view bytes) {
  nifti_set_debug_level(0);
  Header header(nullptr, nifti_image_free);
  if (isTwo(bytes)) {
    nifti_2_header raw{};
    if (bytes.size() >= sizeof raw) {
      std::memcpy(&raw, bytes.data(), sizeof raw);
      header.reset(nifti_convert_n2hdr2nim(raw, nullptr));
    }
  } else {
    nifti_1_header raw{};
    if (bytes.size() >= sizeof raw) {
      std::memcpy(&raw, bytes.data(), sizeof raw);
      header.reset(nifti_convert_n1hdr2nim(raw, nullptr));
    }
  }
  if (!header) throw error("{}: its NIfTI header is damaged; export it again", path);
  return header;
}

VoxelType typeOf(const std::string& path, int datatype) {
  switch (datatype) {
    case DT_UINT8:
      return VoxelType::U8;
    case DT_INT8:
      return VoxelType::I8;
    case DT_UINT16:
      return VoxelType::U16;
    case DT_INT16:
      return VoxelType::I16;
    case DT_UINT32:
      return VoxelType::U32;
    case DT_INT32:
      return VoxelType::I32;
    case DT_UINT64:
      return VoxelType::U64;
    case DT_INT64:
      return VoxelType::I64;
    case DT_FLOAT32:
      return VoxelType::F32;
    case DT_FLOAT64:
      return VoxelType::F64;
    default:
      throw error(
          "{}: has voxels of type {}, which are no labels; export its labels as whole "
          "numbers",
          path, nifti_datatype_string(datatype));
  }
}

double metresPerUnit(int unit) {
  switch (unit) {
    case NIFTI_UNITS_METER:
      return 1;
    case NIFTI_UNITS_MICRON:
      return 1e-6;
    default:
      return 1e-3;
  }
}

void place(LabelImage& image, const nifti_image& header) {
  const nifti_dmat44& toWorld = header.sform_code > 0 ? header.sto_xyz : header.qto_xyz;
  const double metres = metresPerUnit(header.xyz_units);
  const auto column = [&](int c) {
    return Vec3(metres * turnedRasLps({toWorld.m[0][c], toWorld.m[1][c], toWorld.m[2][c]}));
  };
  for (int axis = 0; axis < 3; ++axis) image.step.col(axis) = column(axis);
  image.origin = column(3);
}

// The value of ATTRIBUTE="..." in a tag.
std::string_view attribute(std::string_view tag, std::string_view name) {
  const std::size_t at = tag.find(name);
  if (at == tag.npos) return {};
  const std::size_t begin = at + name.size();
  const std::size_t end = tag.find('"', begin);
  return end == tag.npos ? std::string_view() : tag.substr(begin, end - begin);
}

// Names by value, from <Label Key="1" ...><![CDATA[spleen]]></Label> in the header's extensions.
std::map<std::int64_t, std::string> namesIn(std::string_view extensions) {
  std::map<std::int64_t, std::string> names;
  for (std::size_t at = extensions.find("<Label "); at != extensions.npos;
       at = extensions.find("<Label ", at + 1)) {
    const std::size_t tagEnd = extensions.find('>', at);
    const std::size_t end = extensions.find("</Label>", at);
    if (tagEnd == extensions.npos || end == extensions.npos || end < tagEnd) break;
    const std::string_view key = attribute(extensions.substr(at, tagEnd - at), "Key=\"");
    std::string_view name = extensions.substr(tagEnd + 1, end - tagEnd - 1);
    constexpr std::string_view kOpen = "<![CDATA[", kClose = "]]>";
    if (name.starts_with(kOpen) && name.ends_with(kClose))
      name = name.substr(kOpen.size(), name.size() - kOpen.size() - kClose.size());
    std::int64_t value = 0;
    if (std::from_chars(key.data(), key.data() + key.size(), value).ec == std::errc() &&
        !name.empty() && names.size() < std::size_t(kMostLabels))
      names[value] = name;
  }
  return names;
}

// The bytes of the file of voxels that belongs to a .hdr.
std::string voxelsOfPair(const std::string& path, const BesideFiles& beside) {
  std::filesystem::path name = std::filesystem::path(path).filename();
  const bool packed = name.extension() == ".gz";
  if (packed) name = name.stem();
  name.replace_extension(".img");
  if (packed) name += ".gz";
  const auto found = beside.find(name.string());
  if (found == beside.end()) throw LacksFile{name.string()};
  const std::string_view bytes(found->second.data(), found->second.size());
  return isGzip(bytes) ? unpackGzip(name.string(), bytes, kMostImageBytes) : std::string(bytes);
}

}  // namespace

bool startsAsNifti(std::string_view bytes) {
  return isTwo(bytes) || has(bytes, kMagicOfOne, "n+1") || has(bytes, kMagicOfOne, "ni1");
}

LabelImage readNiftiFile(const std::string& path, std::string_view bytes,
                         const BesideFiles& beside) {
  const Header header = headerOf(path, bytes);
  if (header->nvox != header->nx * header->ny * header->nz)
    throw error("{}: has {} dimensions; take one volume of it, with three", path, header->ndim);
  LabelImage image;
  image.format = isTwo(bytes) ? "NIfTI-2" : "NIfTI-1";
  for (const std::int64_t n : {header->nx, header->ny, header->nz})
    if (n < 1 || n > kMostVoxels)
      throw error("{}: its NIfTI header is damaged; export it again", path);
  image.dims = {int(header->nx), int(header->ny), int(header->nz)};
  place(image, *header);
  checkGrid(path, image);

  VoxelNumbers numbers;
  numbers.type = typeOf(path, header->datatype);
  numbers.bigEndian = header->byteorder != nifti_short_order();
  if (header->scl_slope != 0 && std::isfinite(header->scl_slope))
    numbers.slope = header->scl_slope, numbers.intercept = header->scl_inter;
  std::string pair;
  std::map<std::int64_t, std::string> names;
  if (isPair(bytes)) {
    pair = voxelsOfPair(path, beside);
    numbers.bytes = pair;
    names = namesIn(bytes);
  } else {
    const auto offset = std::size_t(std::max<std::int64_t>(header->iname_offset, 0));
    if (offset > bytes.size())
      throw error("{}: ends within its header; copy or export it again", path);
    numbers.bytes = bytes.substr(offset);
    names = namesIn(bytes.substr(0, offset));
  }
  addLayer(path, image, numbers, names);
  return image;
}

}  // namespace resect
