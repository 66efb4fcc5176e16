#include "organ/incision/moved_incision.h"

#include <algorithm>
#include <array>

#include "base/index_box.h"
#include "wound/node_places.h"

namespace resect {
namespace {

// The motions of the particles in a box of cells.
class Motions {
 public:
  struct Motion : ParticleMotion {
    Column reach;  // half extents of the deformed cell's bounding box
  };

  // `wanted`: per cell of the box; others are computed on demand.
  Motions(const Organ& organ, const TissueModel& tissue, const IndexBox& box,
          std::span<const std::uint8_t> wanted)
      : lattice_(organ.rest.lattice), tissue_(tissue), box_(box), number_(box.count(), -1) {
    std::vector<std::int64_t> cells;
    std::vector<Vec3f> rest;
    const Vec3i low = box.low.cwiseMax(0), high = (box.low + box.dims).cwiseMin(lattice_.dims);
    for (int z = low.z(); z < high.z(); ++z)
      for (int y = low.y(); y < high.y(); ++y) {
        std::int64_t cell = lattice_.index({low.x(), y, z});
        std::size_t i = std::size_t(box.index({low.x(), y, z}));
        for (int x = low.x(); x < high.x(); ++x, ++cell, ++i)
          if (wanted[i] && organ.alive[std::size_t(cell)] && organ.rest.inside[std::size_t(cell)]) {
            number_[i] = std::int32_t(cells.size());
            cells.push_back(cell);
            rest.push_back(lattice_.centre({x, y, z}).cast<float>());
          }
      }
    std::vector<CellPlacement> placements(cells.size());
    tissue.place(cells, placements);
    const Vec3f half = 0.5f * lattice_.spacing.cast<float>();
    motions_.resize(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto& [displacement, gradient] = placements[i];
      static_cast<ParticleMotion&>(motions_[i]) = particleMotion(rest[i], displacement, gradient);
      const Vec3f reach = (gradient + Eigen::Matrix3f::Identity()).cwiseAbs() * half;
      motions_[i].reach = column(reach);
    }
  }

  const Motion* at(const Vec3i& cell) const {  // null where no particle is
    const std::int32_t n = number_[std::size_t(box_.index(cell))];
    return n < 0 ? nullptr : &motions_[std::size_t(n)];
  }
  // Motion of any particle by its lattice index. Valid until the next call. Many nodes follow the
  // same particles, so results are cached in a table that needs no division.
  const ParticleMotion& of(std::int32_t cell) {
    Found& found = found_[std::size_t(cell) % kFound];
    if (found.cell != cell) found = {cell, numberOf(cell)};
    if (found.number >= 0) return motions_[std::size_t(found.number)];
    const std::int64_t index = cell;
    CellPlacement place;
    tissue_.place({&index, 1}, {&place, 1});
    return far_ = particleMotion(lattice_.centre(lattice_.cell(cell)).cast<float>(),
                                 place.displacement, place.gradient);
  }

 private:
  struct Found {
    std::int32_t cell = -1, number = -1;
  };
  static constexpr std::size_t kFound = 512;

  std::int32_t numberOf(std::int32_t cell) const {
    const Vec3i at = lattice_.cell(cell);
    return box_.contains(at) ? number_[std::size_t(box_.index(at))] : -1;
  }

  const Lattice& lattice_;
  const TissueModel& tissue_;
  IndexBox box_;
  std::vector<std::int32_t> number_;  // per cell of the box, -1 where not asked
  std::vector<Motion> motions_;
  std::array<Found, kFound> found_;
  ParticleMotion far_;
};

// Bounding boxes of the blade's triangles.
class BladeBoxes {
 public:
  explicit BladeBoxes(const SweptBlade& blade) : all_(boxOf(blade.bounds)) {
    for (const BladeTriangle& t : blade.triangles) {
      Aabb box;
      for (const Vec3& p : {t.corner, t.otherU, t.otherV}) box.grow(p);
      triangles_.push_back(boxOf(box));
    }
  }
  // Whether the blade may meet the box.
  bool mayMeet(const Column& low, const Column& high) const {
    return meets(all_, low, high) &&
           std::ranges::any_of(triangles_, [&](const Box& t) { return meets(t, low, high); });
  }

