#include "io/model.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/error.h"

namespace resect {
namespace {

constexpr double kLargestCoordinate = 1e9;  // m; beyond it a double no longer resolves 0.1 um

// Names from foreign files are shown in one-line messages.
std::string printable(std::string_view name) {
  constexpr std::size_t kLongest = 60;
  std::string text;
  for (const char c : name.substr(0, kLongest)) text += (c >= 0 && c < ' ') || c == 127 ? '?' : c;
  if (name.size() > kLongest) text += "...";
  return text;
}

template <typename T>
void put(std::string& bytes, const T* values, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

void putText(std::string& bytes, const std::string& text) {
  const std::uint64_t size = text.size();
  put(bytes, &size, 1);
  bytes += text;
}

class ByteReader {
 public:
  ByteReader(std::string_view bytes, const std::string& path) : bytes_(bytes), path_(path) {}

  // `count` values of type T; Error if the bytes end before.
  template <typename T>
  void take(T* values, std::uint64_t count) {
    if (count > bytes_.size() / sizeof(T)) throw broken();
    if (count > 0) std::memcpy(static_cast<void*>(values), bytes_.data(), count * sizeof(T));
    bytes_.remove_prefix(count * sizeof(T));
  }
  std::uint64_t takeCount(std::size_t bytesEach) {
    std::uint64_t count = 0;
    take(&count, 1);
    if (count > bytes_.size() / bytesEach) throw broken();
    return count;
  }
  std::string takeText() {
    std::string text(takeCount(1), '\0');
    take(text.data(), text.size());
    return text;
  }
  void expectEnd() const {
    if (!bytes_.empty()) throw broken();
  }

 private:
  Error broken() const {
    return error("{}: its reader was damaged by the file; export it again", path_);
  }
  std::string_view bytes_;
  const std::string& path_;
};

}  // namespace

TriangleMesh merged(const Model& model) {
  TriangleMesh mesh;
  for (const ModelPart& part : model.parts) append(mesh, part.mesh);
  return mesh;
}

void addToPart(Model& model, const std::string& name, TriangleMesh mesh) {
  if (mesh.triangles.empty()) return;
  const auto part = std::find_if(model.parts.begin(), model.parts.end(),
                                 [&](const ModelPart& p) { return p.name == name; });
  if (part == model.parts.end())
    model.parts.push_back({name, std::move(mesh)});
  else
    append(part->mesh, mesh);
}

const ModelPart& partNamed(const Model& model, const std::string& name) {
  for (const ModelPart& part : model.parts)
    if (part.name == name) return part;
  throw error("{} has no part '{}'; choose one of: {}", model.path, printable(name),
              partList(model));
}

std::string partList(const Model& model, std::size_t most) {
  std::string list;
  const std::size_t count = model.parts.size();
  const std::size_t shown = count > most ? most : count;
  for (std::size_t i = 0; i < shown; ++i) {
    if (i > 0) list += ", ";
    list += model.parts[i].name.empty() ? "(no name)" : printable(model.parts[i].name);
  }
  if (shown < count) list += fmt::format(" and {} more", count - shown);
  return list;
}

void checkModel(const Model& model) {
  std::size_t triangles = 0;
  for (const ModelPart& part : model.parts) {
    const auto points = std::int32_t(part.mesh.points.size());
    const std::string where =
        part.name.empty() ? "the mesh" : fmt::format("part '{}'", printable(part.name));
    triangles += part.mesh.triangles.size();
    for (const Vec3& p : part.mesh.points)
      if (!p.allFinite() || p.cwiseAbs().maxCoeff() > kLargestCoordinate)
        throw error(
            "{}: {} has the point ({:g}, {:g}, {:g}), which is no place; export the "
            "model again",
            model.path, where, p.x(), p.y(), p.z());
    for (const Triangle& t : part.mesh.triangles)
      for (const std::int32_t i : t)
        if (i < 0 || i >= points)
          throw error(
              "{}: {} has a triangle with point {} of only {}; export the model "
              "again",
              model.path, where, i, points);
  }
  if (triangles == 0)
    throw error("{}: there are no triangles in it; choose a file that holds a surface", model.path);
}

std::string modelToBytes(const Model& model) {
  std::size_t size = 2 * sizeof(std::uint64_t) + model.format.size();
  for (const ModelPart& part : model.parts)
    size += 3 * sizeof(std::uint64_t) + part.name.size() + part.mesh.points.size() * sizeof(Vec3) +
            part.mesh.triangles.size() * sizeof(Triangle);
  std::string bytes;
  bytes.reserve(size);
  putText(bytes, model.format);
  const std::uint64_t parts = model.parts.size();
  put(bytes, &parts, 1);
  for (const ModelPart& part : model.parts) {
    putText(bytes, part.name);
    const std::uint64_t points = part.mesh.points.size(), triangles = part.mesh.triangles.size();
    put(bytes, &points, 1);
    put(bytes, part.mesh.points.data(), points);
    put(bytes, &triangles, 1);
    put(bytes, part.mesh.triangles.data(), triangles);
  }
  return bytes;
}

Model bytesToModel(std::string_view bytes, const std::string& path) {
  Model model;
  model.path = path;
  ByteReader reader(bytes, path);
  model.format = reader.takeText();
  model.parts.resize(reader.takeCount(3 * sizeof(std::uint64_t)));
  for (ModelPart& part : model.parts) {
    part.name = reader.takeText();
    part.mesh.points.resize(reader.takeCount(sizeof(Vec3)));
    reader.take(part.mesh.points.data(), part.mesh.points.size());
    part.mesh.triangles.resize(reader.takeCount(sizeof(Triangle)));
    reader.take(part.mesh.triangles.data(), part.mesh.triangles.size());
  }
  reader.expectEnd();
  checkModel(model);
  return model;
}

}  // namespace resect
