#include "operation/adnexa/liver_adnexa.h"

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
    // Highest in front, lower towards the dome; the fold lies over to the left.
    const double height = kHeight * (1.2 - 0.7 * share) * (1 + 0.35 * wave(along / 0.009)) + kSunk;
    for (int j = 0; j < kAcross; ++j) {
      const double t = double(j) / (kAcross - 1);
      const double aside = height * (0.35 * t * t + 0.45 * t * wave(along / 0.006 + 5));
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
  to.anchors.push_back(bed / std::max(1, count));
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

std::optional<Pose> builtinLiverPose(const Anatomy& vessels) {
  constexpr double kSame = 1e-4;  // m
  // The roots of the trees that the built-in liver ships with: from the entry to the first fork.
  const VesselGrowth grown = builtinLiverVessels();
  Eigen::Matrix<double, 3, 4> theirs, ours;
  ours << grown.hilumOut, Vec3(0.0308, 0.000745, 0.004013),  // portal vein
      grown.cavaOut, Vec3(0.0308, 0.040745, -0.010987);      // hepatic veins
  int column = 0;
  for (const VesselKind kind : {VesselKind::PortalVein, VesselKind::HepaticVein}) {
    const VesselRange range = vessels.range(kind);
    if (range.count == 0) return std::nullopt;
    const VesselSegment& root = vessels.segments[std::size_t(range.first)];
    theirs.col(column++) = root.start;
    theirs.col(column++) = root.end;
  }
  const Eigen::Matrix4d pose = Eigen::umeyama(ours, theirs, false);
  const Mat3 rotation = pose.topLeftCorner<3, 3>();
  const Vec3 position = pose.topRightCorner<3, 1>();
  for (int i = 0; i < 4; ++i)
    if ((rotation * ours.col(i) + position - theirs.col(i)).norm() > kSame) return std::nullopt;
  return Pose{position, Eigen::Quaterniond(rotation)};
}

}  // namespace resect
