// Fits the numbers of the built-in liver to a measured one and writes its table.
//   fit_liver LIVER.obj TABLE.inl
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "base/error.h"
#include "base/random.h"
#include "geometry/measures.h"
#include "geometry/topology.h"
#include "reference_surface.h"
#include "shape_fit.h"
#include "surface/polygonise.h"

using namespace fit_liver;
using resect::Aabb;
using resect::Blend;
using resect::Mat3;
using resect::Random;
using resect::TriangleMesh;
using resect::Vec3;

namespace {

constexpr int kBodies = 8;     // first pieces added
constexpr int kHollows = 6;    // first pieces carved
constexpr int kParts = 36;
constexpr int kTries = 40;
constexpr int kStarts = 5;     // pieces in the end
constexpr double kMargin = 0.03;
constexpr double kSharpest = 400;  // 1/m: bends beyond it are noise of the triangles
constexpr double kGentle = 0.012;  // m: a bend of this radius doubles the number of samples
constexpr double kPairGap = 0.004;
constexpr double kRounding = 0.010;    // fillet below which the inferior margin gets razor-thin
constexpr double kRim = 0.003;          // the same for a flat piece that is added
constexpr double kSmallPiece = 0.021;  // radius below which pieces show as bumps

// What a surgeon looks for on the visceral face, carved last so that nothing fills it again. The
// groove and the fissure are starts, fitted like everything else. The fossa is given: the measured
// gallbladder is nearly empty and hangs free, so its bed is set where the gallbladder lies, as deep
// as a filled one makes it.
std::vector<Part> namedParts() {
  const auto carve = [](const char* name, Vec3 centre, const Mat3& turn, Vec3 radii, double fillet) {
    Part part;
    part.name = name;
    part.ellipsoid = {Blend::Carve, centre, Eigen::Quaterniond(turn).coeffs(), radii, fillet};
    part.smallestRadius = 0.005;
    part.largestRadius = 1.2 * radii.maxCoeff();
    part.home = centre;
    part.leash = 0.008;
    part.smallestFillet = 0.006;
    part.largestFillet = 0.012;
    return part;
  };
  const Mat3 upright = Mat3::Identity();
  const Mat3 alongGallbladder =
      Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), Vec3(-0.38, -0.25, 0.89)).toRotationMatrix();
  std::vector<Part> parts{
      carve("groove of the vena cava", {0.046, 0.005, -0.034}, upright, {0.008, 0.045, 0.022}, 0.008),
      carve("umbilical fissure", {0.048, -0.020, 0.042}, upright, {0.006, 0.022, 0.035}, 0.006),
      carve("gallbladder fossa", {-0.007, -0.0185, 0.050}, alongGallbladder, {0.013, 0.013, 0.044},
            0.008)};
  parts.back().held = true;
  return parts;
}

Vec3 pointIn(const Aabb& box, Random& random) {
  return {random.uniform(box.min.x(), box.max.x()), random.uniform(box.min.y(), box.max.y()),
          random.uniform(box.min.z(), box.max.z())};
}

double normal(Random& random) {
  return std::sqrt(-2 * std::log(1 - random.uniform())) *
         std::cos(2 * 3.14159265358979 * random.uniform());
}

// Evenly in the padded box and, thicker, around the surface, thickest where it bends most: the
// sharp inferior margin is little of the area and much of the looks.
std::vector<SamplePair> samplesAround(const ReferenceSurface& reference, int even, int near,
                                  Random& random) {
  const TriangleMesh& mesh = reference.mesh();
  const Aabb box = resect::bounds(mesh).padded(kMargin);
  std::vector<double> area(mesh.triangles.size());
  std::vector<Vec3> normals(mesh.points.size(), Vec3::Zero());
  const auto cross = [&](const resect::Triangle& c) -> Vec3 {
    return (mesh.points[c[1]] - mesh.points[c[0]]).cross(mesh.points[c[2]] - mesh.points[c[0]]);
  };
  for (const auto& c : mesh.triangles)
    for (int corner : c) normals[corner] += cross(c);
  for (Vec3& n : normals) n.normalize();
  for (std::size_t t = 0; t < area.size(); ++t) {
    const auto& c = mesh.triangles[t];
    double bend = 0;  // 1/m
    for (int e = 0; e < 3; ++e) {
      const int a = c[e], b = c[(e + 1) % 3];
      bend = std::max(bend, (normals[a] - normals[b]).norm() /
                                std::max((mesh.points[a] - mesh.points[b]).norm(), 1e-4));
    }
    bend = std::min(bend, kSharpest) * kGentle;
    area[t] = 0.5 * cross(c).norm() * (1 + bend * bend) + (t ? area[t - 1] : 0);
  }
  std::vector<SamplePair> samples;
  const auto add = [&](const Vec3& p) {
    Vec3 aside(normal(random), normal(random), normal(random));
    const Vec3 q = p + kPairGap * aside.normalized();
    samples.push_back({Sample{p, reference.signedDistance(p)}, Sample{q, reference.signedDistance(q)}});
  };
  for (int i = 0; i < even; ++i) add(pointIn(box, random));
  for (int i = 0; i < near; ++i) {
    const auto t = std::lower_bound(area.begin(), area.end(), random.uniform() * area.back()) -
                   area.begin();
    const auto& c = mesh.triangles[std::min<std::size_t>(t, area.size() - 1)];
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    Vec3 p = mesh.points[c[0]] + u * (mesh.points[c[1]] - mesh.points[c[0]]) +
             v * (mesh.points[c[2]] - mesh.points[c[0]]);
    for (int m = 0; m < 3; ++m) p[m] += 0.005 * normal(random);
    add(p);
  }
  return samples;
}

