#include "formats/images/nifti_file.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <map>

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

// What both versions of the header say.
struct NiftiHeader {
  bool bigEndian = false;
  std::array<std::int64_t, 8> dim{};  // how many there are, then their sizes
  std::array<double, 8> pixdim{};     // a sign, then sizes of a voxel, in units
  int datatype = 0, units = 0, qform = 0, sform = 0;
  std::int64_t offset = 0;  // of the voxels
  double slope = 0, intercept = 0;
  Vec3 quaternion = Vec3::Zero(), qoffset = Vec3::Zero();
  std::array<std::array<double, 4>, 3> rows{};  // of the sform
};

// Fields at their places in the header.
class Fields {
 public:
  Fields(std::string_view bytes, bool bigEndian) : bytes_(bytes), bigEndian_(bigEndian) {}

  template <typename T>
  T at(std::size_t place) const {
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes_.data() + place, sizeof(T));
    if (bigEndian_) std::ranges::reverse(raw);
    return std::bit_cast<T>(raw);
  }

 private:
  std::string_view bytes_;
  bool bigEndian_;
};

// Where the fields of a version of the header stand, and its size.
struct Layout {
  std::size_t bytes, dim, datatype, pixdim, offset, slope, units, codes, quaternion, rows;
};
constexpr Layout kOne{348, 40, 70, 76, 108, 112, 123, 252, 256, 280};
constexpr Layout kTwo{540, 16, 12, 104, 168, 176, 500, 344, 352, 400};

template <typename Size, typename Code, typename Real, typename Offset, typename Units>
NiftiHeader niftiHeaderOf(const std::string& path, std::string_view bytes, const Layout& layout) {
  if (bytes.size() < layout.bytes)
    throw error("{}: ends early, within its NIfTI header; copy or export it again", path);
  NiftiHeader header;
  const auto dimensions = [&](bool big) { return Fields(bytes, big).at<Size>(layout.dim); };
  const auto good = [](Size n) { return n >= 1 && n <= 7; };
  header.bigEndian = !good(dimensions(false));
  if (!good(dimensions(header.bigEndian)))
    throw error("{}: its NIfTI header is damaged; export it again", path);
  const Fields fields(bytes, header.bigEndian);
  for (std::size_t i = 0; i < 8; ++i) {
    header.dim[i] = fields.at<Size>(layout.dim + i * sizeof(Size));
    header.pixdim[i] = fields.at<Real>(layout.pixdim + i * sizeof(Real));
  }
  header.datatype = fields.at<std::int16_t>(layout.datatype);
  header.units = fields.at<Units>(layout.units) & 7;  // of space; the others are of time
  const auto offset = double(fields.at<Offset>(layout.offset));
  if (offset >= 0 && offset <= double(bytes.size())) header.offset = std::int64_t(offset);
  header.slope = fields.at<Real>(layout.slope);
  header.intercept = fields.at<Real>(layout.slope + sizeof(Real));
  header.qform = fields.at<Code>(layout.codes);
  header.sform = fields.at<Code>(layout.codes + sizeof(Code));
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t place = layout.quaternion + i * sizeof(Real);
    header.quaternion[Eigen::Index(i)] = fields.at<Real>(place);
    header.qoffset[Eigen::Index(i)] = fields.at<Real>(place + 3 * sizeof(Real));
    for (std::size_t c = 0; c < 4; ++c)
      header.rows[i][c] = fields.at<Real>(layout.rows + (4 * i + c) * sizeof(Real));
  }
  return header;
}

VoxelType niftiTypeOf(const std::string& path, int datatype) {
  struct Code {
    int code;
    VoxelType type;
  };
  constexpr Code kCodes[]{{2, VoxelType::U8},     {256, VoxelType::I8},   {512, VoxelType::U16},
                          {4, VoxelType::I16},    {768, VoxelType::U32},  {8, VoxelType::I32},
                          {1280, VoxelType::U64}, {1024, VoxelType::I64}, {16, VoxelType::F32},
                          {64, VoxelType::F64}};
  const auto found = std::ranges::find(kCodes, datatype, &Code::code);
  if (found == std::end(kCodes))
    throw error(
        "{}: has voxels of NIfTI type {}, which are no labels; export its labels as whole "
        "numbers",
        path, datatype);
  return found->type;
}

double metresPerUnit(int unit) { return unit == 1 ? 1 : unit == 3 ? 1e-6 : 1e-3; }

// The sform if it is set, else the qform, else the sizes alone.
void place(LabelImage& image, const NiftiHeader& header) {
  const double metres = metresPerUnit(header.units);
  if (header.sform > 0) {
    const auto column = [&](std::size_t c) {
      return Vec3(header.rows[0][c], header.rows[1][c], header.rows[2][c]);
    };
    for (int axis = 0; axis < 3; ++axis)
      image.step.col(axis) = metres * turnedRasLps(column(std::size_t(axis)));
    image.origin = metres * turnedRasLps(column(3));
    return;
  }
  Mat3 turn = Mat3::Identity();
  if (header.qform > 0) {
    const double length = header.quaternion.norm();
    const Vec3 v = length > 1 ? Vec3(header.quaternion / length) : header.quaternion;
    const double real = std::sqrt(std::max(0.0, 1 - v.squaredNorm()));
    turn = Eigen::Quaterniond(real, v.x(), v.y(), v.z()).toRotationMatrix();
    image.origin = metres * turnedRasLps(header.qoffset);
    if (header.pixdim[0] < 0) turn.col(2) *= -1;
  }
  for (int axis = 0; axis < 3; ++axis)
    image.step.col(axis) =
        metres * std::abs(header.pixdim[std::size_t(axis) + 1]) * turnedRasLps(turn.col(axis));
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
  const bool two = isTwo(bytes);
  const NiftiHeader header =
      two ? niftiHeaderOf<std::int64_t, std::int32_t, double, std::int64_t, std::int32_t>(
                path, bytes, kTwo)
          : niftiHeaderOf<std::int16_t, std::int16_t, float, float, std::uint8_t>(path, bytes,
                                                                                  kOne);
  LabelImage image;
  image.format = two ? "NIfTI-2" : "NIfTI-1";
  for (std::size_t i = 1; i <= 7; ++i) {
    const std::int64_t n = std::int64_t(i) <= header.dim[0] ? header.dim[i] : 1;
    if (n < 1 || n > kMostVoxels)
      throw error("{}: its NIfTI header is damaged; export it again", path);
    if (i > 3 && n > 1)
      throw error("{}: has {} dimensions; take one volume of it, with three", path, header.dim[0]);
    if (i <= 3) image.dims[Eigen::Index(i) - 1] = int(n);
  }
  place(image, header);
  checkGrid(path, image);

  VoxelNumbers numbers;
  numbers.type = niftiTypeOf(path, header.datatype);
  numbers.bigEndian = header.bigEndian;
  if (header.slope != 0 && std::isfinite(header.slope))
    numbers.slope = header.slope, numbers.intercept = header.intercept;
  std::string pair;
  std::map<std::int64_t, std::string> names;
  if (isPair(bytes)) {
    pair = voxelsOfPair(path, beside);
    numbers.bytes = pair;
    names = namesIn(bytes);
  } else {
    const std::size_t least = two ? kTwo.bytes : kOne.bytes;
    const std::size_t offset = std::max(std::size_t(header.offset), least);
    numbers.bytes = bytes.substr(offset);
    names = namesIn(bytes.substr(0, offset));
  }
  addLayer(path, image, numbers, names);
  return image;
}

}  // namespace resect
