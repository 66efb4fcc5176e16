#include "pieces.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "samples.h"

namespace fit_liver {
namespace {

using resect::Blend;
using resect::Mat3;
using resect::Random;
using resect::Vec3;

constexpr int kBodies = 8;
constexpr int kHollows = 6;
constexpr double kRounding = 0.010;    // m: fillet below which the inferior margin gets razor-thin
constexpr double kRim = 0.003;         // m: the same for the rim of a flat piece that is added
constexpr double kSmallPiece = 0.021;  // m: radius below which pieces show as bumps

// The ellipsoid that holds these points as a solid ellipsoid of even density would.
resect::BlendedEllipsoid ellipsoidOf(std::span<const Vec3> points, double swell) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / double(points.size());
  Mat3 spread = Mat3::Zero();
  for (const Vec3& p : points)
    spread += (p - mean) * (p - mean).transpose() / double(points.size());
  Eigen::SelfAdjointEigenSolver<Mat3> axes(spread);
  Mat3 turn = axes.eigenvectors();
  if (turn.determinant() < 0) turn.col(0) = -turn.col(0);
  resect::BlendedEllipsoid e;
  e.centre = mean;
  e.turn = Eigen::Quaterniond(turn).coeffs();
  e.radii = swell * (5 * axes.eigenvalues().cwiseMax(1e-6)).cwiseSqrt();
  return e;
}

// k-means; the clusters as lists of points.
std::vector<std::vector<Vec3>> clusters(std::span<const Vec3> points, int count, Random& random) {
  std::vector<Vec3> centres;
  for (int k = 0; k < count; ++k) {  // each start far from the others
    Vec3 best = Vec3::Zero();
    double far = -1;
    for (int tries = 0; tries < 30; ++tries) {
      const Vec3& p = points[random.below(int(points.size()))];
      double near = 1;
      for (const Vec3& c : centres) near = std::min(near, (p - c).norm());
      if (near > far) far = near, best = p;
    }
    centres.push_back(best);
  }
  std::vector<std::vector<Vec3>> groups;
  for (int round = 0; round < 25; ++round) {
    groups.assign(count, {});
    for (const Vec3& p : points) {
      int nearest = 0;
      for (int k = 1; k < count; ++k)
        if ((p - centres[k]).squaredNorm() < (p - centres[nearest]).squaredNorm()) nearest = k;
      groups[nearest].push_back(p);
    }
    for (int k = 0; k < count; ++k) {
      if (groups[k].empty()) continue;
      centres[k].setZero();
      for (const Vec3& p : groups[k]) centres[k] += p / double(groups[k].size());
    }
  }
  return groups;
}

}  // namespace

std::vector<Part> firstParts(const ReferenceSurface& reference, std::span<const Sample> even,
                             Random& random) {
  std::vector<Vec3> directions;
  std::vector<double> reach;
  for (int i = 0; i < 400; ++i) {
    Vec3 d{normal(random), normal(random), normal(random)};
    d.normalize();
    double most = -1;
    for (const Vec3& p : reference.mesh().points) most = std::max(most, d.dot(p));
    directions.push_back(d);
    reach.push_back(most);
  }
  std::vector<Vec3> inside, hollow;
  for (const Sample& s : even) {
    if (s.distance < 0) inside.push_back(s.point);
    bool inHull = s.distance > 0.002;
    for (std::size_t i = 0; inHull && i < reach.size(); ++i)
      inHull = directions[i].dot(s.point) < reach[i];
    if (inHull) hollow.push_back(s.point);
  }
  std::vector<Part> parts;
  for (const auto& group : clusters(inside, kBodies, random)) {
    Part part;
    part.ellipsoid = ellipsoidOf(group, 1.1);
    part.ellipsoid.fillet = 0.025;
    part.smallestRadius = 0.02;
    part.sharpestRim = kRim;
    part.smallestFillet = 0.02;
    parts.push_back(part);
  }
  for (const auto& group : clusters(hollow, kHollows, random)) {
    Part part;
    part.ellipsoid = ellipsoidOf(group, 1.1);
    part.ellipsoid.blend = Blend::Carve;
    part.ellipsoid.fillet = 0.018;
    part.smallestRadius = 0.02;
    part.smallestFillet = kRounding;
    parts.push_back(part);
  }
  return parts;
}

Part pieceForWorst(std::span<const Part> parts, std::span<const SamplePair> probes,
                   Random& random) {
  const auto shape = shapeOf(parts);
  struct Miss {
    Vec3 point;
    double weight;
  };
  std::vector<Miss> missing, surplus;
  for (const auto& [s, unused] : probes) {
    if (std::abs(s.distance) > 0.015) continue;
    const double value = shape(s.point);
    if ((value < 0) == (s.distance < 0)) continue;
    (s.distance < 0 ? missing : surplus)
        .push_back({s.point, std::min({std::abs(s.distance), std::abs(value), 0.006})});
  }
  double most = -1;
  Vec3 where = Vec3::Zero();
  bool carve = false;
  for (bool c : {false, true}) {
    const auto& misses = c ? surplus : missing;
    for (int tries = 0; tries < 600 && !misses.empty(); ++tries) {
      const Vec3& p = misses[random.below(int(misses.size()))].point;
      double sum = 0;
      for (const Miss& m : misses)
        sum += m.weight * std::exp(-(m.point - p).squaredNorm() / (2 * 0.01 * 0.01));
      if (sum > most) most = sum, where = p, carve = c;
    }
  }
  std::vector<Vec3> points;
  for (const Miss& m : carve ? surplus : missing)
    if ((m.point - where).norm() < 0.02) points.push_back(m.point);
  Part part;
  part.ellipsoid = ellipsoidOf(points, 1.1);
  part.ellipsoid.radii = part.ellipsoid.radii.cwiseMax(kSmallPiece);
  part.ellipsoid.blend = carve ? Blend::Carve : Blend::Add;
  part.ellipsoid.fillet = 0.015;
  part.smallestRadius = kSmallPiece;
  if (!carve) part.sharpestRim = kRim;
  part.smallestFillet = kRounding;
  return part;
}

}  // namespace fit_liver
