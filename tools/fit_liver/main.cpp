// Fits the numbers of the built-in liver to a measured one and writes its table.
//   fit_liver LIVER.obj TABLE.inl
#include <algorithm>
#include <array>
#include <cstdio>

#include "base/error.h"
#include "base/random.h"
#include "geometry/measures.h"
#include "named_parts.h"
#include "pieces.h"
#include "quality.h"
#include "reference_surface.h"
#include "samples.h"
#include "shape_fit.h"

using namespace fit_liver;
using resect::Blend;
using resect::Random;
using resect::TriangleMesh;
using resect::Vec3;

namespace {

constexpr int kStarts = 5;    // random starts
constexpr int kParts = 36;    // most pieces of a shape
constexpr int kTries = 40;    // most pieces tried in a start
constexpr int kEven = 60000;  // pairs of samples in space ...
constexpr int kNear = 90000;  // ... and around the surface

void writeTable(const std::string& path, std::span<const Part> parts) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (!file)
    throw resect::error("{}: cannot be written; name a file in a folder that exists", path);
  std::fprintf(
      file,
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

// One whole fit from one random start: bodies and hollows, the named features, then piece after
// piece where the shape is worst, each kept only when it helps.
std::vector<Part> grown(const ReferenceSurface& reference, std::span<const Sample> even,
                        std::span<const SamplePair> wanted, std::span<const Part> named,
                        std::uint64_t seed, double& loss) {
  Random random(seed + 1);
  std::vector<Part> parts = firstParts(reference, even, random);
  fit(parts, wanted, {.steps = 800, .sharpnessFirst = 0.02, .sharpnessLast = 0.006}, seed);
  parts.insert(parts.end(), named.begin(), named.end());
  loss = 1;
  for (int tries = 0; tries < kTries && parts.size() < kParts; ++tries) {
    std::vector<Part> more = parts;
    more.insert(more.end() - std::ptrdiff_t(named.size()), pieceForWorst(parts, wanted, random));
    const double now = fit(more, wanted,
                           {.steps = 300,
                            .batch = 3072,
                            .rate = 0.006,
                            .sharpnessFirst = 0.005,
                            .sharpnessLast = 0.004},
                           random.next());
    if (now > loss) continue;
    loss = now;
    parts = more;
  }
  loss = fit(parts, wanted,
             {.steps = 600, .rate = 0.006, .sharpnessFirst = 0.005, .sharpnessLast = 0.003}, seed);
  return parts;
}

int run(int argc, char** argv) {
  if (argc != 3) throw resect::usageError("usage: fit_liver LIVER.obj TABLE.inl");
  TriangleMesh mesh = readObj(argv[1]);
  const Vec3 centre = resect::centroid(mesh);
  const double referenceVolume = resect::volume(mesh);
  for (Vec3& p : mesh.points) p -= centre;
  std::printf("reference: %.1f ml, centroid %.5f %.5f %.5f\n", 1e6 * referenceVolume, centre.x(),
              centre.y(), centre.z());
  const ReferenceSurface reference(std::move(mesh));
  Random random(1);
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
        "%s %d: %zu parts, loss %.4f, Dice %.4f, volume %.0f ml, mean distance %.2f mm, normal "
        "error %.1f degrees, %s\n",
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
  const double loss = fit(parts, wanted,
                          {.steps = 2500,
                           .batch = 8192,
                           .rate = 0.008,
                           .sharpnessFirst = 0.005,
                           .sharpnessLast = 0.003},
                          3);
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
