#include "formats/export/glb_file.h"

#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>

#include "base/error.h"
#include "io/output/atomic_file.h"
#include "io/output/descriptor_buffer.h"
#include "io/output/output_target.h"
#include "io/output/temporary_file.h"

namespace resect {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little);

// Numbers of the specification.
constexpr int kByte = 5121, kShort = 5123, kInt = 5125, kFloat = 5126;
constexpr int kArrayBuffer = 34962, kElementBuffer = 34963;
constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kDataChunk = 0x004E4942;
constexpr std::uint64_t kMostBytes = std::numeric_limits<std::uint32_t>::max() - (64u << 20);

fs::path scratchBeside(const fs::path& path) {
  const fs::path target = findTarget(path).path;
  std::error_code ec;  // that a folder is missing is said when the file is created
  if (target.has_parent_path()) fs::create_directories(target.parent_path(), ec);
  return target;
}

Json toJson(const Vec3f& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

Vec3f linearColour(const Vec3f& screen) {
  return screen.unaryExpr(
      [](float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); });
}

struct GlbFile::State {
  explicit State(const fs::path& name)
      : path(name), file(scratchBeside(name)), buffer(file.descriptor()) {}

  int add(std::span<const std::byte> bytes, std::size_t count, int component, const char* type,
          int target) {
    require(count > 0, "{}: an accessor of a .glb has no elements; add one at least",
            path.string());
    if (size + bytes.size() + 4 > kMostBytes)
      throw error("{}: would have more than 4 GB, the most that a .glb holds; {}", path.string(),
                  "give a lower --rate, or a part by --from and --to");
    Json view{{"buffer", 0}, {"byteOffset", size}, {"byteLength", bytes.size()}};
    if (target != 0) view["target"] = target;
    views.push_back(std::move(view));
    const auto length = std::streamsize(bytes.size());
    if (buffer.sputn(reinterpret_cast<const char*>(bytes.data()), length) != length)
      requireWritten();
    size += bytes.size();
    for (; size % 4 != 0; ++size) buffer.sputc(0);
    accessors.push_back({{"bufferView", views.size() - 1},
                         {"componentType", component},
                         {"count", count},
                         {"type", type}});
    return int(accessors.size()) - 1;
  }

  template <typename T>
  int add(std::span<const T> values, int component, const char* type, int target) {
    return add(std::as_bytes(values), values.size(), component, type, target);
  }

  // "cannot write": what a write said that failed.
  void requireWritten() {
    if (const int fault = buffer.finish(); fault != 0)
      throw error("cannot write {}: {}; free some space and try again", path.string(),
                  std::strerror(fault));
  }

  fs::path path;
  TemporaryFile file;
  DescriptorBuffer buffer;
  std::uint64_t size = 0;
  Json views = Json::array(), accessors = Json::array(), materials = Json::array(),
       meshes = Json::array(), nodes = Json::array(), roots = Json::array(),
       samplers = Json::array(), channels = Json::array();
};

GlbFile::GlbFile(const fs::path& path) : state_(std::make_unique<State>(path)) {}
GlbFile::~GlbFile() = default;

