#include "operation/adnexa/liver_adnexa.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/elementary.h"
#include "organ/builtin/builtin_gallbladder.h"
#include "organ/builtin/builtin_liver.h"

namespace resect {
namespace {

// The falciform ligament runs over the front of the liver in a plane, from the notch in the lower
// margin to the dome.
constexpr double kPlane = 0.056;                       // m: x of the plane
const Vec3 kMiddle(kPlane, -0.005, 0.02);              // m: inside the liver
constexpr double kFromAngle = -0.62, kToAngle = 1.75;  // rad: from +Z towards +Y, round kMiddle
constexpr int kAnchors = 96, kAcross = 6;              // points along the line, and up the fold
constexpr double kHeight = 0.0075;                     // m: mean height of the fold
constexpr double kSunk = 0.0015;                       // m: its base lies in the liver

void add(LiverAdnexa& to, AdnexaLook look, double fraction, std::size_t anchor, const Vec3& point) {
  to.mesh.points.push_back(point);
  to.look.push_back(float(int(look)) + float(std::clamp(fraction, 0.0, 0.9)));
  to.anchor.push_back(std::int32_t(anchor));
}

// Triangles between rows of `width` points each, the first of which is point `first`.
void addRows(TriangleMesh& mesh, std::size_t first, int rows, int width, bool closed) {
  for (int i = 0; i + 1 < rows; ++i)
    for (int j = 0; j + (closed ? 0 : 1) < width; ++j) {
      const auto at = [&](int row, int column) {
        return std::int32_t(first + std::size_t(row * width + column % width));
      };
      mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
      mesh.triangles.push_back({at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
    }
}

// A wave that never repeats visibly, -1 to 1.
double wave(double x) {
  return 0.55 * math::sin(x) + 0.30 * math::sin(2.31 * x + 1.0) + 0.15 * math::sin(4.73 * x + 2.0);
}

// Where the ray at this angle leaves the liver. It begins in the middle of the liver, a few
// millimetres beside the plane, so that the line winds a little.
Vec3 onLiver(double angle) {
  const Vec3 middle = kMiddle + 0.0035 * wave(2.4 * angle) * Vec3::UnitX();
  const Vec3 way(0, math::sin(angle), math::cos(angle));
  double inside = 0, outside = 0.15;
  for (double d = outside; d > 0; d -= 0.002)
    if (builtinLiverDistance(middle + d * way) < 0) {
      inside = d;
      break;
    } else {
      outside = d;
    }
  for (int i = 0; i < 20; ++i) {
    const double d = 0.5 * (inside + outside);
    (builtinLiverDistance(middle + d * way) < 0 ? inside : outside) = d;
  }
  return middle + inside * way;
}

Vec3 outwards(const Vec3& p) {
  constexpr double kStep = 1e-4;
  Vec3 g;
  for (int a = 0; a < 3; ++a)
    g[a] = builtinLiverDistance(p + kStep * Vec3::Unit(a)) -
           builtinLiverDistance(p - kStep * Vec3::Unit(a));
  return g.normalized();
}

void addFalciform(LiverAdnexa& to) {
  const std::size_t first = to.mesh.points.size();
  double along = 0;
  Vec3 before = onLiver(kFromAngle);
  for (int i = 0; i < kAnchors; ++i) {
    const double share = double(i) / (kAnchors - 1);
    const Vec3 at = onLiver(kFromAngle + share * (kToAngle - kFromAngle));
    along += (at - before).norm();
    before = at;
    const Vec3 up = outwards(at);
    to.anchors.push_back(at - 0.004 * up);
    // Highest in front, lower towards the dome; the fold lies over to the left, here more and there
    // less. Its edge was cut by scissors, and is uneven.
    constexpr double kFades = 0.2;  // share of the line, at the dome
    const double fading = std::min(1.0, (1 - share) / kFades);
    const double uneven = 1 + 0.26 * wave(along / 0.016) + 0.14 * wave(along / 0.0045 + 3);
    const double height = kHeight * fading * (1.2 - 0.7 * share) * uneven + kSunk;
    for (int j = 0; j < kAcross; ++j) {
      const double t = double(j) / (kAcross - 1);
      const double aside = height * (0.6 * t * t + 0.7 * t * wave(along / 0.009 + 5));
      add(to, AdnexaLook::Ligament, t, std::size_t(i),
          at + (height * t * (1 - 0.25 * t) - kSunk) * up + aside * Vec3::UnitX());
    }
  }
  addRows(to.mesh, first, kAnchors, kAcross, false);
}

// The cord hangs from the lower end of the fold; a thread is tied round it near its cut end.
void addCord(LiverAdnexa& to) {
  constexpr int kRings = 20, kRound = 12;
  constexpr double kLength = 0.034, kRadius = 0.0034, kThread = 0.78;  // m, m, share of the length
  const std::size_t first = to.mesh.points.size();
  const Vec3 root = onLiver(kFromAngle + 0.05), up = outwards(root);
  const Vec3 down = (Vec3(0.25, -1, 0.55) - 0.2 * up).normalized();
  for (int i = 0; i < kRings; ++i) {
    const double share = double(i) / (kRings - 1);
    // A bend from the surface's normal to the way down.
    const Vec3 middle = root + kLength * (share * (1 - 0.5 * share) * 0.55 * up +
                                          share * (0.45 + 0.55 * share) * down);
    const Vec3 ahead = ((1 - share) * 0.55 * up + (0.45 + 1.1 * share) * down).normalized();
    const Vec3 side = ahead.unitOrthogonal(), other = ahead.cross(side);
    const double tied = std::abs(share - kThread) < 0.03 ? 0.9 : 0;
    double radius = kRadius * (1 + 0.12 * wave(9 * share));
    if (tied > 0) radius *= 0.72;
    if (i == kRings - 1) radius = 1e-5;
    if (i == kRings - 2) radius *= 0.8;
    for (int j = 0; j < kRound; ++j) {
      const double angle = 2 * std::numbers::pi * j / kRound;
      add(to, AdnexaLook::Cord, tied, 1,
          middle + radius * (math::cos(angle) * side + math::sin(angle) * other));
    }
  }
  addRows(to.mesh, first, kRings, kRound, true);
}

void addGallbladder(LiverAdnexa& to) {
  constexpr double kEdge = 0.0025;  // m
  constexpr double kFree = 0.012;   // m: from the liver, where its free side begins
  const TriangleMesh shape = builtinGallbladder(kEdge);
  const auto first = std::int32_t(to.mesh.points.size());
  Vec3 bed = Vec3::Zero();
  int count = 0;
  for (const Vec3& p : shape.points) {
    const double off = builtinLiverDistance(p);
    if (off < 0.001) bed += p, ++count;
    add(to, AdnexaLook::Gallbladder, 0.9 * off / kFree, to.anchors.size(), p);
  }
  // The bed is hollow, so its middle lies outside the liver.
  bed /= std::max(1, count);
  while (builtinLiverDistance(bed) > -0.006) bed -= 0.001 * outwards(bed);
  to.anchors.push_back(bed);
  for (const Triangle& t : shape.triangles)
    to.mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

}  // namespace

LiverAdnexa liverAdnexa() {
  LiverAdnexa adnexa;
  addFalciform(adnexa);
  addCord(adnexa);
  addGallbladder(adnexa);
  return adnexa;
}

namespace {

// A body of equal cells: its volume, its middle, and its axes of inertia, the longest first.
struct Inertia {
  double volume = 0;  // m^3
  Vec3 middle = Vec3::Zero();
  Mat3 axes = Mat3::Identity();  // columns, right-handed
};
Inertia inertiaOf(const std::vector<Vec3>& places, double cell) {
  Inertia body;
  body.volume = cell * double(places.size());
  for (const Vec3& p : places) body.middle += p / double(places.size());
  Mat3 spread = Mat3::Zero();
  for (const Vec3& p : places) spread += (p - body.middle) * (p - body.middle).transpose();
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(spread);
  body.axes << solver.eigenvectors().col(2), solver.eigenvectors().col(1),
      solver.eigenvectors().col(2).cross(solver.eigenvectors().col(1));
  return body;
}

const Inertia& builtinInertia() {
  static const Inertia liver = [] {
    constexpr double kStep = 0.006;  // m
    const Aabb box = bounds(builtinLiver(0.005));
    std::vector<Vec3> places;
    for (double x = box.min.x(); x < box.max.x(); x += kStep)
      for (double y = box.min.y(); y < box.max.y(); y += kStep)
        for (double z = box.min.z(); z < box.max.z(); z += kStep)
          if (builtinLiverDistance({x, y, z}) < 0) places.emplace_back(x, y, z);
    return inertiaOf(places, kStep * kStep * kStep);
  }();
  return liver;
}

}  // namespace

std::optional<Pose> builtinLiverPose(const Discretization& organ) {
  constexpr double kSameVolume = 0.04, kInside = 0.97;
  constexpr std::size_t kTried = 1000;  // particles
  const Lattice& lattice = organ.lattice;
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < organ.inside.size(); ++i)
    if (organ.inside[i]) places.push_back(lattice.centre(lattice.cell(std::int64_t(i))));
  if (places.empty()) return std::nullopt;
  const Inertia &liver = builtinInertia(), body = inertiaOf(places, lattice.spacing.prod());
  if (std::abs(body.volume / liver.volume - 1) > kSameVolume) return std::nullopt;
  // Axes have no sign: four rotations are possible.
  std::optional<Pose> best;
  double most = kInside;
  for (const Vec3& signs : {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)}) {
    const Mat3 rotation = body.axes * signs.asDiagonal() * liver.axes.transpose();
    const std::size_t step = std::max<std::size_t>(1, places.size() / kTried);
    double inside = 0, tried = 0;
    for (std::size_t i = 0; i < places.size(); i += step, ++tried) {
      const Vec3 p = liver.middle + rotation.transpose() * (places[i] - body.middle);
      inside += builtinLiverDistance(p) < 0.001;
    }
    if (inside / tried < most) continue;
    most = inside / tried;
    best = Pose{body.middle - rotation * liver.middle, Eigen::Quaterniond(rotation)};
  }
  return best;
}

}  // namespace resect
