#include "record/export/glb_export.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "formats/export/glb_file.h"

namespace resect {
namespace {

using Motion = GlbFile::Motion;

// An organ as a row of meshes, each shown for a while.
class OrganAnimation {
 public:
  OrganAnimation(GlbFile& file, std::string name, const OrganColours& colours)
      : file_(file), name_(std::move(name)) {
    const Vec3f capsule = linearColour(colours.capsule), cut = linearColour(colours.cut);
    // A point's colour is a factor of 8 bits: of the greater of the two, it is fine enough.
    const Vec3f most = capsule.cwiseMax(cut).cwiseMax(1e-3f);
    capsule_ = capsule.cwiseQuotient(most);
    cut_ = cut.cwiseQuotient(most);
    material_ = file.addMaterial({name_, most, 0, 0.35f});
  }

  void follow(const OperatedOrgan& organ, float time) {
    SurfaceTracker::Compact now = organ.organ.surface.compact(organ.points(), organ.normals());
    std::vector<Vec3f> points;
    points.reserve(now.mesh.points.size());
    for (const Vec3& p : now.mesh.points) points.push_back(p.cast<float>());
    const std::vector<Rgba8> colours = coloursOf(now.cut);
    const bool sameTriangles = now.mesh.triangles == triangles_ && points.size() == points_.size();
    if (sameTriangles && points == points_ && colours == colours_) return;
    if (!sameTriangles) triangleData_ = -1;
    if (colours != colours_) colourData_ = -1;
    points_ = std::move(points);
    triangles_ = std::move(now.mesh.triangles);
    colours_ = colours;
    // Nothing is left of it: the mesh before is hidden, and none takes its place.
    const int mesh = triangles_.empty() ? -1 : addMesh(now.normals);
    from_.push_back(time);
    nodes_.push_back(mesh < 0 ? -1 : file_.addNode({numbered(), {}, from_.size() == 1, mesh}));
  }

  // Adds the node of the organ, with the animation of what it shows.
  void finish() {
    std::vector<int> children;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i] < 0) continue;
      children.push_back(nodes_[i]);
      if (nodes_.size() == 1) break;
      std::vector<float> times;
      std::vector<Vec3f> scales;
      const auto key = [&](float time, bool shown) {
        times.push_back(time);
        scales.push_back(Vec3f::Constant(shown ? 1.0f : 0.0f));
      };
      if (i > 0) key(0, false);
      key(from_[i], true);
      if (i + 1 < nodes_.size()) key(from_[i + 1], false);
      file_.animate(nodes_[i], Motion::Shown, file_.addTimes(times), file_.addVectors(scales));
    }
    if (!children.empty()) file_.addToScene(file_.addNode({name_, {}, true, -1, children}));
  }

  std::int64_t surfaces() const {
    return std::ranges::count_if(nodes_, [](int n) { return n >= 0; });
  }

 private:
  std::string numbered() const { return fmt::format("{} {:04}", name_, from_.size()); }

  std::vector<Rgba8> coloursOf(std::span<const float> cut) const {
    std::vector<Rgba8> colours;
    colours.reserve(cut.size());
    for (const float share : cut) {
      // As in the pictures: the edge of a wound is narrower than a cell.
      const float x = std::clamp((share - 0.38f) / 0.24f, 0.0f, 1.0f), t = x * x * (3 - 2 * x);
      const Vec3f c = 255 * ((1 - t) * capsule_ + t * cut_);
      colours.push_back({std::uint8_t(std::lround(c.x())), std::uint8_t(std::lround(c.y())),
                         std::uint8_t(std::lround(c.z())), 255});
    }
    return colours;
  }

  int addMesh(const std::vector<Vec3f>& normals) {
    if (triangleData_ < 0) triangleData_ = file_.addTriangles(triangles_, points_.size());
    if (colourData_ < 0) colourData_ = file_.addColours(colours_);
    GlbMesh mesh{name_, file_.addPoints(points_), triangleData_};
    mesh.normals = file_.addNormals(normals);
    mesh.colours = colourData_;
    mesh.material = material_;
    return file_.addMesh(mesh);
  }

  GlbFile& file_;
  std::string name_;
  Vec3f capsule_, cut_;
  int material_;
  std::vector<float> from_;  // s: since when each node is shown
  std::vector<int> nodes_;   // -1: nothing
  // What was shown last, and the data that the next mesh can share.
  std::vector<Vec3f> points_;
  std::vector<Triangle> triangles_;
  std::vector<Rgba8> colours_;
  int triangleData_ = -1, colourData_ = -1;
};

