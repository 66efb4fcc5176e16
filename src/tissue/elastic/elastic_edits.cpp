// Edits of elastic tissue: bonds severed, cells removed, held, loaded.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "tissue/elastic/capsule.h"
#include "tissue/elastic/elastic_setup.h"
#include "tissue/elastic/elastic_tissue.h"

namespace resect {

void ElasticTissue::settle() {
  for (auto* list : {&bondsChanged_, &holdsChanged_, &cut_}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  if (!bondsChanged_.empty()) {
    severBoundaryBonds(state_, bondsChanged_);
    refreshCells(state_, bondsChanged_);
    for (auto thin = thinBoundary(state_, bondsChanged_); !thin.empty();
         thin = thinBoundary(state_, bondsChanged_)) {
      for (const std::int32_t i : thin) removeOne(i);
      refreshCells(state_, bondsChanged_);
    }
    remakeCapsule(state_, bondsChanged_);
    retractCapsule(state_, bondsChanged_);
    fibres_ = findFibres(state_, fibres_);
    uneven_ = findUnevenBonds(state_);
  }
  if (!holdsChanged_.empty()) refreshChunks(state_, holdsChanged_);
  bondsChanged_.clear();
  holdsChanged_.clear();
}

void ElasticTissue::sever(std::int64_t cell, int direction) {
  const std::int32_t i = state_.box.fromLattice(cell);
  if (!(state_.bonds[i] >> direction & 1)) return;
  severBond(state_, i, direction);
  cutFaces_.keepApart(state_, i, direction);
  bondsChanged_.push_back(i);
  bondsChanged_.push_back(i + state_.box.step[direction]);
  cut_.push_back(i);
  cut_.push_back(i + state_.box.step[direction]);
}

void ElasticTissue::remove(std::int64_t cell) {
  const std::int32_t i = state_.box.fromLattice(cell);
  if (!isParticle(state_, i)) return;
  for (const std::int32_t one : withBoundary(state_, i)) removeOne(one);
}

void ElasticTissue::removeOne(std::int32_t i) {
  bondsChanged_.push_back(i);
  for (int d = 0; d < kDirections; ++d)
    if (state_.bonds[i] >> d & 1) bondsChanged_.push_back(i + state_.box.step[d]);
  removeCell(state_, i);
  cutFaces_.forgetCell(i);
  std::erase_if(cords_, [&](const Cord& cord) { return cord.a == i || cord.b == i; });
  std::erase(pulled_, i);
  loosen(springs_.drop([&](const TissueSpring& spring) { return spring.cell == i; }));
}

void ElasticTissue::setCords(std::span<const TissueCord> cords) {
  cords_.clear();
  for (const TissueCord& one : cords) {
    require(one.stiffness >= 0 && std::isfinite(one.stiffness) && one.a != one.b,
            "a cord leads from cell {} to cell {} with {} N/m; give two cells and a finite number "
            "from 0",
            one.a, one.b, one.stiffness);
    if (!solid(one.a) || !solid(one.b)) continue;
    const Vec3 rest = lattice_.centre(lattice_.cell(one.b)) - lattice_.centre(lattice_.cell(one.a));
    Cord cord;
    cord.a = state_.box.fromLattice(one.a), cord.b = state_.box.fromLattice(one.b);
    cord.rest = rest.cast<float>(), cord.length = float(rest.norm());
    cord.wanted = float(one.stiffness);
    cords_.push_back(cord);
  }
  limitCords();
}

// To what the longest substep bears. Call again when that has changed.
void ElasticTissue::limitCords() {
  // Of m / dt^2, all cords of a cell together. Cells that swing against each other on cords add
  // twice this to the square of the highest frequency times the substep, which must be below 4 and
  // is about 1 for the tissue.
  constexpr double kCordShare = 0.9;
  if (cords_.empty()) return;
  std::vector<double> sum(std::size_t(state_.box.size), 0.0);
  for (const Cord& cord : cords_)
    for (const std::int32_t i : {cord.a, cord.b}) sum[std::size_t(i)] += double(cord.wanted);
  for (Cord& cord : cords_) {
    double share = 1;
    for (const std::int32_t i : {cord.a, cord.b})
      if (const double m = mass(state_.box.toLattice(i)); m > 0)
        share = std::min(share, kCordShare * m / (longestSubstep_ * longestSubstep_) /
                                    std::max(sum[std::size_t(i)], 1e-30));
    cord.stiffness = float(share) * cord.wanted;
  }
}

std::int64_t ElasticTissue::attach(const TissueAttachment& attachment) {
  require(attachment.stiffness >= 0 && std::isfinite(attachment.stiffness),
          "a ligament's stiffness is {} N/m; give a finite number from 0", attachment.stiffness);
  if (attachment.kind == TissueAttachment::Kind::Pin) return pin(attachment);
  std::vector<std::int64_t> cells;
  for (std::int64_t c = 0; c < lattice_.cellCount(); ++c)
    if (solid(c) && attachment.holds(lattice_.centre(lattice_.cell(c)))) cells.push_back(c);
  for (const std::int64_t c : cells) {
    // A spring too stiff for the substep would be unstable.
    const double most = 0.2 * mass(c) / (longestSubstep_ * longestSubstep_);
    const double stiffness = std::min(attachment.stiffness / double(cells.size()), most);
    tie(c, stiffness, 0.5 * std::sqrt(stiffness * mass(c)));
  }
  return std::int64_t(cells.size());
}

// Holds the cells that lie in the region, and ties those of which a part does, so that where the
// region ends does not depend on the lattice. A layer of held cells acts like a wall that stands a
// third of a cell from their centres, towards the free cells (docs/validation.md, "own weight"). A
// spring k on the cells behind this wall moves it by `share` cells when it and the tissue up to the
// wall together are as stiff as the tissue up to the moved wall would be:
// k + E s / (2/3) = E s / (2/3 - share).
std::int64_t ElasticTissue::pin(const TissueAttachment& region) {
  constexpr int kSide = 4;           // samples along a cell
  constexpr double kWall = 2.0 / 3;  // cells, from the wall of a held layer to the next centres
  constexpr double kLeastGap = 0.1;  // cells; a spring would be too stiff for the substep
  constexpr double kHeld = 5.0 / 6;  // share; above, a held cell is nearer to what is wanted
  std::int64_t count = 0;
  for (std::int64_t c = 0; c < lattice_.cellCount(); ++c) {
    if (!state_.solid[state_.box.fromLattice(c)]) continue;
    const Vec3 low = lattice_.centre(lattice_.cell(c)) - 0.5 * lattice_.spacing;
    int inside = 0;
    for (int k = 0; k < kSide * kSide * kSide; ++k) {
      const Vec3 at = Vec3(k % kSide, k / kSide % kSide, k / (kSide * kSide)) + Vec3::Constant(0.5);
      inside += region.holds(low + lattice_.spacing.cwiseProduct(at / kSide));
    }
    const double share = double(inside) / (kSide * kSide * kSide);
    if (share >= kHeld) hold(c, kHeldAll);
    if (share > 0 && share < kHeld) {
      const double part = 1 / std::max(kWall - share, kLeastGap) - 1 / kWall;
      const double stiffness = part * material(c)->young * lattice_.spacing.x();
      tie(c, stiffness, 0.5 * std::sqrt(stiffness * mass(c)));
    }
    count += share > 0;
  }
  return count;
}

// A spring from the cell to its rest position.
void ElasticTissue::tie(std::int64_t cell, double stiffness, double damping) {
  const std::int32_t i = state_.box.fromLattice(cell);
  springs_.add({i, -1, lattice_.centre(lattice_.cell(cell)), stiffness, damping});
  state_.loaded[i] = 1;
  holdsChanged_.push_back(i);
}

void ElasticTissue::grip(std::int64_t cell, std::int32_t tool, const Pose& pose) {
  const std::int32_t i = state_.box.fromLattice(cell);
  if (!state_.solid[i] || gripper_[i] >= 0) return;
  const double dt = longestSubstep_;
  springs_.add({i, tool,
                pose.inverse() * (lattice_.centre(lattice_.cell(cell)) + displacement(cell)),
                0.2 * mass(cell) / (dt * dt), 0.5 * mass(cell) / dt});
  gripper_[i] = tool;
  state_.loaded[i] = 1;
  holdsChanged_.push_back(i);
}

void ElasticTissue::release(std::int32_t tool) {
  loosen(springs_.drop([&](const TissueSpring& spring) { return spring.tool == tool; }));
}

// Updates cells that have lost a spring; they may have others.
void ElasticTissue::loosen(std::span<const std::int32_t> cells) {
  for (const std::int32_t i : cells) {
    gripper_[i] = -1;
    const bool pulled = std::ranges::binary_search(pulled_, i) ||
                        std::ranges::any_of(springs_.all(), [&](const TissueSpring& spring) {
                          return spring.cell == i;
                        });
    state_.loaded[i] = std::uint8_t(pulled);
    for (int a = 0; a < 3; ++a) state_.load[a][i] = 0;
    holdsChanged_.push_back(i);
  }
}

void ElasticTissue::mayPull(std::int64_t cell) {
  const std::int32_t i = state_.box.fromLattice(cell);
  if (!state_.solid[i]) return;
  const auto at = std::ranges::lower_bound(pulled_, i);
  if (at != pulled_.end() && *at == i) return;
  pulled_.insert(at, i);
  state_.loaded[i] = 1;
  holdsChanged_.push_back(i);
}

void ElasticTissue::pull(std::int64_t cell, const Vec3& force) {
  const std::int32_t i = state_.box.fromLattice(cell);
  if (!state_.solid[i]) return;
  for (int a = 0; a < 3; ++a) state_.load[a][i] += float(force[a]);
}

const TissueMaterial* ElasticTissue::material(std::int64_t cell) const {
  const std::int32_t i = state_.box.fromLattice(cell);
  return state_.solid[i] ? &state_.materials[state_.material[i]] : nullptr;
}

void ElasticTissue::setMaterial(std::int64_t cell, const TissueMaterial& material) {
  const std::int32_t particle = state_.box.fromLattice(cell);
  if (!isParticle(state_, particle)) return;
  checkMaterial(material);
  const std::uint8_t number = materialNumber(state_, material);
  const std::vector<std::int32_t> cells = withBoundary(state_, particle);
  for (const std::int32_t i : cells) state_.material[i] = number;
  chooseSubstep();
  allocateBranches(state_);
  remakeCells(state_, cells);
  for (const std::int32_t i : cells) {
    bondsChanged_.push_back(i);
    for (int d = 0; d < kDirections; ++d)
      if (state_.solid[i + state_.box.step[d]]) bondsChanged_.push_back(i + state_.box.step[d]);
  }
}

std::int32_t ElasticTissue::gripped(std::int32_t tool) const {
  std::int32_t count = 0;
  for (const TissueSpring& spring : springs_.all()) count += spring.tool == tool;
  return count;
}

void ElasticTissue::hold(std::int64_t cell, int axes, const Vec3& velocity) {
  const std::int32_t i = state_.box.fromLattice(cell);
  if (!state_.solid[i]) return;
  if (state_.held[i] != axes) holdsChanged_.push_back(i);
  state_.held[i] = std::uint8_t(axes);
  for (int a = 0; a < 3; ++a)
    if (axes >> a & 1) state_.v[a][i] = float(velocity[a]);
}

// Prescribes the velocities of held cells for a substep from the time `before` to the time `after`,
// as shares of the frame. The holds' own motion, and what a held cell lags behind them: rounding,
// or a frame in which the tissue was stopped. At the end of the frame the cell is where its hold
// is.
void ElasticTissue::carryHeld(double before, double after, double dt) {
  const Vec3 start = holdsMove_->displacement(before);
  const Vec3 speed = (holdsMove_->displacement(after) - start) / dt;
  const double left = holdsMove_->duration * (1 - before);
  for (const TissueChunk& chunk : state_.chunks) {
    if (!chunk.steered) continue;
    for (std::int32_t i = chunk.start; i < chunk.start + kChunk; ++i)
      for (int a = 0; a < 3; ++a)
        if (state_.held[i] >> a & 1)
          state_.v[a][i] = float(speed[a] + (start[a] - double(state_.u[a][i])) / left);
  }
}

void ElasticTissue::setLoad(std::int64_t cell, const Vec3& force) {
  const std::int32_t i = state_.box.fromLattice(cell);
  if (!state_.solid[i]) return;
  const std::uint8_t loaded = force != Vec3::Zero();
  if (state_.loaded[i] != loaded) holdsChanged_.push_back(i);
  state_.loaded[i] = loaded;
  for (int a = 0; a < 3; ++a) state_.load[a][i] = float(force[a]);
}

void ElasticTissue::setDisplacement(std::int64_t cell, const Vec3& u) {
  const std::int32_t i = state_.box.fromLattice(cell);
  for (int a = 0; a < 3; ++a) state_.u[a][i] = state_.ahead[a][i] = float(u[a]);
}

void ElasticTissue::setVelocity(std::int64_t cell, const Vec3& v) {
  const std::int32_t i = state_.box.fromLattice(cell);
  for (int a = 0; a < 3; ++a) state_.v[a][i] = float(v[a]);
}

}  // namespace resect
