#include "collision/inside.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.h"
#include "base/parallel.h"
#include "collision/columns.h"
#include "geometry/moved_box.h"
#include "geometry/rotation.h"

namespace resect {
namespace {

constexpr double kLargestTurn = 2 * std::numbers::pi / 180;  // per step
constexpr double kChordError = 1e-4;                         // of the tool's diagonal
constexpr int kMostSteps = 4096;
constexpr double kSnap = 0x1p-32;  // m, 0.2 nm
constexpr double kNoTurn = 1e-9;   // rad: rotations closer than this are the same

bool meets(const Aabb& box, const Vec3& a, const Vec3& b) {
  return (a.cwiseMax(b).array() >= box.min.array()).all() &&
         (a.cwiseMin(b).array() <= box.max.array()).all();
}

// Six diagonal slabs that bound a tool, besides its box (an 18-DOP without the box's axes): they
// reject points near an edge of the box, which are most of those that an instrument passes.
class SlantedSlabs {
 public:
  SlantedSlabs(const TriangleMesh& tool, const Aabb& box)
      : centre_(0.5 * (box.min + box.max)),
        scale_(box.size().unaryExpr([](double side) { return side > 0 ? 2 / side : 0; })) {
    low_.setConstant(std::numeric_limits<double>::infinity());
    high_ = -low_;
    for (const Vec3& p : tool.points) {
      const Six at = along(p);
      low_ = low_.min(at);
      high_ = high_.max(at);
    }
    // More than snapping to the raster of the exact test moves a point.
    low_ -= kAside;
    high_ += kAside;
  }
  // Whether a point that moves from a to b may be in all slabs at once.
  bool mayHold(const Vec3& a, const Vec3& b) const {
    const Six from = along(a), to = along(b);
    return ((from.max(to) >= low_) && (from.min(to) <= high_)).all();
  }

 private:
  using Six = Eigen::Array<double, 6, 1>;
  static constexpr double kAside = 1e-7;  // of half the box's sides
  Six along(const Vec3& p) const {
    const Vec3 u = (p - centre_).cwiseProduct(scale_);
    return Six(u.x() + u.y(), u.x() - u.y(), u.y() + u.z(), u.y() - u.z(), u.z() + u.x(),
               u.z() - u.x());
  }

  Vec3 centre_, scale_;
  Six low_, high_;
};

// Chords of a step, by point: start a and end b in the tool's frame.
struct Chord {
  std::uint32_t point;
  Vec3 a, b;
};

// All chords have the same direction and length: columns are cast along it.
void touchAlong(const TriangleMesh& tool, std::span<const Chord> chords,
                std::vector<std::uint8_t>& touched) {
  const Vec3 motion = chords[0].b - chords[0].a;
  const double length = motion.norm();
  if (!(length > 0)) return;
  const Mat3 turn = Eigen::Quaterniond::FromTwoVectors(motion, Vec3::UnitZ()).toRotationMatrix();
  TriangleMesh turned;
  turned.triangles = tool.triangles;
  turned.points.reserve(tool.points.size());
  for (const Vec3& p : tool.points) turned.points.push_back(turn * p);
  std::vector<Vec3> starts;
  std::vector<Vec2> columns;
  for (const Chord& chord : chords) {
    starts.push_back(turn * chord.a);
    columns.push_back(starts.back().head<2>());
  }
  const Crossings crossings = castColumns(snapToRaster(turned), columns);
  for (std::size_t i = 0; i < chords.size(); ++i) {
    const double low = starts[i].z(), high = low + length;
    forEachInside(crossings[i], [&](double entered, double left) {
      if (entered <= high && left >= low) touched[chords[i].point] = 1;
    });
  }
}

// Whether the segment meets a face. Projected along the segment it is the origin of a plane;
// corners are snapped to integers there, so neighbouring faces agree about their shared edge and no
// segment passes between them.
bool segmentMeets(const TriangleMesh& tool, std::span<const Aabb> boxes, const Vec3& a,
                  const Vec3& b) {
  const Vec3 d = b - a;
  int axis = 0;
  d.cwiseAbs().maxCoeff(&axis);
  if (!(std::abs(d[axis]) > 0)) return false;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const double slopeU = d[u] / d[axis], slopeV = d[v] / d[axis], reach = d[axis];
  // Consecutive chords share an end; a face exactly there must be met by one of them.
  const double nearEnd = kSnap / std::abs(reach);
  for (std::size_t t = 0; t < tool.triangles.size(); ++t) {
    if (!meets(boxes[t], a, b)) continue;
    std::int64_t x[3], y[3];
    double along[3];
    for (int i = 0; i < 3; ++i) {
      const Vec3 p = tool.points[tool.triangles[t][i]] - a;
      along[i] = p[axis] / reach;
      x[i] = std::llround((p[u] - slopeU * p[axis]) / kSnap);
      y[i] = std::llround((p[v] - slopeV * p[axis]) / kSnap);
    }
    __extension__ using Wide = __int128;
    const Wide w0 = Wide(x[1]) * y[2] - Wide(y[1]) * x[2];
    const Wide w1 = Wide(x[2]) * y[0] - Wide(y[2]) * x[0];
    const Wide w2 = Wide(x[0]) * y[1] - Wide(y[0]) * x[1];
    const bool covers = (w0 >= 0 && w1 >= 0 && w2 >= 0) || (w0 <= 0 && w1 <= 0 && w2 <= 0);
    if (!covers) continue;
    const double sum = double(w0) + double(w1) + double(w2);
    // A face seen edge-on has no area; its neighbours decide.
    if (sum == 0) continue;
    const double at = (double(w0) * along[0] + double(w1) * along[1] + double(w2) * along[2]) / sum;
    if (at >= -nearEnd && at <= 1 + nearEnd) return true;
  }
  return false;
}

}  // namespace

std::vector<std::uint8_t> insideFlags(const TriangleMesh& mesh, std::span<const Vec3> points) {
  std::vector<std::uint8_t> inside(points.size(), 0);
  const Aabb box = bounds(mesh);
  std::vector<Vec3> near;
  std::vector<std::uint32_t> index;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!box.contains(points[i])) continue;
    near.push_back(points[i]);
    index.push_back(std::uint32_t(i));
  }
  if (near.empty()) return inside;
  const std::vector<std::int32_t> winding = windingNumbers(snapToRaster(mesh), near);
  for (std::size_t i = 0; i < near.size(); ++i) inside[index[i]] = winding[i] > 0;
  return inside;
}