int addPart(GlbFile& file, const std::string& name, const DrawnPart& part, const Vec3& origin) {
  std::vector<Vec3f> points;
  for (const Vec3& p : part.mesh.points) points.push_back((p - origin).cast<float>());
  const Finish finish = part.finish.value_or(Finish());
  const bool metal = finish.specular.mean() > 0.25f;
  GlbMesh mesh{name, file.addPoints(points), file.addTriangles(part.mesh.triangles, points.size())};
  if (!part.normals.empty()) mesh.normals = file.addNormals(part.normals);
  mesh.material = file.addMaterial(
      {name, linearColour(finish.diffuse), metal ? 0.9f : 0.0f, metal ? 0.35f : 0.6f});
  return file.addMesh(mesh);
}

// An instrument: a node that moves, with jaws that turn about their pivot.
class ToolAnimation {
 public:
  ToolAnimation(GlbFile& file, const ToolModel& model) : file_(file), model_(model) {
    if (model.drawn.empty()) add({model.mesh});
    for (const DrawnPart& part : model.drawn) add(part);
  }

  void follow(const Pose& pose, double squeeze) {
    positions_.push_back(pose.position.cast<float>());
    rotations_.push_back(pose.rotation);
    squeezes_.push_back(squeeze);
  }

  void finish(int times) {
    const int node = file_.addNode(
        {model_.name, {positions_[0].cast<double>(), rotations_[0]}, true, -1, children_});
    file_.addToScene(node);
    file_.animate(node, Motion::Translation, times, file_.addVectors(positions_));
    file_.animate(node, Motion::Rotation, times, file_.addRotations(rotations_));
    for (const Jaw& jaw : jaws_) {
      std::vector<Eigen::Quaterniond> turns;
      for (const double squeeze : squeezes_)
        turns.push_back(rotationAbout(model_.jaws.axis, (1 - squeeze) * jaw.opens));
      file_.animate(jaw.node, Motion::Rotation, times, file_.addRotations(turns));
    }
  }

 private:
  struct Jaw {
    int node;
    double opens;
  };

  void add(const DrawnPart& part) {
    if (part.mesh.triangles.empty()) return;
    const bool jaw = part.opens != 0;
    const Vec3 origin = jaw ? model_.jaws.pivot : Vec3(Vec3::Zero());
    const std::string name = fmt::format("{} {}", model_.name, children_.size() + 1);
    GlbNode node;
    node.name = name;
    node.pose.position = origin;
    node.mesh = addPart(file_, name, part, origin);
    children_.push_back(file_.addNode(node));
    if (jaw) jaws_.push_back({children_.back(), part.opens});
  }

  GlbFile& file_;
  const ToolModel& model_;
  std::vector<int> children_;
  std::vector<Jaw> jaws_;
  std::vector<Vec3f> positions_;
  std::vector<Eigen::Quaterniond> rotations_;
  std::vector<double> squeezes_;
};

}  // namespace

GlbSummary exportGlb(Replay& replay, const ExportedPart& part,
                     std::span<const OrganColours> colours, const std::filesystem::path& path,
                     const Progress& progress) {
  const Simulation& simulation = replay.simulation();
  require(colours.size() == simulation.organs().size(),
          "{} colours are given for {} organs; give one for each", colours.size(),
          simulation.organs().size());
  const Scenario& scenario = replay.setup().scenario;
  GlbFile file(path);
  std::vector<OrganAnimation> organs;
  for (std::size_t o = 0; o < colours.size(); ++o)
    organs.emplace_back(file, simulation.organs()[o].name, colours[o]);
  std::vector<ToolAnimation> tools;
  for (const ToolModel& model : replay.setup().tools) tools.emplace_back(file, model);

  std::vector<float> times;
  const std::int64_t first = part.course.front().first;
  playMoments(
      replay, part, true,
      [&](const Simulation& now) {
        times.push_back(float(double(now.frame() - first) / scenario.frameRate));
        for (std::size_t o = 0; o < organs.size(); ++o)
          organs[o].follow(now.organs()[o], times.back());
        for (std::size_t t = 0; t < tools.size(); ++t) {
          // Before the first frame no input has placed them yet.
          const bool placed = now.frame() > 0 || t >= scenario.tools.size();
          tools[t].follow(placed ? now.tools()[t].pose() : scenario.tools[t].rest,
                          now.tools()[t].way.to.squeeze);
        }
      },
      progress);

  GlbSummary summary;
  summary.moments = std::int64_t(times.size());
  const int timeData = file.addTimes(times);
  for (OrganAnimation& organ : organs) {
    organ.finish();
    summary.surfaces += organ.surfaces();
  }
  for (ToolAnimation& tool : tools) tool.finish(timeData);
  summary.bytes = file.finish();
  return summary;
}

}  // namespace resect
