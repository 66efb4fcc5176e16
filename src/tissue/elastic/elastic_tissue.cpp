#include "tissue/elastic/elastic_tissue.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/elementary.h"
#include "base/error.h"
#include "base/parallel.h"
#include "tissue/elastic/capsule.h"
#include "tissue/elastic/chunk_bounds.h"
#include "tissue/elastic/elastic_setup.h"
#include "tissue/move_tissues.h"

namespace resect {
namespace {

constexpr int kCalmFrames = 60;     // after which a halved substep is doubled again
constexpr double kMostCells = 20;   // spacings per substep: faster is an explosion
constexpr std::size_t kGrain = 64;  // chunks per block of a pass

// Where more than this share of the cells is beyond the limit of their stiffness, substeps become
// shorter and the limit higher. What single cells need is not worth the time of all.
constexpr double kStiffShare = 1e-3;
constexpr double kFinerBy = 1.26;    // of the substep: 2^(1/3)
constexpr double kHigherBy = 1.414;  // of the limit: the square of kFinerBy would be unstable

double power(double base, int exponent) {
  double product = 1;
  for (int i = 0; i < exponent; ++i) product *= base;
  return product;
}

void check(const TissueCells& cells, const TissueSettings& settings) {
  const auto count = std::size_t(cells.lattice.cellCount());
  require(cells.lattice.sound() && cells.solid.size() == count &&
              (cells.material.empty() || cells.material.size() == count),
          "{} cells of {} m have {} flags and {} materials; give one of each for every cell, or no "
          "material",
          count, cells.lattice.spacing.x(), cells.solid.size(), cells.material.size());
  require((cells.share.empty() || cells.share.size() == count) &&
              (cells.owner.empty() || (cells.owner.size() == count && !cells.share.empty())),
          "{} cells have {} shares and {} owners; give one of each for every cell, or none", count,
          cells.share.size(), cells.owner.size());
  require(std::ranges::all_of(cells.share, [](float share) { return share >= 0 && share <= 1; }),
          "the share of a cell is not from 0 to 1; give such a share");
  for (std::size_t i = 0; i < cells.owner.size(); ++i) {
    if (cells.owner[i] == 0) continue;
    bool owned = cells.owner[i] <= kDirections && !cells.solid[i];
    if (owned) {
      const Vec3i at = cells.lattice.cell(std::int64_t(i)) + offsetOf(cells.owner[i] - 1);
      owned = cells.lattice.contains(at) && cells.solid[std::size_t(cells.lattice.index(at))];
    }
    require(owned, "cell {} belongs to a cell that is not solid; give a solid neighbour", i);
  }
  require(std::ranges::all_of(cells.material,
                              [&](std::uint8_t m) { return m < cells.materials.size(); }),
          "a cell is of a material that there is not among {}; number from 0",
          cells.materials.size());
  require(settings.gravity.allFinite(), "gravity is not a number; give three");
  if (std::find(cells.solid.begin(), cells.solid.end(), 1) == cells.solid.end())
    throw error("the tissue has no solid cell; give an organ with particles");
  if (cells.materials.empty()) throw error("the tissue has no material; give at least one");
  for (const TissueMaterial& m : cells.materials) checkMaterial(m);
  if (!(settings.damping >= 0 && settings.damping <= 0.5))
    throw usageError("tissue damping is {}; give a value from 0 to 0.5", settings.damping);
  if (!(settings.drag >= 0 && std::isfinite(settings.drag)))
    throw usageError("tissue drag is {} 1/s; give 0 or more", settings.drag);
  if (!(settings.penalty > 0 && settings.penalty <= 3))
    throw usageError("tissue penalty is {}; give a value above 0, up to 3", settings.penalty);
  if (!(settings.stepShare > 0 && settings.stepShare <= 1))
    throw usageError("tissue stepShare is {}; give a value above 0, up to 1", settings.stepShare);
}

}  // namespace

ElasticTissue::ElasticTissue(const TissueCells& cells, const TissueSettings& settings)
    : lattice_(cells.lattice), settings_(settings), kernel_(&fastestKernel()) {
  check(cells, settings);
  state_ = makeElasticState(cells, settings.penalty);
  chooseSubstep();
  gripper_.assign(state_.box.size, -1);
  fibres_ = findFibres(state_, {});
  uneven_ = findUnevenBonds(state_);
}

// By the fastest pressure wave among the materials. A capsule makes the cells under it stiffer, by
// less than its stiffness over their size: it acts on the mean strain of a cell and its neighbours.
void ElasticTissue::chooseSubstep() {
  constexpr double kCapsuleShare = 0.2;  // measured: test/tissue/capsule_test.cpp
  double fastest2 = 0;
  for (const TissueMaterial& m : state_.materials) {
    const double capsule = state_.capsule.empty() ? 0 : m.capsule / state_.spacing;
    fastest2 =
        std::max(fastest2, m.waveSpeed() * m.waveSpeed() + kCapsuleShare * capsule / m.density);
  }
  longestSubstep_ = settings_.stepShare * state_.spacing / std::sqrt(fastest2);
  limitCords();
}

SubstepConstants ElasticTissue::constants(double dt) const {
  SubstepConstants c;
  const std::array<double, 4> weights = bondWeights();
  c.faceShare = float(weights[1] / weights[2]);
  c.cornerShare = float(weights[3] / weights[2]);
  c.edgePerLength = float(weights[2] / state_.spacing);
  c.bondStiffness = float(2 * weights[2] / (state_.spacing * state_.spacing));
  c.dt = float(dt);
  c.lookAhead = float(settings_.damping * dt);
  c.keep = float(math::exp(-settings_.drag * dt));
  for (int a = 0; a < 3; ++a) c.gravity[a] = float(settings_.gravity[a]);
  const double most = kMostCells * state_.spacing / dt;
  c.mostSpeedSquared = float(most * most);
  c.cofactorLimit = kCofactorLimit * float(power(kHigherBy, fineness_));
  c.lessCofactorLimit = kCofactorLimit * float(power(kHigherBy, std::max(0, fineness_ - 1)));
  return c;
}

// Runs pass(begin, end) over all chunks, in blocks large enough to limit the number of threads to
// settings_.threads.
void ElasticTissue::forChunks(const RangeBody& pass) const {
  const std::size_t chunks = state_.chunks.size();
  if (settings_.threads == 1) return pass(0, chunks);
  const std::size_t most = std::size_t(std::max(0, settings_.threads));
  parallelFor(chunks, most == 0 ? kGrain : std::max(kGrain, (chunks + most - 1) / most), pass);
}

StiffCells ElasticTissue::stressPass(const SubstepConstants& c) {
  const ElasticView view = viewOf(state_);
  std::atomic<std::int64_t> beyond = 0, beyondLess = 0;
  forChunks([&](std::size_t begin, std::size_t end) {
    const StiffCells stiff = kernel_->stressPass(view, c, begin, end);
    beyond += stiff.beyond;
    beyondLess += stiff.beyondLess;
  });
  pullUnevenBonds(uneven_, state_);
  pullFibres(fibres_, state_);
  pullCords(cords_, state_);
  return {beyond, beyondLess};
}

// By the stiff cells of this frame, for the next one.
void ElasticTissue::chooseFineness() {
  const double most = kStiffShare * double(state_.chunks.size() * kChunk);
  if (double(frame_.stiff.beyond) > most)
    fineness_ = std::min(fineness_ + 1, kMostFineness);
  else if (fineness_ > 0 && double(frame_.stiff.beyondLess) < 0.5 * most)
    --fineness_;
}

bool ElasticTissue::motionPass(const SubstepConstants& c) {
  const ElasticView view = viewOf(state_);
  std::atomic<bool> calm = true;
  forChunks([&](std::size_t begin, std::size_t end) {
    if (!kernel_->motionPass(view, c, begin, end)) calm = false;
  });
  return calm;
}

double ElasticTissue::presentSubstep() const {
  return longestSubstep_ / (power(kFinerBy, fineness_) * double(1 << halvings_));
}

void ElasticTissue::setSurface(std::span<const SurfacePatch> patches) {
  contacts_.setSurface(state_, lattice_, patches);
  setSkin(state_, patches);
  chooseSubstep();
}

int ElasticTissue::substepsWanted() const {
  if (!frame_.calm) return 0;
  return std::max(1, int(std::ceil(frame_.duration / presentSubstep() - 1e-9)));
}

void ElasticTissue::beginFrame(double duration, std::span<const Obstacle> obstacles) {
  settle();
  if (halvings_ > 0 && ++calmFrames_ > kCalmFrames) {
    --halvings_;
    calmFrames_ = 0;
  }
  frame_ = {duration, obstacles, {}, {}, 0, 0, true};
  keepState();
  contacts_.list(state_, *kernel_, lattice_.origin, duration, obstacles, gripper_);
  springs_.forgetImpulses(obstacles.size());
  fronts_.list(rest(), duration, longestSubstep_, obstacles);
}

bool ElasticTissue::substep(int number, int count) {
  if (!frame_.calm) return true;
  const double share = double(number) / count, dt = frame_.duration / count;
  if (number == 1) {
    frame_.constants = constants(dt);
    lookAhead(frame_.constants.lookAhead);
  }
  SubstepConstants& c = frame_.constants;
  c.relaxes = (number - 1) % kSubstepsPerRelaxation == 0;
  c.relaxTime = float(dt * std::min(kSubstepsPerRelaxation, count - number + 1));
  const StiffCells stiff = stressPass(c);
  if (c.relaxes) frame_.stiff = stiff;
  const BreathMotion still;
  springs_.pull(state_, lattice_.origin, frame_.obstacles, holdsMove_.value_or(still), share,
                frame_.duration, dt);
  if (holdsMove_) carryHeld(double(number - 1) / count, share, dt);
  ++frame_.substeps;
  const bool calm = motionPass(frame_.constants);
  clearPulls();
  if (calm && settings_.facesTouch) cutFaces_.push(state_, frame_.constants.lookAhead);
  if (calm) contacts_.push(state_, share, dt, frame_.constants.lookAhead);
  if (calm) fronts_.push(rest(), state_, share, dt, frame_.constants.lookAhead);
  return calm;
}

bool ElasticTissue::startAgain(bool exploded) {
  restoreState();
  clearPulls();
  contacts_.forgetImpulses();
  springs_.forgetImpulses(frame_.obstacles.size());
  fronts_.startAgain(rest());
  if (!exploded) return frame_.calm;
  calmFrames_ = 0;
  if (halvings_ == kMostHalvings) {
    stopMotion();
    frame_.calm = false;
    return false;
  }
  ++halvings_;
  ++frame_.retries;
  return true;
}

void ElasticTissue::endFrame(TissueStep& step) {
  step.substeps = frame_.substeps;
  step.retries = frame_.retries;
  step.calm = frame_.calm;
  step.force.resize(frame_.obstacles.size());
  step.letGo.clear();
  step.cuts.clear();
  fronts_.appendCuts(step.cuts);
  for (std::size_t b = 0; b < frame_.obstacles.size(); ++b) {
    const Obstacle& o = frame_.obstacles[b];
    const Vec3 grip = springs_.impulse()[b] / frame_.duration;
    step.force[b] = (contacts_.impulse()[b] + fronts_.impulse()[b]) / frame_.duration + grip;
    if (o.tool >= 0 && o.slipForce > 0 && grip.norm() > o.slipForce) step.letGo.push_back(o.tool);
  }
  findTears(step.letGo, step.torn);
  if (frame_.calm) chooseFineness();
  if (frame_.calm) tearCapsule(state_, *kernel_);
  frame_.obstacles = {};
  holdsMove_.reset();
}

void ElasticTissue::touchOf(std::int32_t tool, TissueTouch& touch) const {
  touch.clear();
  touch.spacing = state_.spacing;
  contacts_.pressedBy(state_, tool, touch.pressed);
  const Obstacle* obstacle = contacts_.obstacleOf(tool);
  if (!obstacle || !(frame_.duration > 0)) return;
  for (const TissueSpring& spring : springs_.all()) {
    if (spring.tool != tool) continue;
    const std::int32_t i = spring.cell;
    const Vec3 anchor = obstacle->to * spring.anchor;
    const Vec3 speed = (anchor - obstacle->from * spring.anchor) / frame_.duration;
    const std::int64_t cell = state_.box.toLattice(i);
    const Vec3 x = lattice_.centre(lattice_.cell(cell)) + displacement(cell);
    const Vec3 force = spring.stiffness * (x - anchor) + spring.damping * (velocity(cell) - speed);
    touch.held.push_back(
        {anchor, force, spring.stiffness, spring.damping, &state_.materials[state_.material[i]]});
  }
}

ElasticTissue::Advance ElasticTissue::advance(double duration) {
  TissueStep step;
  if (duration > 0) moveTissue(*this, {}, duration, step);
  return {step.substeps, step.retries, step.calm};
}

// Computes the extrapolated positions at which the first substep evaluates forces.
void ElasticTissue::lookAhead(float time) {
  for (const TissueChunk& chunk : state_.chunks)
    for (int a = 0; a < 3; ++a)
      for (std::int32_t i = chunk.start; i < chunk.start + kChunk; ++i)
        state_.ahead[a][i] = state_.u[a][i] + time * state_.v[a][i];
}

// Clears the loads of springs and joints, which are set anew at every substep.
void ElasticTissue::clearPulls() {
  const auto clear = [&](std::int32_t i) {
    for (int a = 0; a < 3; ++a) state_.load[a][i] = 0;
  };
  for (const TissueSpring& spring : springs_.all()) clear(spring.cell);
  for (const std::int32_t i : pulled_) clear(i);
}

// Except for held cells.
void ElasticTissue::stopMotion() {
  for (const TissueChunk& chunk : state_.chunks)
    for (std::int32_t i = chunk.start; i < chunk.start + kChunk; ++i)
      for (int a = 0; a < 3; ++a)
        if (!(state_.held[i] >> a & 1)) state_.v[a][i] = 0;
}

void ElasticTissue::keepState() {
  const int branches = state_.branches();
  kept_.resize(state_.chunks.size() * std::size_t(6 + 6 * branches) * kChunk);
  float* to = kept_.data();
  const auto keep = [&](const auto& field, std::int32_t start) {
    for (const FloatArray& component : field)
      to = std::copy_n(component.data() + start, kChunk, to);
  };
  for (const TissueChunk& chunk : state_.chunks) {
    keep(state_.u, chunk.start), keep(state_.v, chunk.start);
    for (int k = 0; k < branches; ++k) keep(state_.relaxed[std::size_t(k)], chunk.start);
  }
}

void ElasticTissue::restoreState() {
  const float* from = kept_.data();
  const auto restore = [&](auto& field, std::int32_t start) {
    for (FloatArray& component : field) {
      std::copy_n(from, kChunk, component.data() + start);
      from += kChunk;
    }
  };
  for (const TissueChunk& chunk : state_.chunks) {
    restore(state_.u, chunk.start), restore(state_.v, chunk.start);
    for (int k = 0; k < state_.branches(); ++k)
      restore(state_.relaxed[std::size_t(k)], chunk.start);
  }
}

void ElasticTissue::evaluateForces() {
  settle();
  state_.ahead = state_.u;
  SubstepConstants c = constants(longestSubstep_);
  c.relaxes = true;  // by no time: the branches stay as they are
  stressPass(c);
}

Vec3 ElasticTissue::displacement(std::int64_t cell) const {
  const std::int32_t i = state_.box.fromLattice(cell);
  return {state_.u[0][i], state_.u[1][i], state_.u[2][i]};
}

std::vector<std::int64_t> ElasticTissue::cellsIn(const Aabb& box) const {
  std::vector<std::int64_t> cells;
  for (const TissueChunk& chunk : state_.chunks) {
    if (!meets(chunkBounds(state_, chunk, lattice_.origin), box)) continue;
    for (std::int32_t i = chunk.start + chunk.first; i <= chunk.start + chunk.last; ++i) {
      if (!isParticle(state_, i)) continue;
      const std::int64_t cell = state_.box.toLattice(i);
      if (box.contains(lattice_.centre(lattice_.cell(cell)) + displacement(cell)))
        cells.push_back(cell);
    }
  }
  return cells;
}

Vec3 ElasticTissue::velocity(std::int64_t cell) const {
  const std::int32_t i = state_.box.fromLattice(cell);
  return {state_.v[0][i], state_.v[1][i], state_.v[2][i]};
}

double ElasticTissue::mass(std::int64_t cell) const {
  const float inverse = state_.inverseMass[state_.box.fromLattice(cell)];
  return inverse > 0 ? 1 / double(inverse) : 0;
}

}  // namespace resect