std::vector<std::uint8_t> sweptInside(const TriangleMesh& tool, const Pose& from, const Pose& to,
                                      std::span<const Vec3> worldPoints) {
  std::vector<std::uint8_t> touched(worldPoints.size(), 0);
  requireSound(tool);
  require(isFinite(from) && isFinite(to),
          "a tool goes to a pose that is not a number; give numbers");
  if (tool.triangles.empty()) return touched;
  const Aabb toolBox = bounds(tool);
  const double diagonal = toolBox.size().norm();

  // How finely to cut the motion: a chord leaves a path that turns by `angle` at distance r from
  // the tool's origin while it moves by `way` by at most (r angle^2 + 2 angle way) / 8.
  const double angle = angleBetween(from.rotation, to.rotation);
  const double way = (to.position - from.position).norm();
  const bool turns = angle > kNoTurn;
  int steps = 1;
  if (turns) {
    const double r = toolBox.min.cwiseAbs().cwiseMax(toolBox.max.cwiseAbs()).norm();
    const double bow = (r * angle * angle + 2 * angle * way) / 8;
    steps = int(std::min<double>(
        kMostSteps,
        std::ceil(std::max(angle / kLargestTurn, std::sqrt(bow / (kChordError * diagonal))))));
    steps = std::max(steps, 1);
  }
  // Poses of the whole motion; the ends are the given ones, bit for bit.
  std::vector<Pose> back;
  Aabb swept;
  for (int i = 0; i <= steps; ++i) {
    const Pose pose = i == 0 ? from : i == steps ? to : interpolate(from, to, double(i) / steps);
    swept.grow(movedBox(toolBox, pose));
    back.push_back(pose.inverse());
  }
  swept = swept.padded(turns ? 2 * kChordError * diagonal : 1e-9 * (diagonal + way));

  std::vector<std::uint32_t> near;
  for (std::size_t i = 0; i < worldPoints.size(); ++i)
    if (swept.contains(worldPoints[i])) near.push_back(std::uint32_t(i));
  if (!turns && !near.empty()) {
    const SlantedSlabs slabs(tool, toolBox);
    std::erase_if(near, [&](std::uint32_t i) {
      return !slabs.mayHold(back.front() * worldPoints[i], back.back() * worldPoints[i]);
    });
  }
  if (near.empty()) return touched;

  // Inside at the ends.
  for (const Pose* pose : {&back.front(), &back.back()}) {
    std::vector<Vec3> local(near.size());
    for (std::size_t n = 0; n < near.size(); ++n) local[n] = *pose * worldPoints[near[n]];
    const std::vector<std::uint8_t> inside = insideFlags(tool, local);
    for (std::size_t n = 0; n < near.size(); ++n)
      if (inside[n]) touched[near[n]] = 1;
  }

  if (!turns) {
    std::vector<Chord> chords;
    const Vec3 motion = from.rotation.conjugate() * (from.position - to.position);
    const Aabb box = toolBox.padded(1e-9 * (diagonal + way));
    for (const std::uint32_t i : near) {
      const Vec3 a = back.front() * worldPoints[i];
      if (!touched[i] && meets(box, a, a + motion)) chords.push_back({i, a, a + motion});
    }
    if (!chords.empty()) touchAlong(tool, chords, touched);
    return touched;
  }

  std::vector<Aabb> boxes(tool.triangles.size());
  for (std::size_t t = 0; t < boxes.size(); ++t) {
    for (const std::int32_t corner : tool.triangles[t]) boxes[t].grow(tool.points[corner]);
    boxes[t] = boxes[t].padded(1e-9);
  }
  parallelFor(near.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const std::uint32_t i = near[n];
      if (touched[i]) continue;
      Vec3 a = back[0] * worldPoints[i];
      for (int step = 1; step <= steps && !touched[i]; ++step) {
        const Vec3 b = back[step] * worldPoints[i];
        if (meets(toolBox, a, b) && segmentMeets(tool, boxes, a, b)) touched[i] = 1;
        a = b;
      }
    }
  });
  return touched;
}

}  // namespace resect
