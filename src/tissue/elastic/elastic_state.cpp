#include "tissue/elastic/elastic_state.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "base/error.h"
#include "tissue/elastic/boundary_cells.h"
#include "tissue/elastic/elastic_setup.h"
#include "tissue/elastic/kernel/elastic_kernel.h"
#include "tissue/elastic/uneven_cells.h"

namespace resect {
namespace {

constexpr double kLeastMoment = 0.15;  // smallest eigenvalue of a moment that can be inverted
// Smallest inertia of a particle and of a boundary cell, as a share of a full cell's mass. With
// less, substeps would have to be shorter, since the stresses of its neighbours act on it in full.
constexpr float kLeastInertia = 1, kLeastAtBoundary = 0.5f;

template <std::size_t N>
void allocate(std::array<FloatArray, N>& arrays, std::int32_t size) {
  for (FloatArray& a : arrays) a.assign(size, 0);
}

Mat3 momentOf(const ElasticState& s, std::int32_t i, const std::array<double, 4>& weights) {
  Mat3 moment = Mat3::Zero();
  for (int d = 0; d < kDirections; ++d) {
    if (!(s.bonds[i] >> d & 1)) continue;
    const Vec3 x = offsetOf(d).cast<double>();
    moment += weights[neighbourKind(d)] * x * x.transpose();
  }
  return moment;
}

bool canBeInverted(const Mat3& moment) {
  Eigen::SelfAdjointEigenSolver<Mat3> eigen;
  eigen.computeDirect(moment, Eigen::EigenvaluesOnly);
  return eigen.eigenvalues().minCoeff() >= kLeastMoment;
}

void putMoment(ElasticState& s, std::int32_t i, const std::array<double, 4>& weights) {
  Mat3 moment = momentOf(s, i, weights);
  Vec3 skew = Vec3::Zero();
  for (int d = 0; d < kDirections; ++d) {
    if (!(s.bonds[i] >> d & 1)) continue;
    skew += weights[neighbourKind(d)] * offsetOf(d).cast<double>();
  }
  // Exactly, without rounding: kernels leave out terms that are zero.
  if (s.bonds[i] == kAllBonds) {
    moment = moment(0, 0) * Mat3::Identity();
    skew.setZero();
  }
  Mat3 inverse = Mat3::Zero();
  s.kappa[i] = 0;
  if (s.solid[i] && canBeInverted(moment)) {
    const MaterialJoint joint = jointAt(s, i);
    inverse = joint.toOwn * moment.inverse() * joint.toOwn;
    s.kappa[i] = float(s.penalty * joint.shear * s.spacing * s.spacing * s.spacing);
  }
  const std::array<double, 6> packed = {inverse(0, 0), inverse(1, 1), inverse(2, 2),
                                        inverse(0, 1), inverse(0, 2), inverse(1, 2)};
  const double edge = weights[2];
  for (int k = 0; k < 6; ++k) s.inverseMoment[k][i] = float(packed[k] * edge / s.spacing);
  for (int a = 0; a < 3; ++a) s.skew[a][i] = float(skew[a] / edge);
}

// Computes ElasticState::planeWeight for each given cell, the cells before and after it in the row,
// and the same in neighbouring rows.
void putPlaneWeights(ElasticState& s, std::span<const std::int32_t> cells) {
  const std::array<double, 4> weights = bondWeights();
  const auto weigh = [&](std::int32_t p) {
    Vec3 sum = Vec3::Zero();
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        const std::int32_t q = p + y * s.box.strideY + z * s.box.strideZ;
        if (q < 0 || q >= s.box.size || !s.solid[q])
          continue;  // cells of the halo have no neighbours
        sum += weights[1 + y * y + z * z] / weights[2] * Vec3(1, y, z);
      }
    for (int k = 0; k < 3; ++k) s.planeWeight[k][p] = float(sum[k]);
  };
  for (const std::int32_t i : cells)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) weigh(i + y * s.box.strideY + z * s.box.strideZ);
}

void putBranches(ElasticState& s, std::int32_t i, const TissueMaterial& material) {
  const double volume = s.spacing * s.spacing * s.spacing * double(s.share[i]);
  for (std::size_t k = 0; k < std::size_t(s.branches()); ++k) {
    const bool there = k < material.branches.size() && s.solid[i];
    s.branchVolume[k][i] =
        there ? float(material.branches[k].share * material.shear() * volume) : 0.f;
    s.branchRate[k][i] = there ? float(1 / material.branches[k].time) : 0.f;
  }
  s.viscousVolume[i] = s.solid[i] ? float(material.viscousShear() * volume) : 0.f;
}

