#include "tissue/elastic/boundary_cells.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tissue/elastic/elastic_setup.h"

namespace resect {
namespace {

// Smallest share of tissue of a boundary cell. With 0.02, beams of 4 cells are up to 8 % too stiff;
// with 0.15 up to 4 % too soft (test/organ/turned_beams_test.cpp).
constexpr float kLeastShare = 0.1f;

float shareOf(const TissueCells& cells, std::int64_t cell) {
  return cells.share.empty() ? float(cells.solid[cell]) : cells.share[cell];
}

// Where the tissue of a cell lies, from the cell's centre, in spacings. The tissue is taken to end
// at a plane: then its middle is half of what is missing away from the centre.
Vec3 middleOfTissue(const TissueCells& cells, const Vec3i& cell) {
  const double share = double(shareOf(cells, cells.lattice.index(cell)));
  if (share >= 1) return Vec3::Zero();
  Vec3 inward = Vec3::Zero();
  for (int d = 0; d < kDirections; ++d) {
    const Vec3i there = cell + offsetOf(d);
    if (!cells.lattice.contains(there)) continue;
    inward += double(shareOf(cells, cells.lattice.index(there))) / neighbourKind(d) *
              offsetOf(d).cast<double>();
  }
  const double length = inward.norm();
  return length > 1e-9 ? Vec3(0.5 * (1 - share) / length * inward) : Vec3::Zero();
}

}  // namespace

bool holdsTissue(const TissueCells& cells, std::int64_t cell) {
  return cells.solid[cell] ||
         (!cells.owner.empty() && cells.owner[cell] && cells.share[cell] >= kLeastShare);
}

// With linear shares the second moment of the volume would be too large by what lies between two
// centres. A way w from a centre therefore counts as w (2 - w), so that shares are quadratic.
std::vector<float> stressShares(const TissueCells& cells) {
  const Lattice& lattice = cells.lattice;
  std::vector<float> shares(std::size_t(lattice.cellCount()), 0.0f);
  for (std::int64_t from = 0; from < lattice.cellCount(); ++from) {
    const double share = double(shareOf(cells, from));
    if (!(share > 0)) continue;
    const Vec3i cell = lattice.cell(from);
    const Vec3 middle = middleOfTissue(cells, cell);
    std::array<std::int64_t, 8> to;
    std::array<double, 8> weight;
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
      Vec3i there = cell;
      double w = 1;
      for (int a = 0; a < 3; ++a) {
        const double way = std::abs(middle[a]), part = way * (2 - way);
        const bool moves = corner >> a & 1;
        w *= moves ? part : 1 - part;
        if (moves) there[a] += middle[a] < 0 ? -1 : 1;
      }
      to[corner] = lattice.contains(there) ? lattice.index(there) : -1;
      weight[corner] = to[corner] >= 0 && holdsTissue(cells, to[corner]) ? w : 0;
      sum += weight[corner];
    }
    for (int corner = 0; corner < 8; ++corner)
      if (weight[corner] > 0)
        shares[std::size_t(to[corner])] += float(share * weight[corner] / sum);
  }
  return shares;
}

std::vector<std::int32_t> withBoundary(const ElasticState& s, std::int32_t particle) {
  std::vector<std::int32_t> cells = {particle};
  for (int d = 0; d < kDirections; ++d)
    if (const std::int32_t i = particle + s.box.step[d]; s.solid[i] && ownerOf(s, i) == particle)
      cells.push_back(i);
  return cells;
}

std::uint32_t particleBonds(const ElasticState& s, std::int32_t i) {
  if (s.owner[i]) return 0;
  std::uint32_t bonds = s.bonds[i];
  for (int d = 0; d < kDirections; ++d)
    if (s.owner[i + s.box.step[d]]) bonds &= ~(1u << d);
  return bonds;
}

bool connected(const ElasticState& s, std::int32_t i, std::int32_t j) {
  const std::int32_t a = ownerOf(s, i), b = ownerOf(s, j);
  if (a == b) return true;
  const Vec3i from = s.box.cell(a), to = s.box.cell(b);
  const auto bonded = [&](std::int32_t cell, const Vec3i& offset) {
    return offset.cwiseAbs().maxCoeff() == 1 && (s.bonds[cell] >> directionTo(offset) & 1);
  };
  if ((to - from).cwiseAbs().maxCoeff() == 1) return bonded(a, to - from);
  for (int d = 0; d < kDirections; ++d) {
    const std::int32_t between = a + s.box.step[d];
    if ((s.bonds[a] >> d & 1) && !s.owner[between] && bonded(between, to - from - offsetOf(d)))
      return true;
  }
  return false;
}

void severBoundaryBonds(ElasticState& s, std::vector<std::int32_t>& changed) {
  constexpr int kReach = 2;  // a boundary cell's neighbour may belong to a particle that far away
  std::vector<std::int32_t> near;
  for (const std::int32_t i : changed)
    for (int z = -kReach; z <= kReach; ++z)
      for (int y = -kReach; y <= kReach; ++y)
        for (int x = -kReach; x <= kReach; ++x) {
          const std::int32_t j = i + x + y * s.box.strideY + z * s.box.strideZ;
          if (j >= 0 && j < s.box.size && s.solid[j] && s.owner[j]) near.push_back(j);
        }
  std::ranges::sort(near);
  const auto rest = std::ranges::unique(near);
  near.erase(rest.begin(), rest.end());
  for (const std::int32_t i : near)
    for (int d = 0; d < kDirections; ++d) {
      const std::int32_t j = i + s.box.step[d];
      if (!(s.bonds[i] >> d & 1) || connected(s, i, j)) continue;
      severBond(s, i, d);
      changed.push_back(i);
      changed.push_back(j);
    }
}

std::vector<std::int32_t> thinBoundary(const ElasticState& s, std::span<const std::int32_t> cells) {
  std::vector<std::int32_t> thin;
  for (const std::int32_t i : cells)
    if (s.solid[i] && s.owner[i] && s.kappa[i] == 0) thin.push_back(i);
  return thin;
}

}  // namespace resect
