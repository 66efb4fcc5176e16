#include "io/mesh_file.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cctype>
#include <cstring>
#include <iterator>
#include <limits>
#include <ostream>

#include "base/error.h"
#include "base/stop.h"
#include "io/output/atomic_file.h"
#include "io/output/output_target.h"

namespace resect {
namespace {

static_assert(std::endian::native == std::endian::little);

using Writer = void (*)(std::ostream&, const TriangleMesh&);

// Buffers a file's bytes and writes them in large blocks.
class Buffer {
 public:
  explicit Buffer(std::ostream& out) : out_(out) {}
  ~Buffer() { flush(); }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  template <typename... Args>
  void print(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(bytes_), format, std::forward<Args>(args)...);
    flushFull();
  }
  template <typename T>
  void raw(T value) {
    append(value, false);
  }
  template <typename T>
  void rawBigEndian(T value) {
    append(value, true);
  }

 private:
  static constexpr std::size_t kBlock = 1 << 18;
  template <typename T>
  void append(T value, bool reversed) {
    char data[sizeof(T)];
    std::memcpy(data, &value, sizeof(T));
    if (reversed) std::reverse(std::begin(data), std::end(data));
    bytes_.append(data, sizeof(T));
    flushFull();
  }
  void flushFull() {
    if (bytes_.size() <= kBlock) return;
    checkStop();
    flush();
  }
  void flush() {
    out_.write(bytes_.data(), std::streamsize(bytes_.size()));
    bytes_.clear();
  }
  std::ostream& out_;
  std::string bytes_;
};

void writeObj(std::ostream& out, const TriangleMesh& mesh) {
  Buffer b(out);
  b.print("# Resect, metres\n");
  for (const Vec3& p : mesh.points) b.print("v {} {} {}\n", p.x(), p.y(), p.z());
  for (const Triangle& t : mesh.triangles) b.print("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
}

void writeStl(std::ostream& out, const TriangleMesh& mesh) {
  Buffer b(out);
  b.print("{:<80}", "Resect, metres");
  b.raw(std::uint32_t(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    const Vec3 normal =
        (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]);
    const double length = normal.norm();
    const Vec3f unit = length > 0 ? Vec3f((normal / length).cast<float>()) : Vec3f(Vec3f::Zero());
    for (int k = 0; k < 3; ++k) b.raw(unit[k]);
    for (const std::int32_t i : t)
      for (int k = 0; k < 3; ++k) b.raw(float(mesh.points[i][k]));
    b.raw(std::uint16_t(0));
  }
}

void writePly(std::ostream& out, const TriangleMesh& mesh) {
  Buffer b(out);
  b.print(
      "ply\nformat binary_little_endian 1.0\ncomment Resect, metres\nelement vertex {}\n"
      "property double x\nproperty double y\nproperty double z\nelement face {}\n"
      "property list uchar int vertex_indices\nend_header\n",
      mesh.points.size(), mesh.triangles.size());
  for (const Vec3& p : mesh.points)
    for (int k = 0; k < 3; ++k) b.raw(p[k]);
  for (const Triangle& t : mesh.triangles) {
    b.raw(std::uint8_t(3));
    for (const std::int32_t i : t) b.raw(i);
  }
}

void writeVtk(std::ostream& out, const TriangleMesh& mesh) {
  Buffer b(out);
  b.print("# vtk DataFile Version 3.0\nResect, metres\nBINARY\nDATASET POLYDATA\n");
  b.print("POINTS {} double\n", mesh.points.size());
  for (const Vec3& p : mesh.points)
    for (int k = 0; k < 3; ++k) b.rawBigEndian(p[k]);
  b.print("\nPOLYGONS {} {}\n", mesh.triangles.size(), 4 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    b.rawBigEndian(std::int32_t(3));
    for (const std::int32_t i : t) b.rawBigEndian(i);
  }
  b.print("\n");
}

void writeIv(std::ostream& out, const TriangleMesh& mesh) {
  Buffer b(out);
  b.print(
      "#Inventor V2.1 ascii\n\nSeparator {{\n"
      "  Units {{ units METERS }}\n"
      "  ShapeHints {{ vertexOrdering COUNTERCLOCKWISE faceType CONVEX creaseAngle 0.5 }}\n"
      "  Coordinate3 {{ point [\n");
  for (const Vec3& p : mesh.points) b.print("    {} {} {},\n", p.x(), p.y(), p.z());
  b.print("  ] }}\n  IndexedFaceSet {{ coordIndex [\n");
  for (const Triangle& t : mesh.triangles) b.print("    {}, {}, {}, -1,\n", t[0], t[1], t[2]);
  b.print("  ] }}\n}}\n");
}

Writer writerFor(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".obj") return writeObj;
  if (extension == ".stl") return writeStl;
  if (extension == ".ply") return writePly;
  if (extension == ".vtk") return writeVtk;
  if (extension == ".iv") return writeIv;
  const bool stream = extension.empty() && findTarget(path).kind != OutputTarget::Kind::File;
  return stream ? writeObj : nullptr;
}

}  // namespace

void checkWritableMeshFile(const std::filesystem::path& path) {
  if (!writerFor(path))
    throw usageError("cannot write a surface as {}; use .obj, .stl, .ply, .vtk or .iv",
                     path.string());
  findTarget(path);
}

void writeMeshFile(const std::filesystem::path& path, const TriangleMesh& mesh) {
  checkWritableMeshFile(path);
  // Some formats hold 32-bit numbers.
  constexpr double kMost = std::numeric_limits<float>::max();
  for (const Vec3& p : mesh.points)
    if (!(p.array().abs() <= kMost).all())
      throw error(
          "{} is not written: the surface has a point ({:g}, {:g}, {:g}) m, which is nowhere; "
          "check unit and poses",
          path.string(), p.x(), p.y(), p.z());
  writeFileAtomically(path, [&](std::ostream& out) { writerFor(path)(out, mesh); });
}

}  // namespace resect
