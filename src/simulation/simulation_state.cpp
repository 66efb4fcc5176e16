// Saving, restoring and comparing the state of a simulation.
#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/state/state_hash.h"
#include "simulation/simulation.h"

namespace resect {

std::uint64_t Simulation::fingerprint() const {
  StateHash hash;
  for (const OperatedOrgan& o : organs_) {
    hash.add(resect::fingerprint(o.organ));
    hash.add(o.tissue->moves());
  }
  return hash.value();
}

Bytes Simulation::save() const { return toBytes(fields()); }

void Simulation::restore(std::span<const std::byte> bytes) {
  const SavedState wanted = stateFromBytes(bytes);
  if (wanted.version > kStateVersion)
    throw error(
        "the state was saved by a newer version of Resect ({}, here {}); restore it with that one",
        wanted.version, kStateVersion);
  if (wanted.fingerprint != fingerprint())
    throw error(
        "the state is that of another organ, or of one in cells of another size; restore it into "
        "the operation that it was saved from");
  const SavedState now = fields();
  try {
    load(wanted);
  } catch (...) {
    load(now);
    throw;
  }
}

void Simulation::load(const SavedState& state) {
  // What was left half done, a step or a restore, is made anew; else only what differs.
  const bool anew = std::exchange(halfDone_, true);
  for (OperatedOrgan& o : organs_) beginRestore(o);
  loadState(*this, state);
  for (const TissueJoint& joint : joints_) requireSound(joint);
  for (const ToolState& tool : tools_)
    for (const ToolStance* at : {&tool.way.from, &tool.way.to})
      if (!isFinite(at->pose))
        throw error("the pose of tool \"{}\" in the state is not a number; give it as it was saved",
                    tool.tool->model.name);
  if (!(breath_.phase >= 0 && breath_.phase < 1))
    throw error("the state is at {} of a breath; give a share from 0 to below 1", breath_.phase);
  for (OperatedOrgan& o : organs_) remake(o, keepsLook_, anew);
  blood_.remake(organs_);
  halfDone_ = false;
}

std::uint64_t Simulation::stateHash() const {
  HashVisitor state;
  visitState(*this, state);
  StateHash hash;
  hash.add(state.value());
  const TriangleMesh surface = surfaceMesh();
  hash.addSpan(std::span<const Vec3>(surface.points));
  hash.addSpan(std::span<const Triangle>(surface.triangles));
  return hash.value();
}

}  // namespace resect