// Clears a cell that was removed.
void clearCell(ElasticState& s, std::int32_t i) {
  s.inverseMass[i] = s.shearVolume[i] = s.lameVolume[i] = s.stiffening[i] = 0;
  for (int k = 0; k < s.branches(); ++k)
    for (FloatArray& component : s.relaxed[std::size_t(k)]) component[i] = 0;
  if (s.branches() > 0) putBranches(s, i, {});
  for (int a = 0; a < 3; ++a) {
    s.u[a][i] = s.ahead[a][i] = s.v[a][i] = s.load[a][i] = s.bondForce[a][i] = 0;
    for (int b = 0; b < 3; ++b) s.stress[3 * a + b][i] = 0;
  }
}

// Bonds cells to their solid neighbours.
void bondAll(ElasticState& s, std::span<const std::int32_t> all) {
  for (const std::int32_t i : all)
    for (int d = 0; d < kDirections; ++d)
      if (isParticle(s, i) && isParticle(s, i + s.box.step[d])) s.bonds[i] |= 1u << d;
  for (const std::int32_t i : all)
    for (int d = 0; d < kDirections; ++d)
      if (const std::int32_t j = i + s.box.step[d];
          s.owner[i] && s.solid[j] && connected(s, i, j)) {
        s.bonds[i] |= 1u << d;
        s.bonds[j] |= 1u << opposite(d);
      }
}

// Whether every solid neighbour is bonded.
bool uncut(const ElasticState& s, std::int32_t i) {
  for (int d = 0; d < kDirections; ++d)
    if (s.solid[i + s.box.step[d]] && !(s.bonds[i] >> d & 1)) return false;
  return true;
}

// Whether the inverse moment is other than a multiple of the identity.
bool oneSided(const ElasticState& s, std::int32_t i) {
  const auto& l = s.inverseMoment;
  return l[0][i] != l[1][i] || l[0][i] != l[2][i] || l[3][i] != 0 || l[4][i] != 0 || l[5][i] != 0;
}

// Whether a cell lacks a gradient or has a bond to a cell of another stiffness.
bool uneven(const ElasticState& s, std::int32_t i) {
  if (s.kappa[i] == 0) return true;
  for (int d = 0; d < kDirections; ++d)
    if ((s.bonds[i] >> d & 1) && s.kappa[i + s.box.step[d]] != s.kappa[i]) return true;
  return false;
}

}  // namespace

int ElasticState::branches() const {
  return int(std::ranges::count_if(relaxed, [](const auto& branch) { return !branch[0].empty(); }));
}

void allocateBranches(ElasticState& s) {
  std::size_t most = 0;
  for (const TissueMaterial& material : s.materials)
    most = std::max(most, material.branches.size());
  if (most == 0 && s.capsule.empty()) return;
  if (s.viscousVolume.empty()) {
    s.viscousVolume.assign(s.box.size, 0);
    allocate(s.viscous, s.box.size);
  }
  for (std::size_t k = 0; k < most; ++k) {
    if (s.relaxed[k][0].empty()) allocate(s.relaxed[k], s.box.size);
    if (!s.branchVolume[k].empty()) continue;
    s.branchVolume[k].assign(s.box.size, 0);
    s.branchRate[k].assign(s.box.size, 0);
  }
}

ElasticState makeElasticState(const TissueCells& cells, double penalty) {
  const Lattice& lattice = cells.lattice;
  if (!lattice.cubic())
    throw error(
        "the organ's cells are {:.4g} x {:.4g} x {:.4g} mm; only cubic cells can deform: "
        "discretise the organ again with one spacing",
        1e3 * lattice.spacing.x(), 1e3 * lattice.spacing.y(), 1e3 * lattice.spacing.z());
  ElasticState s;
  s.box = CellBox(lattice.dims);
  s.spacing = lattice.spacing.x();
  s.penalty = penalty;
  s.materials = cells.materials;
  allocate(s.u, s.box.size);
  allocate(s.ahead, s.box.size);
  allocate(s.v, s.box.size);
  allocate(s.stress, s.box.size);
  allocate(s.bondForce, s.box.size);
  allocate(s.inverseMoment, s.box.size);
  allocate(s.skew, s.box.size);
  allocate(s.planeWeight, s.box.size);
  allocate(s.load, s.box.size);
  for (FloatArray* a : {&s.inverseMass, &s.share, &s.weight, &s.shearVolume, &s.lameVolume,
                        &s.stiffening, &s.kappa})
    a->assign(s.box.size, 0);
  allocateBranches(s);
  s.bonds.assign(s.box.size, 0);
  for (auto* a : {&s.solid, &s.held, &s.loaded, &s.material, &s.capsuleTorn, &s.owner})
    a->assign(s.box.size, 0);

  const std::vector<float> shares = stressShares(cells);
  std::vector<std::int32_t> all;
  for (std::int64_t cell = 0; cell < lattice.cellCount(); ++cell) {
    if (!holdsTissue(cells, cell)) continue;
    const std::int32_t i = s.box.fromLattice(cell);
    all.push_back(i);
    s.solid[i] = 1;
    s.share[i] = shares[std::size_t(cell)];
    if (!cells.solid[cell]) s.owner[i] = cells.owner[cell];
  }
  for (const std::int32_t i : all)
    if (!cells.material.empty()) s.material[i] = cells.material[s.box.toLattice(ownerOf(s, i))];
  bondAll(s, all);
  remakeCells(s, all);
  refreshCells(s, all);
  for (auto thin = thinBoundary(s, all); !thin.empty(); thin = thinBoundary(s, all)) {
    for (const std::int32_t i : thin) removeCell(s, i);
    refreshCells(s, all);
  }
  return s;
}

