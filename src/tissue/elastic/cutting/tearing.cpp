// Finds the bonds that tear: docs/methods/tissue.md, "Tearing".
#include "tissue/elastic/cutting/tearing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tissue/elastic/boundary_cells.h"
#include "tissue/elastic/elastic_tissue.h"
#include "tissue/elastic/gradient.h"

namespace resect {
namespace {

struct Strained {
  std::int32_t cell = 0;
  double energy = 0;          // per volume at rest, J/m^3
  Vec3 along = Vec3::Zero();  // unit vector of rest space along which the cell is stretched most
};

struct Candidate {
  std::int32_t cell = 0;
  bool cut = false;  // a bond of it, or of a neighbour, is severed
};

// Energies of cells.
class Energies {
 public:
  Energies(const ElasticState& state, const ElasticKernel& kernel)
      : state_(state), gradients_(state, kernel) {}

  // J/m^3.
  double energy(std::int32_t i) {
    if (state_.kappa[i] == 0) return inString(i).energy;
    return freeEnergy(state_, i, gradients_.at(i) + Mat3::Identity());
  }
  // Each cell is computed once. The reference holds until the next call.
  const Strained& at(std::int32_t i) {
    const auto place = std::ranges::lower_bound(known_, i, {}, &Strained::cell);
    if (place != known_.end() && place->cell == i) return *place;
    Strained one;
    if (state_.kappa[i] == 0) {
      one = inString(i);
    } else {
      const Mat3 f = gradients_.at(i) + Mat3::Identity();
      one = {i, freeEnergy(state_, i, f), mostStretched(f)};
    }
    return *known_.insert(place, one);
  }

 private:
  // A cell without a gradient, in a string or sheet of single cells: it is stretched as much as the
  // bond that is stretched most.
  Strained inString(std::int32_t i) const {
    Strained one{i, 0, Vec3::UnitX()};
    double most = 1;
    for (int d = 0; d < kDirections; ++d) {
      if (!(state_.bonds[i] >> d & 1)) continue;
      const Vec3 rest = state_.spacing * offsetOf(d).cast<double>();
      Vec3 now = rest;
      for (int a = 0; a < 3; ++a)
        now[a] += double(state_.u[a][i + state_.box.step[d]]) - state_.u[a][i];
      const double stretch = now.norm() / rest.norm();
      if (stretch > most) most = stretch, one.along = rest.normalized();
    }
    one.energy = state_.materials[state_.material[i]].young / 2 * (most - 1) * (most - 1);
    return one;
  }