// The ellipsoid that holds these points as a solid ellipsoid of even density would.
resect::BlendedEllipsoid ellipsoidOf(std::span<const Vec3> points, double swell) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / double(points.size());
  Mat3 spread = Mat3::Zero();
  for (const Vec3& p : points) spread += (p - mean) * (p - mean).transpose() / double(points.size());
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

// Bodies from the liver's inside, hollows from what its convex hull holds beyond it.
std::vector<Part> firstParts(const ReferenceSurface& reference, std::span<const Sample> even,
                             Random& random) {
  std::vector<Vec3> directions;
  std::vector<double> reach;
  for (int i = 0; i < 400; ++i) {
    Vec3 d(normal(random), normal(random), normal(random));
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

// A piece where the shape is wrong most: added where liver is missing, carved where it is too much.
Part pieceForWorst(std::span<const Part> parts, std::span<const SamplePair> probes, Random& random) {
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
      for (const Miss& m : misses) sum += m.weight * std::exp(-(m.point - p).squaredNorm() / (2 * 0.01 * 0.01));
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

// How good a shape is. The angle between its normals and the measured ones is what the eye sees, so
// it decides between starts.
struct Quality {
  double dice, volumeRatio, normalError /* degrees, root mean square */, distance /* m, mean */;
  bool onePiece;  // without cavities and handles
};

Quality quality(std::span<const Part> parts, const ReferenceSurface& reference,
                std::span<const Sample> even) {
  const auto shape = shapeOf(parts);
  Quality q{};
  double both = 0, mine = 0, theirs = 0;
  for (const Sample& s : even) {
    const bool a = shape(s.point) < 0, b = s.distance < 0;
    both += a && b, mine += a, theirs += b;
  }
  q.dice = 2 * both / (mine + theirs);
  q.volumeRatio = mine / theirs;
  double area = 0;
  for (const resect::Triangle& c : reference.mesh().triangles) {
    const auto& points = reference.mesh().points;
    const Vec3 n = (points[c[1]] - points[c[0]]).cross(points[c[2]] - points[c[0]]);
    const Vec3 p = (points[c[0]] + points[c[1]] + points[c[2]]) / 3;
    Vec3 g;
    for (int m = 0; m < 3; ++m) {
      const Vec3 d = 1e-4 * Vec3::Unit(m);
      g[m] = shape(p + d) - shape(p - d);
    }
    const double a = n.norm();
    area += a;
    q.distance += a * std::abs(shape(p));
    const double angle = std::acos(std::clamp(n.dot(g) / (a * g.norm() + 1e-30), -1.0, 1.0));
    q.normalError += a * angle * angle;
  }
  q.distance /= area;
  q.normalError = 180 / 3.14159265358979 * std::sqrt(q.normalError / area);
  const TriangleMesh mesh = resect::polygonise(
      shape, resect::bounds(reference.mesh()).padded(0.02), {.edge = 0.003, .smoothing = 0});
  const resect::Topology found = resect::topology(mesh);
  q.onePiece = found.components == 1 && mesh.points.size() * 2 == mesh.triangles.size() + 4;
  return q;
}

void writeTable(const std::string& path, std::span<const Part> parts) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (!file) throw resect::error("{}: cannot be written; name a file in a folder that exists", path);
  std::fprintf(file,
               "// Written by tools/fit_liver; do not edit. Fitted to the liver of the Visible Human "
               "Male\n// (Browne K., Schlehlein H. et al., HuBMAP CCF 3D Reference Object Library, CC "
               "BY 4.0,\n// DOI 10.48539/HBM677.HVRF.764).\n// blend, centre, turn (x, y, z, w), radii, "
               "fillet; m\n");
  for (const Part& part : parts) {
    const auto& e = part.ellipsoid;
    if (!part.name.empty()) std::fprintf(file, "// %s\n", part.name.c_str());
    std::fprintf(file,
                 "{Blend::%s, {%.5f, %.5f, %.5f}, {%.5f, %.5f, %.5f, %.5f}, {%.5f, %.5f, %.5f}, "
                 "%.5f},\n",
                 e.blend == Blend::Add ? "Add" : "Carve", e.centre.x(), e.centre.y(), e.centre.z(),
                 e.turn[0], e.turn[1], e.turn[2], e.turn[3], e.radii.x(), e.radii.y(), e.radii.z(),
                 e.fillet);
  }
  std::fclose(file);
}

// One whole fit from one random start: bodies and hollows, the named features, then piece after piece
// where the shape is worst, each kept only when it helps.
std::vector<Part> grown(const ReferenceSurface& reference, std::span<const Sample> even, std::span<const SamplePair> wanted, std::span<const Part> named, std::uint64_t seed, double& loss) {
  Random random(seed + 1);
  std::vector<Part> parts = firstParts(reference, even, random);
  fit(parts, wanted, {.steps = 800, .sharpnessFirst = 0.02, .sharpnessLast = 0.006}, seed);
  parts.insert(parts.end(), named.begin(), named.end());
  loss = 1;
  for (int tries = 0; tries < kTries && parts.size() < kParts; ++tries) {
    std::vector<Part> more = parts;
    more.insert(more.end() - std::ptrdiff_t(named.size()), pieceForWorst(parts, wanted, random));
    const double now = fit(more, wanted, {.steps = 300, .batch = 3072, .rate = 0.006, .sharpnessFirst = 0.005, .sharpnessLast = 0.004}, random.next());
    if (now > loss) continue;
    loss = now;
    parts = more;
  }
  loss = fit(parts, wanted, {.steps = 600, .rate = 0.006, .sharpnessFirst = 0.005, .sharpnessLast = 0.003}, seed);
  return parts;
}

int run(int argc, char** argv) {
  if (argc != 3) throw resect::usageError("usage: fit_liver LIVER.obj TABLE.inl");
  TriangleMesh mesh = readObj(argv[1]);
  const Vec3 centre = resect::centroid(mesh);
  const double referenceVolume = resect::volume(mesh);
  for (Vec3& p : mesh.points) p -= centre;
  std::printf("reference: %.1f ml, centroid %.5f %.5f %.5f\n", 1e6 * referenceVolume,
              centre.x(), centre.y(), centre.z());
  const ReferenceSurface reference(std::move(mesh));
  Random random(1);
  constexpr int kEven = 60000, kNear = 90000;
  const std::vector<SamplePair> samples = samplesAround(reference, kEven, kNear, random);
  std::vector<Sample> even;
  for (int i = 0; i < kEven; ++i) even.push_back(samples[i][0]);

  const std::vector<Part> named = namedParts();
  resect::BlendedEllipsoid bed = named.back().ellipsoid;
  bed.blend = Blend::Add;
  const resect::BlendedShape fossa(std::array{bed});
  std::vector<SamplePair> wanted = samples;
  for (SamplePair& pair : wanted)
    for (Sample& s : pair) s.distance = std::max(s.distance, -fossa(s.point));
  const auto report = [&](std::span<const Part> parts, const char* what, int number, double loss) {
    const Quality q = quality(parts, reference, even);
    std::printf(
        "%s %d: %zu parts, loss %.4f, Dice %.4f, volume %.0f ml, mean distance %.2f mm, normal error "
        " %.1f degrees, %s\n",
        what, number, parts.size(), loss, q.dice, 1e6 * q.volumeRatio * referenceVolume,
        1e3 * q.distance, q.normalError, q.onePiece ? "one piece" : "broken");
    std::fflush(stdout);
    return q;
  };
  std::vector<Part> parts;
  double least = 180;
  for (int start = 0; start < kStarts; ++start) {
    double loss;
    std::vector<Part> candidate = grown(reference, even, wanted, named, std::uint64_t(start), loss);
    const Quality q = report(candidate, "start", start, loss);
    if (q.onePiece && q.normalError < least) least = q.normalError, parts = candidate;
  }
  if (parts.empty()) throw resect::error("no start gave one piece; try other seeds");
  const double loss = fit(parts, wanted, {.steps = 2500, .batch = 8192, .rate = 0.008, .sharpnessFirst = 0.005, .sharpnessLast = 0.003}, 3);
  report(parts, "polished", 0, loss);
  writeTable(argv[2], parts);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const resect::Error& e) {
    std::fprintf(stderr, "fit_liver: error: %s\n", e.what());
    return int(e.status());
  } catch (const std::exception& e) {
    std::fprintf(stderr, "fit_liver: error: %s\n", e.what());
    return 1;
  }
}