void checkMaterial(const TissueMaterial& m) {
  const auto within = [](double value, double low, double high) {
    return value >= low && value <= high;
  };
  require(within(m.young, 1, 1e9) && within(m.poisson, 0, 0.4999) && within(m.density, 1, 1e5) &&
              m.tearEnergy > 0,
          "material \"{}\" has young = {} Pa, poisson = {}, density = {} kg/m^3, tearEnergy = {} "
          "J/m^2; "
          "give young from 1 to 1e9, poisson from 0 to 0.4999, density from 1 to 1e5, tearEnergy "
          "above 0",
          m.name, m.young, m.poisson, m.density, m.tearEnergy);
  require(within(m.capsule, 0, 1e5) && m.capsuleStrength > 0 && within(m.capsuleTension, 0, 1e4),
          "material \"{}\" has capsule = {} N/m with a strength of {} N/m and a tension of {} N/m; "
          "give "
          "a capsule from 0 to 1e5, a strength above 0, and a tension from 0 to 1e4",
          m.name, m.capsule, m.capsuleStrength, m.capsuleTension);
  require(
      within(m.cutEnergy, 0, 1e6) && within(m.capsuleCutEnergy, 0, 1e4),
      "material \"{}\" has cutEnergy = {} J/m^2 and capsuleCutEnergy = {} J/m; give 0 to 1e6, and "
      "0 to 1e4",
      m.name, m.cutEnergy, m.capsuleCutEnergy);
  require(within(m.stiffening, 0, 20) && m.branches.size() <= kMostBranches &&
              std::ranges::all_of(m.branches,
                                  [&](const Relaxation& branch) {
                                    return within(branch.share, 0, 10) &&
                                           within(branch.time, 0.005, 1000);
                                  }),
          "material \"{}\" has stiffening = {} and {} Maxwell branches; give stiffening from 0 to "
          "20, and at most {} branches with shares from 0 to 10 and times from 0.005 to 1000 s",
          m.name, m.stiffening, m.branches.size(), kMostBranches);
}

std::uint8_t materialNumber(ElasticState& s, const TissueMaterial& material) {
  const auto known = std::ranges::find(s.materials, material);
  const auto number = std::size_t(known - s.materials.begin());
  if (number > 255)
    throw error("the tissue has 256 materials already; use one of them for \"{}\"", material.name);
  if (known == s.materials.end()) s.materials.push_back(material);
  return std::uint8_t(number);
}

void remakeCells(ElasticState& s, std::span<const std::int32_t> cells) {
  const double whole = s.spacing * s.spacing * s.spacing;
  for (const std::int32_t i : cells) {
    if (!s.solid[i]) {
      clearCell(s, i);
      continue;
    }
    const TissueMaterial& material = s.materials[s.material[i]];
    const float inertia = std::max(s.share[i], s.owner[i] ? kLeastAtBoundary : kLeastInertia);
    s.inverseMass[i] = float(1 / (material.density * double(inertia) * whole));
    s.weight[i] = s.share[i] / inertia;
    const double volume = double(s.share[i]) * whole;
    s.shearVolume[i] = float(material.shear() * volume);
    s.lameVolume[i] =
        float((material.lame() + material.shear() + material.viscousShear() / 3) * volume);
    s.stiffening[i] = float(material.stiffening);
    if (s.branches() > 0) putBranches(s, i, material);
  }
  putPlaneWeights(s, cells);
}

void severBond(ElasticState& s, std::int32_t i, int direction) {
  s.bonds[i] &= ~(1u << direction);
  s.bonds[i + s.box.step[direction]] &= ~(1u << opposite(direction));
}

