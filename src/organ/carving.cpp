#include "organ/carving.h"

#include <algorithm>
#include <cmath>

namespace resect {
namespace {

constexpr float kMiddle = 50, kSlope = 25;  // of caps, per cent; per spacing of the nodes
constexpr double kLeastLeft = 0.5;          // of a particle

Vec3 nodeSpacing(const ColourField& field) { return field.lattice().spacing / field.refine(); }

int placeInBrick(const Vec3i& node) { return (node.z() % 4 * 4 + node.y() % 4) * 4 + node.x() % 4; }

// How much of the voxel round a node is left, 0 to 1.
double leftAt(const Organ& organ, const Vec3i& node) {
  return std::clamp((double(capAt(organ, node)) - kMiddle) / kSlope + 0.5, 0.0, 1.0);
}

// How much of a cell is left, 0 to 1: the mean of its nodes, those on its faces with half a weight.
double leftOf(const Organ& organ, std::int64_t cell) {
  const ColourField& field = organ.field;
  const int refine = field.refine(), half = refine / 2;
  const Vec3i centre = refine * (organ.rest.lattice.cell(cell) + Vec3i::Constant(2));
  const auto weight = [&](int d) { return refine % 2 == 0 && std::abs(d) == half ? 0.5 : 1.0; };
  double sum = 0, weights = 0;
  for (int z = -half; z <= half; ++z)
    for (int y = -half; y <= half; ++y)
      for (int x = -half; x <= half; ++x) {
        const double w = weight(x) * weight(y) * weight(z);
        sum += w * leftAt(organ, centre + Vec3i(x, y, z));
        weights += w;
      }
  return sum / weights;
}

bool lessThanHalfLeft(const Organ& organ, std::int64_t particle) {
  double left = 0, whole = 0;
  visitCellsOf(organ.rest, particle, [&](std::int64_t cell) {
    const double volume = organ.rest.cellVolume(cell);
    left += volume * leftOf(organ, cell);
    whole += volume;
  });
  return left < kLeastLeft * whole;
}

// visit(cell) for the up to six neighbours of a cell in the lattice.
template <typename Visit>
void visitNeighbours(const Lattice& lattice, std::int64_t cell, Visit visit) {
  const Vec3i c = lattice.cell(cell);
  for (int a = 0; a < 3; ++a)
    for (const int d : {-1, 1})
      if (const Vec3i n = c + d * Vec3i::Unit(a); lattice.contains(n)) visit(lattice.index(n));
}

bool hasNeighbour(const Organ& organ, std::int64_t cell) {
  bool any = false;
  visitNeighbours(organ.rest.lattice, cell,
                  [&](std::int64_t n) { any = any || organ.alive[std::size_t(n)] != 0; });
  return any;
}

void dropRemnant(Organ& organ, std::int64_t cell) {
  organ.remnant[std::size_t(cell)] = 0;
  setParticle(organ, cell, false);
}

}  // namespace

float capAt(const Organ& organ, const Vec3i& node) {
  const ColourField& field = organ.field;
  if ((node.array() < 0).any() || (node.array() >= field.nodeDims().array()).any()) return 100;
  const NodeCaps::Brick* caps = organ.carved.of(field.brickIndex(node / kBrickNodes));
  return caps ? (*caps)[std::size_t(placeInBrick(node))] / 2.f : 100;
}

std::vector<std::int64_t> carve(Organ& organ, const CarvedLine& line) {
  const ColourField& field = organ.field;
  const double spacing = nodeSpacing(field).maxCoeff();
  // Beyond two nodes caps are 100.
  const Aabb box = line.bounds().padded(2 * spacing);
  const IndexBox bricks = field.bricksIn(box);
  Vec3i low = field.nodeDims(), high = -Vec3i::Ones();
  for (std::int32_t b = 0; b < std::int32_t(bricks.count()); ++b) {
    const Vec3i brick = bricks.coordinates(b);
    for (int k = 0; k < kBrickSize; ++k) {
      const Vec3i node = kBrickNodes * brick + Vec3i(k % 4, k / 4 % 4, k / 16);
      const double cap =
          kMiddle + kSlope * line.distance(field.nodePosition(node.cast<double>())) / spacing;
      const auto halves = std::uint8_t(std::lround(2 * std::clamp(cap, 0.0, 100.0)));
      // The field never rises, so a cap far above it would never matter.
      const float now = field.node(node);
      if (now <= 0 || now + 2 * kCapBlend <= halves / 2.f) continue;
      if (!organ.carved.lower(field.brickIndex(brick), k, halves, field.brickCount())) continue;
      low = low.cwiseMin(node), high = high.cwiseMax(node);
    }
  }
  if ((high.array() < low.array()).any()) return {};
  organ.field.capsChanged(low, high);

  std::vector<std::int64_t> emptied;
  visitCellsIn(organ.rest.lattice, box.padded(organ.rest.lattice.spacing.maxCoeff()),
               [&](const Vec3i& at) {
                 const std::int64_t cell = organ.rest.lattice.index(at);
                 if (organ.alive[std::size_t(cell)] && lessThanHalfLeft(organ, cell))
                   emptied.push_back(cell);
               });
  std::ranges::sort(emptied);
  return emptied;
}

RemovedParticle removeCarvedParticle(Organ& organ, std::int64_t cell) {
  const RemovedParticle gone = removeParticle(organ, cell);
  if (organ.remnant.empty()) organ.remnant.assign(organ.alive.size(), 0);
  organ.remnant[std::size_t(cell)] = 1;
  setParticle(organ, cell, true);
  return gone;
}

void dropRemnants(Organ& organ, std::span<const std::int64_t> removedCells) {
  if (organ.remnant.empty()) return;
  const auto look = [&](std::int64_t cell) {
    if (organ.remnant[std::size_t(cell)] && !hasNeighbour(organ, cell)) dropRemnant(organ, cell);
  };
  for (const std::int64_t removed : removedCells) {
    look(removed);
    visitNeighbours(organ.rest.lattice, removed, look);
  }
}

}  // namespace resect