int GlbFile::addPoints(std::span<const Vec3f> points) {
  const int number = state_->add(points, kFloat, "VEC3", kArrayBuffer);
  Vec3f low = points[0], high = points[0];
  for (const Vec3f& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  Json& accessor = state_->accessors.back();
  accessor["min"] = toJson(low);
  accessor["max"] = toJson(high);
  return number;
}

int GlbFile::addNormals(std::span<const Vec3f> normals) {
  return state_->add(normals, kFloat, "VEC3", kArrayBuffer);
}

int GlbFile::addColours(std::span<const Rgba8> colours) {
  const int number = state_->add(colours, kByte, "VEC4", kArrayBuffer);
  state_->accessors.back()["normalized"] = true;
  return number;
}

int GlbFile::addTriangles(std::span<const Triangle> triangles, std::size_t points) {
  const std::size_t count = 3 * triangles.size();
  // The greatest number of a type restarts strips in some graphics cards: it stays unused.
  if (points >= std::numeric_limits<std::uint16_t>::max())
    return state_->add(std::as_bytes(triangles), count, kInt, "SCALAR", kElementBuffer);
  std::vector<std::uint16_t> corners;
  corners.reserve(count);
  for (const Triangle& t : triangles)
    for (const std::int32_t corner : t) corners.push_back(std::uint16_t(corner));
  return state_->add(std::span<const std::uint16_t>(corners), kShort, "SCALAR", kElementBuffer);
}

int GlbFile::addTimes(std::span<const float> times) {
  const int number = state_->add(times, kFloat, "SCALAR", 0);
  state_->accessors.back()["min"] = Json::array({times.front()});
  state_->accessors.back()["max"] = Json::array({times.back()});
  return number;
}

int GlbFile::addVectors(std::span<const Vec3f> vectors) {
  return state_->add(vectors, kFloat, "VEC3", 0);
}

int GlbFile::addRotations(std::span<const Eigen::Quaterniond> rotations) {
  std::vector<std::array<float, 4>> numbers;
  Eigen::Quaterniond before = Eigen::Quaterniond::Identity();
  for (Eigen::Quaterniond q : rotations) {
    // The same rotation has two signs; viewers may not look for the shorter way.
    if (before.dot(q) < 0) q.coeffs() = -q.coeffs();
    q.normalize();
    numbers.push_back({float(q.x()), float(q.y()), float(q.z()), float(q.w())});
    before = q;
  }
  return state_->add(std::span<const std::array<float, 4>>(numbers), kFloat, "VEC4", 0);
}

int GlbFile::addMaterial(const GlbMaterial& material) {
  const Vec3f& c = material.colour;
  state_->materials.push_back({{"name", material.name},
                               {"pbrMetallicRoughness",
                                {{"baseColorFactor", {c.x(), c.y(), c.z(), 1}},
                                 {"metallicFactor", material.metallic},
                                 {"roughnessFactor", material.roughness}}}});
  return int(state_->materials.size()) - 1;
}

int GlbFile::addMesh(const GlbMesh& mesh) {
  Json attributes{{"POSITION", mesh.points}};
  if (mesh.normals >= 0) attributes["NORMAL"] = mesh.normals;
  if (mesh.colours >= 0) attributes["COLOR_0"] = mesh.colours;
  Json primitive{{"attributes", attributes}, {"indices", mesh.triangles}};
  if (mesh.material >= 0) primitive["material"] = mesh.material;
  state_->meshes.push_back({{"name", mesh.name}, {"primitives", Json::array({primitive})}});
  return int(state_->meshes.size()) - 1;
}

int GlbFile::addNode(const GlbNode& node) {
  const Vec3& p = node.pose.position;
  const Eigen::Quaterniond q = node.pose.rotation.normalized();
  Json json{{"name", node.name}};
  if (node.mesh >= 0) json["mesh"] = node.mesh;
  if (!node.children.empty()) json["children"] = node.children;
  if (p != Vec3::Zero()) json["translation"] = {float(p.x()), float(p.y()), float(p.z())};
  if (q.vec() != Vec3::Zero())
    json["rotation"] = {float(q.x()), float(q.y()), float(q.z()), float(q.w())};
  if (!node.shown) json["scale"] = {0, 0, 0};
  state_->nodes.push_back(std::move(json));
  return int(state_->nodes.size()) - 1;
}

void GlbFile::addToScene(int node) { state_->roots.push_back(node); }

void GlbFile::animate(int node, Motion motion, int times, int values) {
  state_->samplers.push_back({{"input", times},
                              {"interpolation", motion == Motion::Shown ? "STEP" : "LINEAR"},
                              {"output", values}});
  const char* path = motion == Motion::Translation ? "translation"
                     : motion == Motion::Rotation  ? "rotation"
                                                   : "scale";
  state_->channels.push_back(
      {{"sampler", state_->samplers.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
}

std::uint64_t GlbFile::finish() {
  State& s = *state_;
  s.requireWritten();
  Json json{{"asset", {{"version", "2.0"}, {"generator", "Resect"}}},
            {"scene", 0},
            {"scenes", Json::array({{{"nodes", s.roots}}})},
            {"nodes", s.nodes},
            {"meshes", s.meshes},
            {"materials", s.materials}};
  if (!s.channels.empty())
    json["animations"] =
        Json::array({{{"name", "operation"}, {"channels", s.channels}, {"samplers", s.samplers}}});
  json["accessors"] = s.accessors;
  json["bufferViews"] = s.views;
  json["buffers"] = Json::array({{{"byteLength", s.size}}});
  std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::uint64_t total = 12 + 8 + text.size() + 8 + s.size;
  if (total > std::numeric_limits<std::uint32_t>::max())
    throw error("{}: would have more than 4 GB, the most that a .glb holds; give a lower --rate",
                s.path.string());

  writeFileAtomically(s.path, [&](std::ostream& out) {
    const auto number = [&](std::uint64_t value) {
      const auto bytes = std::bit_cast<std::array<char, 4>>(std::uint32_t(value));
      out.write(bytes.data(), bytes.size());
    };
    number(kMagic), number(2), number(total);
    number(text.size()), number(kJsonChunk);
    out << text;
    number(s.size), number(kDataChunk);
    std::vector<char> block(1 << 20);
    for (std::uint64_t at = 0; at < s.size;) {
      const ssize_t got = ::pread(s.file.descriptor(), block.data(), block.size(), off_t(at));
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0)
        throw error("cannot write {}: what was kept for it cannot be read again; try again",
                    s.path.string());
      out.write(block.data(), got);
      at += std::uint64_t(got);
    }
  });
  return total;
}

}  // namespace resect