void removeCell(ElasticState& s, std::int32_t i) {
  for (int d = 0; d < kDirections; ++d)
    if (s.bonds[i] >> d & 1) severBond(s, i, d);
  s.solid[i] = s.held[i] = s.loaded[i] = s.capsuleTorn[i] = 0;
  clearCell(s, i);
  putPlaneWeights(s, {&i, 1});
}

void refreshCells(ElasticState& s, std::span<const std::int32_t> cells) {
  const std::array<double, 4> weights = bondWeights();
  for (const std::int32_t i : cells) putMoment(s, i, weights);
  refreshChunks(s, cells);
}

void refreshChunks(ElasticState& s, std::span<const std::int32_t> cells) {
  // Chunks that contain one of the cells or a neighbour of it.
  std::vector<std::int32_t> starts;
  for (const std::int32_t i : cells)
    for (int row = -1; row <= 1; ++row)
      for (int plane = -1; plane <= 1; ++plane)
        for (int x = -1; x <= 1; ++x)
          starts.push_back((i + x + row * s.box.strideY + plane * s.box.strideZ) / kChunk * kChunk);
  std::sort(starts.begin(), starts.end());
  starts.erase(std::unique(starts.begin(), starts.end()), starts.end());

  std::vector<TissueChunk> fresh;
  for (const std::int32_t start : starts) {
    TissueChunk chunk;
    chunk.start = start;
    for (int half = 0; half < 2; ++half) {
      chunk.full[half] = true;
      for (std::int32_t i = start + half * kChunk / 2; i < start + (half + 1) * kChunk / 2; ++i) {
        chunk.full[half] &= s.bonds[i] == kAllBonds && !oneSided(s, i) &&
                            (s.skinArea.empty() || !(s.skinArea[i] > 0));
        if (!s.solid[i]) continue;
        chunk.first = std::min(chunk.first, std::int8_t(i - start));
        chunk.last = std::int8_t(i - start);
        chunk.steered |= s.held[i] || s.loaded[i];
        chunk.uneven |= uneven(s, i);
        chunk.skin |= !s.skinArea.empty() && s.skinArea[i] > 0;
        chunk.whole &= uncut(s, i);
      }
    }
    if (chunk.last >= 0) fresh.push_back(chunk);
  }
  // Merge: an updated chunk replaces the old one, or is dropped if empty.
  std::vector<TissueChunk> merged;
  merged.reserve(s.chunks.size() + fresh.size());
  auto next = fresh.begin();
  auto looked = starts.begin();
  for (const TissueChunk& old : s.chunks) {
    for (; next != fresh.end() && next->start < old.start; ++next) merged.push_back(*next);
    while (looked != starts.end() && *looked < old.start) ++looked;
    if (looked == starts.end() || *looked != old.start) merged.push_back(old);
  }
  merged.insert(merged.end(), next, fresh.end());
  s.chunks = std::move(merged);
}

ElasticView viewOf(ElasticState& s) {
  ElasticView view{};
  for (int a = 0; a < 3; ++a) {
    view.u[a] = s.u[a].data();
    view.ahead[a] = s.ahead[a].data();
    view.v[a] = s.v[a].data();
    view.bondForce[a] = s.bondForce[a].data();
    view.skew[a] = s.skew[a].data();
    view.planeWeight[a] = s.planeWeight[a].data();
    view.load[a] = s.load[a].data();
  }
  for (int k = 0; k < 9; ++k) view.stress[k] = s.stress[k].data();
  for (int k = 0; k < 6; ++k) view.inverseMoment[k] = s.inverseMoment[k].data();
  view.branches = s.branches();
  for (std::size_t k = 0; k < std::size_t(view.branches); ++k) {
    view.branchVolume[k] = s.branchVolume[k].data();
    view.branchRate[k] = s.branchRate[k].data();
    for (std::size_t c = 0; c < 6; ++c) view.relaxed[k][c] = s.relaxed[k][c].data();
  }
  for (std::size_t c = 0; c < 6; ++c) view.viscous[c] = s.viscous[c].data();
  view.viscousVolume = s.viscousVolume.data();
  view.stiffening = s.stiffening.data();
  view.capsule = s.capsule.empty() ? nullptr : s.capsule.data();
  view.tightness = s.tightness.empty() ? nullptr : s.tightness.data();
  for (std::size_t a = 0; a < 3; ++a) view.skinNormal[a] = s.skinNormal[a].data();
  view.inverseMass = s.inverseMass.data();
  view.weight = s.weight.data();
  view.shearVolume = s.shearVolume.data();
  view.lameVolume = s.lameVolume.data();
  view.kappa = s.kappa.data();
  view.bonds = s.bonds.data();
  view.held = s.held.data();
  view.chunks = s.chunks.data();
  std::copy(s.box.step.begin(), s.box.step.end(), view.step);
  return view;
}

}  // namespace resect