 private:
  struct Box {
    Column low, high;
  };
  static Box boxOf(const Aabb& box) {
    return {column(box.min.cast<float>()), column(box.max.cast<float>())};
  }
  static bool meets(const Box& a, const Column& low, const Column& high) {
    const auto apart = (a.low > high) | (a.high < low);
    return !(apart[0] | apart[1] | apart[2]);
  }
  Box all_;
  std::vector<Box> triangles_;
};

bool nearCut(const Organ& organ, const Vec3i& cube) {
  if (organ.severed.empty()) return false;
  const int refine = organ.field.refine();
  const Vec3i first = refine * (cube + Vec3i::Constant(2));
  const Vec3i low = first / kBrickNodes;
  const Vec3i high = (first + Vec3i::Constant(refine - 1)) / kBrickNodes;
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x)
        if (organ.severed.near(organ.field.brickIndex({x, y, z}))) return true;
  return false;
}

// Lattice cubes, by the cell at their lowest corner. A node's position is a weighted mean of the
// positions that the particles of its cube give it (beside a cut also particles farther away), so
// the blade can meet a cube only if it meets the box of all these positions. For a fine grid cubes
// are tested in halves along each axis.
class Cubes {
 public:
  Cubes(const Organ& organ, const Motions& motions, const BladeBoxes& blade)
      : organ_(organ),
        motions_(motions),
        blade_(blade),
        refine_(organ.field.refine()),
        halves_(refine_ == 4 ? 2 : 1),
        spacing_(float(organ.rest.lattice.spacing.maxCoeff())) {}

  // visit(first node, nodes along an axis) for the parts that the blade may meet. cut: whether
  // there is a cut near the cube.
  template <typename Visit>
  void visitMet(const Vec3i& cube, bool cut, Visit visit) const {
    const Vec3i first = refine_ * (cube + Vec3i::Constant(2));
    const int side = refine_ / halves_;
    for (int z = 0; z < halves_; ++z)
      for (int y = 0; y < halves_; ++y)
        for (int x = 0; x < halves_; ++x)
          if (mayMeet(cube, Vec3i(x, y, z), cut)) visit(first + side * Vec3i(x, y, z), side);
  }

 private:
  bool mayMeet(const Vec3i& cube, const Vec3i& part, bool cut) const {
    constexpr float kFar = 1e30f, kRounding = 1e-3f, kBesideCut = 0.25f;  // the last in spacings
    const float share = 1 / float(halves_);
    const Lattice& lattice = organ_.rest.lattice;
    // Cubes are offset by half a spacing from cells.
    const Vec3 inCube = share * (part.cast<double>() + Vec3::Constant(0.5));
    const Vec3f middle =
        (lattice.centre(cube) + lattice.spacing.cwiseProduct(inCube)).cast<float>();
    Column low = {kFar, kFar, kFar, 0}, high = {-kFar, -kFar, -kFar, 0};
    const int more = cut ? 1 : 0;
    for (int z = -more; z <= 1 + more; ++z)
      for (int y = -more; y <= 1 + more; ++y)
        for (int x = -more; x <= 1 + more; ++x) {
          const Motions::Motion* motion = motions_.at(cube + Vec3i(x, y, z));
          if (!motion) continue;
          const Column moved = displacementAt(*motion, middle), reach = share * motion->reach;
          const Column least = moved - reach, most = moved + reach;
          low = least < low ? least : low;
          high = most > high ? most : high;
        }
    const float slack = spacing_ * (cut ? kBesideCut : kRounding);
    return blade_.mayMeet(low + column(middle) - slack, high + column(middle) + slack);
  }

