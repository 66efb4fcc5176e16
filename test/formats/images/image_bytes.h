// Label images as files: bytes as other programs write them.
#pragma once

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "formats/images/label_image.h"
#include "formats/images/voxel_values.h"

namespace resect::test {

// A small image to be written: values by voxel, the first axis fastest.
struct PlainImage {
  Vec3i dims = Vec3i(7, 5, 4);
  Vec3 origin = Vec3::Zero();    // mm, left-posterior-superior
  Mat3 step = Mat3::Identity();  // mm
  std::vector<double> values;
};

// Two labels, 3 and 200, in boxes that no turn of the axes maps to themselves; oblique.
inline PlainImage twoBoxes() {
  PlainImage image;
  const Mat3 turn = Eigen::AngleAxisd(0.4, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  image.step = turn * Vec3(0.8, 0.9, 5).asDiagonal();
  image.origin = {-12.5, 30.25, 400.5};
  for (int z = 0; z < image.dims.z(); ++z)
    for (int y = 0; y < image.dims.y(); ++y)
      for (int x = 0; x < image.dims.x(); ++x)
        image.values.push_back(x > 3 && y < 2 ? 200 : x < 3 && y > 1 && z == 1 ? 3 : 0);
  return image;
}

template <typename T>
void put(std::string& bytes, T value, bool big = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (big) std::reverse(std::begin(raw), std::end(raw));
  bytes.append(raw, sizeof(T));
}

inline void putVoxel(std::string& bytes, double value, VoxelType type, bool big) {
  switch (type) {
    case VoxelType::U8:
      return put(bytes, std::uint8_t(value), big);
    case VoxelType::I8:
      return put(bytes, std::int8_t(value), big);
    case VoxelType::U16:
      return put(bytes, std::uint16_t(value), big);
    case VoxelType::I16:
      return put(bytes, std::int16_t(value), big);
    case VoxelType::U32:
      return put(bytes, std::uint32_t(value), big);
    case VoxelType::I32:
      return put(bytes, std::int32_t(value), big);
    case VoxelType::U64:
      return put(bytes, std::uint64_t(value), big);
    case VoxelType::I64:
      return put(bytes, std::int64_t(value), big);
    case VoxelType::F32:
      return put(bytes, float(value), big);
    case VoxelType::F64:
      return put(bytes, value, big);
  }
}

inline std::string voxels(const PlainImage& image, VoxelType type, bool big) {
  std::string bytes;
  for (const double value : image.values) putVoxel(bytes, value, type, big);
  return bytes;
}

// zlib stream, or gzip file.
inline std::string packed(const std::string& bytes, bool gzip) {
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, gzip ? 31 : 15, 8, Z_DEFAULT_STRATEGY);
  std::string result(deflateBound(&stream, uLong(bytes.size())) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = uInt(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = uInt(result.size());
  deflate(&stream, Z_FINISH);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

struct NiftiForm {
  int version = 1;
  VoxelType type = VoxelType::U8;
  bool big = false;
  bool pair = false;  // the voxels are in a file of their own
  float slope = 0, inter = 0;
  std::string names;  // XML of an extension
};

inline int niftiType(VoxelType type) {
  constexpr std::array kCodes{2, 256, 512, 4, 768, 8, 1280, 1024, 16, 64};
  return kCodes[std::size_t(type)];
}

// The header alone if form.pair.
inline std::string niftiBytes(const PlainImage& image, const NiftiForm& form = {}) {
  const bool big = form.big, two = form.version == 2;
  std::string extension;
  if (!form.names.empty()) {
    std::string text = form.names;
    text.resize((text.size() + 8 + 15) / 16 * 16 - 8, '\0');
    put(extension, std::int32_t(text.size() + 8), big);
    put(extension, std::int32_t(0), big);
    extension += text;
  }
  const std::size_t size = two ? 540 : 348;
  const auto offset = form.pair ? 0 : std::int64_t(size + 4 + extension.size());
  const Vec3 spacing = image.step.colwise().norm();
  const std::array<std::int64_t, 8> dim{3, image.dims.x(), image.dims.y(), image.dims.z(), 1, 1, 1,
                                        1};
  std::string h;
  if (two) {
    put(h, std::int32_t(540), big);
    h += form.pair ? std::string("ni2\0\r\n\032\n", 8) : std::string("n+2\0\r\n\032\n", 8);
    put(h, std::int16_t(niftiType(form.type)), big);
    put(h, std::int16_t(8 * bytesOf(form.type)), big);
    for (const std::int64_t d : dim) put(h, d, big);
    for (int i = 0; i < 3; ++i) put(h, 0.0, big);  // intent
    for (int i = 0; i < 8; ++i) put(h, i >= 1 && i <= 3 ? spacing[i - 1] : 1.0, big);
    put(h, offset, big);
    put(h, double(form.slope), big), put(h, double(form.inter), big);
    for (int i = 0; i < 4; ++i) put(h, 0.0, big);
    put(h, std::int64_t(0), big), put(h, std::int64_t(0), big);
    h.append(80 + 24, '\0');
    put(h, std::int32_t(0), big), put(h, std::int32_t(1), big);  // qform, sform
    for (int i = 0; i < 6; ++i) put(h, 0.0, big);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) {
        const Vec3 column = turnedRasLps(c < 3 ? Vec3(image.step.col(c)) : image.origin);
        put(h, column[r], big);
      }
    put(h, std::int32_t(0), big), put(h, std::int32_t(2), big);  // slice code, mm
  } else {
    put(h, std::int32_t(348), big);
    h.append(36, '\0');
    for (const std::int64_t d : dim) put(h, std::int16_t(d), big);
    for (int i = 0; i < 3; ++i) put(h, 0.0f, big);
    put(h, std::int16_t(0), big);
    put(h, std::int16_t(niftiType(form.type)), big);
    put(h, std::int16_t(8 * bytesOf(form.type)), big);
    put(h, std::int16_t(0), big);
    for (int i = 0; i < 8; ++i) put(h, float(i >= 1 && i <= 3 ? spacing[i - 1] : 1.0), big);
    put(h, float(offset), big);
    put(h, form.slope, big), put(h, form.inter, big);
    put(h, std::int16_t(0), big);
    h += '\0';
    h += char(2);  // mm
    for (int i = 0; i < 4; ++i) put(h, 0.0f, big);
    put(h, std::int32_t(0), big), put(h, std::int32_t(0), big);
    h.append(80 + 24, '\0');
    put(h, std::int16_t(0), big), put(h, std::int16_t(1), big);  // qform, sform
    for (int i = 0; i < 6; ++i) put(h, 0.0f, big);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) {
        const Vec3 column = turnedRasLps(c < 3 ? Vec3(image.step.col(c)) : image.origin);
        put(h, float(column[r]), big);
      }
    h.append(16, '\0');
    h += form.pair ? std::string("ni1\0", 4) : std::string("n+1\0", 4);
  }
  h.resize(size, '\0');
  h += char(form.names.empty() ? 0 : 1);
  h.append(3, '\0');
  h += extension;
  return form.pair ? h : h + voxels(image, form.type, big);
}

struct NrrdForm {
  std::string type = "uchar";
  VoxelType voxel = VoxelType::U8;
  bool big = false;
  std::string encoding = "raw";
  std::string space = "left-posterior-superior";
  std::string more;      // further lines of the header
  std::string dataFile;  // its voxels are there
};

inline std::string textOf(const Vec3& v) {
  return fmt::format("({:.17g},{:.17g},{:.17g})", v.x(), v.y(), v.z());
}

inline std::string nrrdBytes(const PlainImage& image, const NrrdForm& form = {}) {
  const bool ras = form.space != "left-posterior-superior";
  const auto turn = [&](const Vec3& v) { return ras ? turnedRasLps(v) : v; };
  std::string h = "NRRD0004\n# made by a test\n";
  h += fmt::format("type: {}\ndimension: 3\nspace: {}\nsizes: {} {} {}\n", form.type, form.space,
                   image.dims.x(), image.dims.y(), image.dims.z());
  h += fmt::format("space directions: {} {} {}\n", textOf(turn(image.step.col(0))),
                   textOf(turn(image.step.col(1))), textOf(turn(image.step.col(2))));
  h += fmt::format("kinds: domain domain domain\nendian: {}\nencoding: {}\nspace origin: {}\n",
                   form.big ? "big" : "little", form.encoding, textOf(turn(image.origin)));
  h += form.more;
  if (!form.dataFile.empty()) h += "data file: " + form.dataFile + "\n";
  if (!form.dataFile.empty()) return h;
  h += "\n";
  if (form.encoding == "ascii") {
    for (const double value : image.values) h += fmt::format("{} ", value);
    return h + "\n";
  }
  const std::string data = voxels(image, form.voxel, form.big);
  return h + (form.encoding == "gzip" ? packed(data, true) : data);
}

struct MetaForm {
  std::string type = "MET_UCHAR";
  VoxelType voxel = VoxelType::U8;
  bool big = false, compressed = false, text = false;
  std::string dataFile = "LOCAL";
};

inline std::string metaBytes(const PlainImage& image, const MetaForm& form = {}) {
  const Vec3 spacing = image.step.colwise().norm();
  std::string h =
      fmt::format("ObjectType = Image\nNDims = 3\nBinaryData = {}\n", form.text ? "False" : "True");
  h += fmt::format("BinaryDataByteOrderMSB = {}\nCompressedData = {}\nTransformMatrix =",
                   form.big ? "True" : "False", form.compressed ? "True" : "False");
  for (int axis = 0; axis < 3; ++axis)
    for (int c = 0; c < 3; ++c) h += fmt::format(" {:.17g}", image.step(c, axis) / spacing[axis]);
  h += fmt::format("\nOffset = {:.17g} {:.17g} {:.17g}\nCenterOfRotation = 0 0 0\n",
                   image.origin.x(), image.origin.y(), image.origin.z());
  h += fmt::format("ElementSpacing = {:.17g} {:.17g} {:.17g}\nDimSize = {} {} {}\n", spacing.x(),
                   spacing.y(), spacing.z(), image.dims.x(), image.dims.y(), image.dims.z());
  h += fmt::format("ElementType = {}\nElementDataFile = {}\n", form.type, form.dataFile);
  if (form.dataFile != "LOCAL") return h;
  if (form.text) {
    for (const double value : image.values) h += fmt::format("{} ", value);
    return h;
  }
  const std::string data = voxels(image, form.voxel, form.big);
  return h + (form.compressed ? packed(data, false) : data);
}

}  // namespace resect::test