  const ElasticState& state_;
  ChunkGradients gradients_;
  std::vector<Strained> known_;  // ascending by cell
};

// Sorts by cell and keeps one of each; at a cut goes before not.
void settleCandidates(std::vector<Candidate>& list) {
  std::ranges::sort(list, [](const Candidate& a, const Candidate& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.cut > b.cut;
  });
  const auto rest = std::ranges::unique(list, {}, &Candidate::cell);
  list.erase(rest.begin(), rest.end());
}

bool has(const std::vector<Candidate>& list, std::int32_t cell) {
  const auto at = std::ranges::lower_bound(list, cell, {}, &Candidate::cell);
  return at != list.end() && at->cell == cell;
}

// How much a bond bears of what would tear its cells: the energy of both, J/m^3, less for a bond
// that lies oblique to the stretch.
double drive(const ElasticState& s, Energies& energies, std::int32_t i, int d) {
  const Strained a = energies.at(i), b = energies.at(i + s.box.step[d]);
  const Vec3 along = offsetOf(d).cast<double>().normalized();
  const double one = along.dot(a.along), other = along.dot(b.along);
  return 0.5 * (a.energy + b.energy) * std::max(one * one, other * other);
}

// The bonds of both ends of the bond (i, d) that cross the plane through its middle, across the
// stretch of the end with more energy.
void tearAcross(const ElasticState& s, Energies& energies, std::int32_t i, int d,
                std::vector<TissueBond>& torn) {
  const Strained a = energies.at(i), b = energies.at(i + s.box.step[d]);
  const Vec3 normal = a.energy >= b.energy ? a.along : b.along;
  const Vec3 way = offsetOf(d).cast<double>();
  for (const int end : {0, 1}) {
    const std::int32_t k = end == 0 ? i : i + s.box.step[d];
    const double from = normal.dot((end - 0.5) * way);
    const std::uint32_t bonds = particleBonds(s, k);
    for (int e = 0; e < kDirections; ++e) {
      if (!(bonds >> e & 1)) continue;
      if (from * (from + normal.dot(offsetOf(e).cast<double>())) >= 0) continue;
      if (e >= kFirstForward)
        torn.push_back({s.box.toLattice(k), e});
      else
        torn.push_back({s.box.toLattice(k + s.box.step[e]), opposite(e)});
    }
  }
}

}  // namespace

// F^T F, squared again and again, tends to a multiple of n n^T. No elementary function is used, so
// the bits are the same on every machine.
Vec3 mostStretched(const Mat3& f) {
  Mat3 c = f.transpose() * f;
  for (int k = 0; k < 8; ++k) {
    c /= c.trace();
    c = (c * c).eval();
  }
  int column = 0;
  for (int a = 1; a < 3; ++a)
    if (c(a, a) > c(column, column)) column = a;
  return c.col(column).normalized();
}

// letGo: tools whose grip has slipped. What tears depends on the state at the end of the frame
// alone, so no order of cells matters.
void ElasticTissue::findTears(std::span<const std::int32_t> letGo, std::vector<TissueBond>& torn) {
  torn.clear();
  const ElasticState& s = state_;
  const double advance = s.spacing / kTearSpeed;  // s, of a crack by a cell
  sinceTear_ = std::min(sinceTear_ + frame_.duration, 2 * advance);
  if (sinceTear_ < advance * (1 - 1e-9)) return;
  double weakest = std::numeric_limits<double>::infinity();
  for (const TissueMaterial& m : s.materials) weakest = std::min(weakest, m.tearEnergy);
  if (std::isinf(weakest)) return;
  const double atCrack = kCrackShare / s.spacing;  // energy per volume over tear energy, 1/m
  const double elsewhere = std::max(atCrack, 1 / kTearLength);

  // Cells with enough energy: at cuts and beside them, since the tip of a crack may lie a cell
  // ahead of the severed bonds; and near grips.
  Energies energies(s, *kernel_);
  std::vector<Candidate> candidates;
  for (const std::int32_t i : cut_)
    if (particleBonds(s, i) != 0 && energies.energy(i) >= kScreen * weakest * atCrack) {
      candidates.push_back({i, true});
      const std::uint32_t bonds = particleBonds(s, i);
      for (int d = 0; d < kDirections; ++d)
        if (bonds >> d & 1) candidates.push_back({i + s.box.step[d], true});
    }
  const int reach = std::max(1, int(std::lround(kGripReach / s.spacing)));
  Vec3i low = Vec3i::Constant(1 << 20), high = Vec3i::Constant(-1);
  for (const TissueSpring& spring : springs_.all()) {
    if (spring.tool < 0 || std::ranges::find(letGo, spring.tool) != letGo.end()) continue;
    const Vec3i at = s.box.cell(spring.cell);
    low = low.cwiseMin(at - Vec3i::Constant(reach));
    high = high.cwiseMax(at + Vec3i::Constant(reach));
  }
  low = low.cwiseMax(0);
  high = high.cwiseMin(lattice_.dims - Vec3i::Ones());
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x)
        if (const std::int32_t i = s.box.index({x, y, z});
            particleBonds(s, i) != 0 && energies.energy(i) >= weakest * elsewhere)
          candidates.push_back({i, false});
  if (candidates.empty()) return;
  settleCandidates(candidates);

  // Those whose energy suffices, and is the highest round them: there a crack's tip is.
  for (const auto& [i, cut] : candidates) {
    const double energy = energies.at(i).energy;
    if (energy < (cut ? atCrack : elsewhere) * s.materials[s.material[i]].tearEnergy) continue;
    double highest = 0, most = 0;
    const std::uint32_t bonds = particleBonds(s, i);
    for (int d = 0; d < kDirections; ++d) {
      if (!(bonds >> d & 1)) continue;
      if (const std::int32_t j = i + s.box.step[d]; has(candidates, j))
        highest = std::max(highest, energies.at(j).energy);
      most = std::max(most, drive(s, energies, i, d));
    }
    if (energy < kAlike * highest) continue;
    for (int d = 0; d < kDirections; ++d)
      if (bonds >> d & 1 && drive(s, energies, i, d) >= kAlike * most)
        tearAcross(s, energies, i, d, torn);
  }
  const auto key = [](const TissueBond& b) { return std::pair(b.cell, b.direction); };
  std::ranges::sort(torn, {}, key);
  const auto rest = std::ranges::unique(torn, {}, key);
  torn.erase(rest.begin(), rest.end());
  if (!torn.empty()) sinceTear_ = std::max(0.0, sinceTear_ - advance);
}

}  // namespace resect