  const Organ& organ_;
  const Motions& motions_;
  const BladeBoxes& blade_;
  int refine_, halves_;
  float spacing_;
};

// A set of nodes, and the bricks whose cells use them.
class NodeList {
 public:
  // nodes: all that will be added lie in it.
  explicit NodeList(const IndexBox& nodes) : box_(nodes), number_(nodes.count(), -1) {
    const Vec3i low = nodes.low / kBrickNodes, high = (nodes.low + nodes.dims) / kBrickNodes;
    bricks_ = {low, high - low + Vec3i::Ones()};
    holdsCells_.assign(bricks_.count(), 0);
  }
  // Adds the nodes of `side` grid cells along each axis.
  void add(const Vec3i& first, int side) {
    for (int z = 0; z <= side; ++z)
      for (int y = 0; y <= side; ++y)
        for (int x = 0; x <= side; ++x) {
          const Vec3i node = first + Vec3i(x, y, z);
          std::int32_t& number = number_[std::size_t(box_.index(node))];
          if (number >= 0) continue;
          number = std::int32_t(nodes_.size());
          nodes_.push_back(node);
        }
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3i end = (side - 1) * Vec3i(corner & 1, corner >> 1 & 1, corner >> 2);
      holdsCells_[std::size_t(bricks_.index((first + end) / kBrickNodes))] = 1;
    }
  }
  const std::vector<Vec3i>& nodes() const { return nodes_; }
  std::vector<std::int64_t> bricks(const ColourField& field) const {  // ascending
    std::vector<std::int64_t> found;
    for (std::size_t i = 0; i < holdsCells_.size(); ++i)
      if (holdsCells_[i]) found.push_back(field.brickIndex(bricks_.coordinates(std::int32_t(i))));
    return found;
  }
  // Copies a brick's positions from `places`, which are in the order of nodes().
  void copyPlaces(const Vec3i& brick, std::span<const Vec3> places,
                  std::span<Vec3, kPlacedNodes> out) const {
    const Vec3 none = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    const Vec3i first = kBrickNodes * brick;
    for (int i = 0; i < kPlacedNodes; ++i) out[std::size_t(i)] = none;
    const Vec3i low = (box_.low - first).cwiseMax(0);
    const Vec3i high = (box_.low + box_.dims - first).cwiseMin(kBrickNodes + 1);
    for (int z = low.z(); z < high.z(); ++z)
      for (int y = low.y(); y < high.y(); ++y) {
        const std::int32_t* row = number_.data() + box_.index(first + Vec3i(0, y, z));
        for (int x = low.x(); x < high.x(); ++x)
          if (row[x] >= 0) out[std::size_t((z * 5 + y) * 5 + x)] = places[std::size_t(row[x])];
      }
  }

 private:
  IndexBox box_, bricks_;
  std::vector<std::int32_t> number_;  // per node of the box
  std::vector<Vec3i> nodes_;
  std::vector<std::uint8_t> holdsCells_;
};

// Marks what lies within `low` to `high` of a mark, both in [-1, 1], along each axis.
void spread(std::vector<std::uint8_t>& marks, const IndexBox& box, int low, int high) {
  std::uint8_t* mark = marks.data();  // local copy: a store of a byte may alias the member
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t step = std::size_t(box.step(axis)), n = marks.size();
    if (low < 0)
      for (std::size_t i = 0; i + step < n; ++i) mark[i] |= mark[i + step];
    if (high > 0)
      for (std::size_t i = n; i-- > step;) mark[i] |= mark[i - step];
  }
}

}  // namespace

std::int64_t inciseMoved(Organ& organ, const TissueModel& tissue, const SweptBlade& blade,
                         std::span<const std::int64_t> nearCells) {
  if (blade.empty() || nearCells.empty()) return 0;
  if (!tissue.moves()) return incise(organ, blade);
  // Cubes round the near cells; and the cells that determine their nodes' positions: their corners,
  // beside a cut one more cell each way.
  std::vector<Vec3i> near;
  for (const std::int64_t cell : nearCells) near.push_back(organ.rest.lattice.cell(cell));
  const IndexBox box = boxRound(near).widened(3);
  std::vector<std::uint8_t> cubes(box.count(), 0), cut(box.count(), 0);
  for (const Vec3i& cell : near) cubes[std::size_t(box.index(cell))] = 1;
  spread(cubes, box, -1, 0);
  for (std::size_t i = 0; i < cubes.size(); ++i)
    cut[i] = cubes[i] && nearCut(organ, box.coordinates(std::int32_t(i)));
  std::vector<std::uint8_t> asked = cut;
  spread(asked, box, -1, 1);
  for (std::size_t i = 0; i < cubes.size(); ++i) asked[i] |= cubes[i];
  spread(asked, box, 0, 1);
  Motions motions(organ, tissue, box, asked);

  const BladeBoxes boxes(blade);
  const Cubes bounds(organ, motions, boxes);
  const int refine = organ.field.refine();
  NodeList list({refine * (box.low + Vec3i::Constant(2)), refine * box.dims});
  for (std::size_t i = 0; i < cubes.size(); ++i)
    if (cubes[i])
      bounds.visitMet(box.coordinates(std::int32_t(i)), cut[i],
                      [&](const Vec3i& first, int side) { list.add(first, side); });

  const Wound wound{organ.severed, organ.alive};
  const std::vector<Vec3> places =
      placeNodes(organ.field, wound, organ.surface.iso(), list.nodes(),
                 [&](std::int32_t cell) -> const ParticleMotion& { return motions.of(cell); });
  return incise(organ, blade, list.bricks(organ.field),
                [&](const Vec3i& brick, std::span<Vec3, kPlacedNodes> out) {
                  list.copyPlaces(brick, places, out);
                });
}

}  // namespace resect
