#include "tissue/elastic_tissue.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "base/state_hash.h"
#include "tissue/chunk_bounds.h"
#include "tissue/elastic_setup.h"

namespace resect {
namespace {

constexpr int kMostHalvings = 6;
constexpr int kCalmFrames = 60;     // after which a halved substep is doubled again
constexpr double kMostCells = 20;   // spacings per substep: faster is an explosion
constexpr std::size_t kGrain = 64;  // chunks per block of a pass

void check(const TissueCells& cells, const TissueSettings& settings) {
  if (std::find(cells.solid.begin(), cells.solid.end(), 1) == cells.solid.end())
    throw error("the tissue has no solid cell; give an organ with particles");
  if (cells.materials.empty()) throw error("the tissue has no material; give at least one");
  for (const TissueMaterial& m : cells.materials)
    if (!(m.young > 0 && m.poisson >= 0 && m.poisson <= 0.4999 && m.density > 0))
      throw usageError(
          "material \"{}\" has young = {} Pa, poisson = {}, density = {} kg/m^3; young and density "
          "are positive, poisson is from 0 to 0.4999",
          m.name, m.young, m.poisson, m.density);
  if (!(settings.damping >= 0 && settings.damping <= 0.5))
    throw usageError("tissue damping is {}; give a value from 0 to 0.5", settings.damping);
  if (!(settings.drag >= 0))
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
  double fastest = 0;
  for (const TissueMaterial& m : cells.materials) fastest = std::max(fastest, m.waveSpeed());
  longestSubstep_ = settings.stepShare * state_.spacing / fastest;
  gripper_.assign(state_.box.size, -1);
  threads_ = findThreads(state_, {});
  uneven_ = findUnevenBonds(state_);
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
  c.keep = float(std::exp(-settings_.drag * dt));
  for (int a = 0; a < 3; ++a) c.gravity[a] = float(settings_.gravity[a]);
  const double most = kMostCells * state_.spacing / dt;
  c.mostSpeedSquared = float(most * most);
  return c;
}

// pass(begin, end) over all chunks. Blocks are as large as keeps it to the threads wished for.
void ElasticTissue::forChunks(const RangeBody& pass) const {
  const std::size_t chunks = state_.chunks.size();
  if (settings_.threads == 1) return pass(0, chunks);
  const std::size_t most = std::size_t(std::max(0, settings_.threads));
  parallelFor(chunks, most == 0 ? kGrain : std::max(kGrain, (chunks + most - 1) / most), pass);
}

void ElasticTissue::stressPass(const SubstepConstants& c) {
  const ElasticView view = viewOf(state_);
  forChunks([&](std::size_t begin, std::size_t end) { kernel_->stressPass(view, c, begin, end); });
  pullUnevenBonds(uneven_, state_);
  pullThreads(threads_, state_);
}

bool ElasticTissue::motionPass(const SubstepConstants& c) {
  const ElasticView view = viewOf(state_);
  std::atomic<bool> calm = true;
  forChunks([&](std::size_t begin, std::size_t end) {
    if (!kernel_->motionPass(view, c, begin, end)) calm = false;
  });
  return calm;
}

// False when the state explodes.
bool ElasticTissue::substeps(double duration, const TissueSurroundings& around,
                             std::int32_t& count) {
  const double longest = longestSubstep_ / double(1 << halvings_);
  const int steps = std::max(1, int(std::ceil(duration / longest - 1e-9)));
  const double dt = duration / steps;
  const SubstepConstants c = constants(dt);
  for (int k = 1; k <= steps; ++k) {
    const double share = double(k) / steps;
    stressPass(c);
    springs_.pull(state_, lattice_.origin, around.tools, share, duration, dt);
    ++count;
    if (!motionPass(c)) return false;
    contacts_.push(state_, share, c.lookAhead);
  }
  return true;
}

ElasticTissue::Advance ElasticTissue::advance(double duration) {
  TissueStep step;
  if (duration > 0) run(duration, {}, step);
  return {step.substeps, step.retries, step.calm};
}

void ElasticTissue::run(double duration, const TissueSurroundings& around, TissueStep& step) {
  settleEdits();
  if (halvings_ > 0 && ++calmFrames_ > kCalmFrames) {
    --halvings_;
    calmFrames_ = 0;
  }
  step.substeps = step.retries = step.torn = 0;
  step.calm = true;
  keepState();
  contacts_.list(state_, lattice_.origin, duration, around, gripper_);
  springs_.forgetImpulses(around.tools.size());
  while (!substeps(duration, around, step.substeps)) {
    restoreState();
    contacts_.forgetImpulses();
    springs_.forgetImpulses(around.tools.size());
    calmFrames_ = 0;
    if (halvings_ == kMostHalvings) {
      stopMotion();
      step.calm = false;
      break;
    }
    ++halvings_;
    ++step.retries;
  }
}

void ElasticTissue::move(double duration, const TissueSurroundings& around, TissueStep& step) {
  run(duration, around, step);
  step.toolForce.resize(around.tools.size());
  step.letGo.clear();
  for (std::size_t b = 0; b < around.tools.size(); ++b) {
    const TissueTool& tool = around.tools[b];
    const Vec3 grip = springs_.toolImpulse()[b] / duration;
    step.toolForce[b] = contacts_.toolImpulse()[b] / duration + grip;
    if (tool.slipForce > 0 && grip.norm() > tool.slipForce) {
      release(tool.tool);
      step.letGo.push_back(tool.tool);
    }
  }
  step.tableForce = contacts_.tableImpulse() / duration;
  tear(step.tornBonds);
  step.torn = std::int32_t(step.tornBonds.size());
}

// Held cells excepted.
void ElasticTissue::stopMotion() {
  for (const TissueChunk& chunk : state_.chunks)
    for (std::int32_t i = chunk.start; i < chunk.start + kChunk; ++i)
      for (int a = 0; a < 3; ++a)
        if (!(state_.held[i] >> a & 1)) state_.v[a][i] = 0;
}

void ElasticTissue::keepState() {
  kept_.resize(state_.chunks.size() * 6 * kChunk);
  float* to = kept_.data();
  for (const TissueChunk& chunk : state_.chunks)
    for (const auto* field : {&state_.u, &state_.v})
      for (const FloatArray& component : *field)
        to = std::copy_n(component.data() + chunk.start, kChunk, to);
}

// `ahead` of the next substep is that of the kept velocity at the coming substep's length; that of
// a length twice as long does no harm.
void ElasticTissue::restoreState() {
  const float* from = kept_.data();
  for (const TissueChunk& chunk : state_.chunks)
    for (auto* field : {&state_.u, &state_.v})
      for (FloatArray& component : *field) {
        std::copy_n(from, kChunk, component.data() + chunk.start);
        from += kChunk;
      }
  state_.ahead = state_.u;
}

void ElasticTissue::settleEdits() {
  for (auto* list : {&bondsChanged_, &holdsChanged_}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  if (!bondsChanged_.empty()) {
    refreshCells(state_, bondsChanged_);
    threads_ = findThreads(state_, threads_);
    uneven_ = findUnevenBonds(state_);
  }
  if (!holdsChanged_.empty()) refreshChunks(state_, holdsChanged_);
  bondsChanged_.clear();
  holdsChanged_.clear();
}

void ElasticTissue::evaluateForces() {
  settleEdits();
  state_.ahead = state_.u;
  stressPass(constants(longestSubstep_));
}

void ElasticTissue::sever(std::int64_t cell, int direction) {
  const std::int32_t i = state_.box.fromLattice(cell);
  if (!(state_.bonds[i] >> direction & 1)) return;
  severBond(state_, i, direction);
  contacts_.keepApart(state_, i, direction);
  bondsChanged_.push_back(i);
  bondsChanged_.push_back(i + state_.box.step[direction]);
  cut_.push_back(i);
  cut_.push_back(i + state_.box.step[direction]);
}

void ElasticTissue::remove(std::int64_t cell) {
  const std::int32_t i = state_.box.fromLattice(cell);
  if (!state_.solid[i]) return;
  bondsChanged_.push_back(i);
  for (int d = 0; d < kDirections; ++d)
    if (state_.bonds[i] >> d & 1) bondsChanged_.push_back(i + state_.box.step[d]);
  removeCell(state_, i);
  contacts_.forgetCell(i);
  loosen(springs_.drop([&](const TissueSpring& spring) { return spring.cell == i; }));
}

std::int64_t ElasticTissue::attach(const TissueAttachment& attachment) {
  std::vector<std::int64_t> cells;
  for (std::int64_t c = 0; c < lattice_.cellCount(); ++c)
    if (solid(c) && attachment.holds(lattice_.centre(lattice_.cell(c)))) cells.push_back(c);
  for (const std::int64_t c : cells) {
    if (attachment.kind == TissueAttachment::Kind::Pin) {
      hold(c, kHeldAll);
      continue;
    }
    const std::int32_t i = state_.box.fromLattice(c);
    // A spring stiffer than the substep can follow would explode.
    const double most = 0.2 * mass(c) / (longestSubstep_ * longestSubstep_);
    const double stiffness = std::min(attachment.stiffness / double(cells.size()), most);
    springs_.add({i, -1, lattice_.centre(lattice_.cell(c)), stiffness,
                  0.5 * std::sqrt(stiffness * mass(c))});
    state_.loaded[i] = 1;
    holdsChanged_.push_back(i);
  }
  return std::int64_t(cells.size());
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

void ElasticTissue::loosen(std::span<const std::int32_t> cells) {
  for (const std::int32_t i : cells) {
    gripper_[i] = -1;
    state_.loaded[i] = 0;
    for (int a = 0; a < 3; ++a) state_.load[a][i] = 0;
    holdsChanged_.push_back(i);
  }
}

std::int32_t ElasticTissue::gripped(std::int32_t tool) const {
  std::int32_t count = 0;
  for (const TissueSpring& spring : springs_.all()) count += spring.tool == tool;
  return count;
}

std::uint64_t ElasticTissue::stateHash() const {
  StateHash hash;
  for (int a = 0; a < 3; ++a) {
    hash.addSpan(std::span<const float>(state_.u[a]));
    hash.addSpan(std::span<const float>(state_.v[a]));
  }
  hash.addSpan(std::span<const std::uint32_t>(state_.bonds));
  hash.addSpan(std::span<const std::int32_t>(gripper_));
  return hash.value();
}

std::size_t ElasticTissue::bytes() const {
  const ElasticState& s = state_;
  std::size_t bytes = 0;
  const auto add = [&](const auto& array) {
    bytes += array.capacity() * sizeof(typename std::decay_t<decltype(array)>::value_type);
  };
  const auto addEach = [&](const auto& arrays) {
    for (const auto& array : arrays) add(array);
  };
  for (const auto* three : {&s.u, &s.ahead, &s.v, &s.bondForce, &s.skew, &s.planeWeight, &s.load})
    addEach(*three);
  addEach(s.stress);
  addEach(s.inverseMoment);
  for (const FloatArray* one : {&s.inverseMass, &s.shearVolume, &s.lameVolume, &s.kappa}) add(*one);
  for (const auto* one : {&s.solid, &s.material, &s.held, &s.loaded}) add(*one);
  add(s.bonds);
  add(kept_);
  add(s.chunks);
  add(gripper_);
  add(threads_);
  add(uneven_);
  return bytes;
}

void ElasticTissue::hold(std::int64_t cell, int axes, const Vec3& velocity) {
  const std::int32_t i = state_.box.fromLattice(cell);
  if (!state_.solid[i]) return;
  if (state_.held[i] != axes) holdsChanged_.push_back(i);
  state_.held[i] = std::uint8_t(axes);
  for (int a = 0; a < 3; ++a)
    if (axes >> a & 1) state_.v[a][i] = float(velocity[a]);
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

Vec3 ElasticTissue::displacement(std::int64_t cell) const {
  const std::int32_t i = state_.box.fromLattice(cell);
  return {state_.u[0][i], state_.u[1][i], state_.u[2][i]};
}

std::vector<std::int64_t> ElasticTissue::cellsIn(const Aabb& box) const {
  std::vector<std::int64_t> cells;
  for (const TissueChunk& chunk : state_.chunks) {
    if (!meets(chunkBounds(state_, chunk, lattice_.origin), box)) continue;
    for (std::int32_t i = chunk.start + chunk.first; i <= chunk.start + chunk.last; ++i) {
      if (!state_.solid[i]) continue;
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
