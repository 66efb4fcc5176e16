#include "io/plain_mesh.h"

#include <algorithm>
#include <cstring>

#include "base/error.h"
#include "base/text/shown_text.h"
#include "io/whole_file.h"

namespace resect {
namespace {

constexpr const char* kForm = "use a .ply that Resect wrote (resect convert FILE OTHER.ply)";

// A line of the header, without its end.
std::string_view takeLine(std::string_view& bytes, const std::string& path) {
  const std::size_t end = bytes.find('\n');
  if (end == std::string_view::npos) throw error("{} ends within its header; {}", path, kForm);
  const std::string_view line = bytes.substr(0, end);
  bytes.remove_prefix(end + 1);
  return line;
}

// The number in "element vertex 12".
std::size_t takeCount(std::string_view& bytes, std::string_view words, const std::string& path) {
  const std::string_view line = takeLine(bytes, path);
  std::size_t count = 0;
  const std::string_view digits = line.substr(std::min(words.size(), line.size()));
  bool fine = line.starts_with(words) && !digits.empty() && digits.size() < 10;
  for (const char c : digits) {
    fine = fine && c >= '0' && c <= '9';
    count = 10 * count + std::size_t(c - '0');
  }
  if (!fine)
    throw error("{} has \"{}\" where \"{}NUMBER\" belongs; {}", path, shownText(line, 60), words,
                kForm);
  return count;
}

void expect(std::string_view& bytes, std::string_view text, const std::string& path) {
  if (!bytes.starts_with(text)) throw error("{} is no .ply as Resect writes it; {}", path, kForm);
  bytes.remove_prefix(text.size());
}

}  // namespace

Model readPlainMesh(const std::filesystem::path& path, const std::string& /*parts*/) {
  const std::filesystem::path file = std::filesystem::path(path).replace_extension(".ply");
  const std::string name = file.string();
  if (!std::filesystem::exists(file)) throw error("there is no plain mesh {}; {}", name, kForm);
  return parsePlainMesh(readWholeFile(file), name);
}

Model parsePlainMesh(std::string_view bytes, const std::string& name) {
  expect(bytes, "ply\nformat binary_little_endian 1.0\ncomment Resect, metres\n", name);
  const std::size_t points = takeCount(bytes, "element vertex ", name);
  expect(bytes, "property double x\nproperty double y\nproperty double z\n", name);
  const std::size_t triangles = takeCount(bytes, "element face ", name);
  expect(bytes, "property list uchar int vertex_indices\nend_header\n", name);
  constexpr std::size_t kPoint = 3 * sizeof(double), kTriangle = 1 + sizeof(Triangle);
  if (bytes.size() != points * kPoint + triangles * kTriangle)
    throw error("{} holds {} bytes after its header and needs {}: it is cut off or damaged; {}",
                name, bytes.size(), points * kPoint + triangles * kTriangle, kForm);
  TriangleMesh mesh;
  mesh.points.resize(points);
  for (Vec3& p : mesh.points) {
    std::memcpy(p.data(), bytes.data(), kPoint);
    bytes.remove_prefix(kPoint);
  }
  mesh.triangles.resize(triangles);
  for (Triangle& t : mesh.triangles) {
    if (bytes[0] != 3)
      throw error("{} has a face of {} corners; {}", name, int(std::uint8_t(bytes[0])), kForm);
    std::memcpy(t.data(), bytes.data() + 1, sizeof(Triangle));
    bytes.remove_prefix(kTriangle);
  }
  Model model{name, "PLY", {{"", std::move(mesh)}}};
  checkModel(model);
  return model;
}

}  // namespace resect
