#include "io/model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <utility>

#include "base/error.h"
#include "base/text/shown_text.h"

namespace resect {
namespace {

constexpr double kLargestCoordinate = 1e9;  // m; beyond it a double no longer resolves 0.1 um

template <typename T>
void put(std::string& bytes, const T* values, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

void putText(std::string& bytes, const std::string& text) {
  const std::uint64_t size = text.size();
  put(bytes, &size, 1);
  bytes += text;
}

class PipeReader {
 public:
  PipeReader(std::string_view bytes, const std::string& path) : bytes_(bytes), path_(path) {}

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
  // Whether something optional follows.
  bool takeFlag() {
    std::uint8_t flag = 0;
    take(&flag, 1);
    if (flag > 1) throw broken();
    return flag == 1;
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

void putFlag(std::string& bytes, bool flag) { bytes += char(flag); }

// Numbers of a finish, of a pose, of places without their tools: as they cross the pipe.
using FinishNumbers = std::array<float, 7>;
using PoseNumbers = std::array<double, 7>;

FinishNumbers numbersOf(const Finish& f) {
  return {f.diffuse.x(),  f.diffuse.y(),  f.diffuse.z(), f.specular.x(),
          f.specular.y(), f.specular.z(), f.shininess};
}

Finish finishOf(const FinishNumbers& n) {
  return {Vec3f(n[0], n[1], n[2]), Vec3f(n[3], n[4], n[5]), n[6]};
}

void putPose(std::string& bytes, const Pose& pose) {
  const Vec3& p = pose.position;
  const Eigen::Quaterniond& q = pose.rotation;
  const PoseNumbers n{p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()};
  put(bytes, n.data(), n.size());
}

Pose takePose(PipeReader& reader) {
  PoseNumbers n;
  reader.take(n.data(), n.size());
  return {Vec3(n[0], n[1], n[2]), Eigen::Quaterniond(n[3], n[4], n[5], n[6])};
}

void putPlaces(std::string& bytes, const ScenePlaces& places) {
  const std::uint64_t tools = places.tools.size();
  put(bytes, &tools, 1);
  for (const Pose& tool : places.tools) putPose(bytes, tool);
  putPose(bytes, places.camera);
  put(bytes, &places.heightAngle, 1);
  put(bytes, &places.focalDistance, 1);
}

ScenePlaces takePlaces(PipeReader& reader) {
  ScenePlaces places;
  places.tools.resize(reader.takeCount(sizeof(PoseNumbers)));
  for (Pose& tool : places.tools) tool = takePose(reader);
  places.camera = takePose(reader);
  reader.take(&places.heightAngle, 1);
  reader.take(&places.focalDistance, 1);
  return places;
}

void checkLook(const ModelPart& part, const std::string& path, const std::string& where) {
  constexpr float kRounding = 1e-3f;
  if (!part.normals.empty() && part.normals.size() != part.mesh.points.size())
    throw error("{}: {} has {} normals for {} points; export the model again", path, where,
                part.normals.size(), part.mesh.points.size());
  for (const Vec3f& n : part.normals)
    if (!(n.isZero(0) || std::abs(n.norm() - 1) < kRounding))
      throw error(
          "{}: {} has the normal ({:g}, {:g}, {:g}), which is no direction; export the "
          "model again",
          path, where, n.x(), n.y(), n.z());
  if (!part.finish) return;
  for (const float number : numbersOf(*part.finish))
    if (!(number >= 0 && number <= 1))
      throw error(
          "{}: the material of {} has the number {:g}, which is not between 0 and 1; "
          "export the model again",
          path, where, number);
}

void checkPlace(const Pose& pose, const std::string& path, const std::string& what) {
  constexpr double kFarthest = 1e6;  // m
  if (!isFinite(pose) || pose.position.cwiseAbs().maxCoeff() > kFarthest ||
      std::abs(pose.rotation.norm() - 1) > 1e-6)
    throw error("{}: the place of {} in the saved scene is out of range; save the scene again",
                path, what);
}

void checkPlaces(const ScenePlaces& places, const std::string& path) {
  if (places.tools.size() > kMostSceneTools)
    throw error("{}: the saved scene has more than {} tools; remove some", path, kMostSceneTools);
  for (std::size_t i = 0; i < places.tools.size(); ++i)
    checkPlace(places.tools[i], path, fmt::format("tool {}", i + 1));
  checkPlace(places.camera, path, "the camera");
  const double angle = places.heightAngle, distance = places.focalDistance;
  if (!(angle >= 1e-3 && angle <= std::numbers::pi - 1e-3))
    throw error("{}: the camera of the saved scene has an angle of {:g} rad; save the scene again",
                path, angle);
  if (!(distance >= 1e-6 && distance <= 1e6))
    throw error(
        "{}: the camera of the saved scene looks at a distance of {:g} m; save the scene again",
        path, distance);
}

}  // namespace

TriangleMesh merged(const Model& model) {
  TriangleMesh mesh;
  for (const ModelPart& part : model.parts) append(mesh, part.mesh);
  return mesh;
}

void addToPart(Model& model, const std::string& name, TriangleMesh mesh) {
  addToPart(model, ModelPart{name, std::move(mesh)});
}

void addToPart(Model& model, ModelPart piece) {
  if (piece.mesh.triangles.empty()) return;
  const auto part = std::ranges::find(model.parts, piece.name, &ModelPart::name);
  if (part == model.parts.end()) {
    model.parts.push_back(std::move(piece));
    return;
  }
  if (!part->normals.empty() || !piece.normals.empty()) {
    piece.normals.resize(piece.mesh.points.size(), Vec3f::Zero());
    part->normals.resize(part->mesh.points.size(), Vec3f::Zero());
    part->normals.insert(part->normals.end(), piece.normals.begin(), piece.normals.end());
  }
  append(part->mesh, piece.mesh);
}

std::vector<std::string> partNames(const std::string& lines) {
  std::vector<std::string> names;
  if (lines.empty()) return names;
  for (std::size_t begin = 0, end = 0; end != lines.npos; begin = end + 1) {
    end = lines.find('\n', begin);
    names.push_back(lines.substr(begin, end - begin));
  }
  return names;
}

std::string partLines(const std::vector<std::string>& names) {
  std::string lines;
  for (const std::string& name : names) lines += (lines.empty() ? "" : "\n") + name;
  return lines;
}

void leaveOut(std::string& lines, const std::string& out) {
  std::vector<std::string> all = partNames(lines);
  for (const std::string& name : partNames(out)) {
    const std::string line = std::string(kWithout) + name;
    if (std::ranges::count(all, line) == 0) all.push_back(line);
  }
  lines = partLines(all);
}

Model chosenParts(const Model& model, const std::string& lines) {
  if (lines.empty() || (model.parts.size() == 1 && model.parts[0].name == lines)) return model;
  std::vector<std::string> names, out;
  for (const std::string& line : partNames(lines)) {
    // A part may have a name that begins so.
    const bool without =
        line.starts_with(kWithout) &&
        std::ranges::find(model.parts, line, &ModelPart::name) == model.parts.end();
    (without ? out : names).push_back(without ? line.substr(kWithout.size()) : line);
    partNamed(model, (without ? out : names).back());
  }
  Model chosen{model.path, model.format, {}};
  for (const ModelPart& part : model.parts)
    if ((names.empty() || std::ranges::count(names, part.name) > 0) &&
        std::ranges::count(out, part.name) == 0)
      chosen.parts.push_back(part);
  if (chosen.parts.empty())
    throw error(
        "{}: no part is left for the organ's surface; give some of its parts no other role: {}",
        model.path, partList(model));
  return chosen;
}

const ModelPart& partNamed(const Model& model, const std::string& name) {
  for (const ModelPart& part : model.parts)
    if (part.name == name) return part;
  if (std::ranges::all_of(model.parts, [](const ModelPart& part) { return part.name.empty(); }))
    throw error("{} has no part '{}', nor any part with a name", model.path,
                shownText(name, kLongestName));
  throw error("{} has no part '{}'; choose one of: {}", model.path, shownText(name, kLongestName),
              partList(model));
}

std::string partList(const Model& model, std::size_t most) {
  std::string list;
  const std::size_t count = model.parts.size();
  const std::size_t shown = count > most ? most : count;
  for (std::size_t i = 0; i < shown; ++i) {
    if (i > 0) list += ", ";
    list +=
        model.parts[i].name.empty() ? "(no name)" : shownText(model.parts[i].name, kLongestName);
  }
  if (shown < count) list += fmt::format(" and {} more", count - shown);
  return list;
}

void checkModel(const Model& model) {
  std::size_t triangles = 0;
  for (const ModelPart& part : model.parts) {
    const auto points = std::int32_t(part.mesh.points.size());
    const std::string where = part.name.empty()
                                  ? "the mesh"
                                  : fmt::format("part '{}'", shownText(part.name, kLongestName));
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
    checkLook(part, model.path, where);
  }
  if (triangles == 0)
    throw error("{}: there are no triangles in it; choose a file that holds a surface", model.path);
  if (model.places) checkPlaces(*model.places, model.path);
}

std::string modelToBytes(const Model& model) {
  std::size_t size = 4096 + model.format.size();
  for (const ModelPart& part : model.parts)
    size += 128 + part.name.size() + part.mesh.points.size() * sizeof(Vec3) +
            part.mesh.triangles.size() * sizeof(Triangle) + part.normals.size() * sizeof(Vec3f);
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
    const std::uint64_t normals = part.normals.size();
    put(bytes, &normals, 1);
    put(bytes, part.normals.data(), normals);
    putFlag(bytes, part.finish.has_value());
    if (part.finish) put(bytes, numbersOf(*part.finish).data(), FinishNumbers().size());
  }
  putFlag(bytes, model.places.has_value());
  if (model.places) putPlaces(bytes, *model.places);
  return bytes;
}

Model bytesToModel(std::string_view bytes, const std::string& path) {
  Model model;
  model.path = path;
  PipeReader reader(bytes, path);
  model.format = reader.takeText();
  model.parts.resize(reader.takeCount(4 * sizeof(std::uint64_t)));
  for (ModelPart& part : model.parts) {
    part.name = reader.takeText();
    part.mesh.points.resize(reader.takeCount(sizeof(Vec3)));
    reader.take(part.mesh.points.data(), part.mesh.points.size());
    part.mesh.triangles.resize(reader.takeCount(sizeof(Triangle)));
    reader.take(part.mesh.triangles.data(), part.mesh.triangles.size());
    part.normals.resize(reader.takeCount(sizeof(Vec3f)));
    reader.take(part.normals.data(), part.normals.size());
    if (FinishNumbers numbers; reader.takeFlag()) {
      reader.take(numbers.data(), numbers.size());
      part.finish = finishOf(numbers);
    }
  }
  if (reader.takeFlag()) model.places = takePlaces(reader);
  reader.expectEnd();
  checkModel(model);
  return model;
}

}  // namespace resect
