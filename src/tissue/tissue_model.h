// Interface of tissue models: still tissue as in the original system, elastic tissue, or a model
// that a user adds.
//
// Functions take a cell's index in the organ's lattice.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/state/state_visitor.h"
#include "geometry/aabb.h"
#include "geometry/pose.h"
#include "tissue/material.h"
#include "tissue/obstacle.h"

namespace resect {

// A bond, given by one of its ends and the direction from there.
struct TissueBond {
  std::int64_t cell = -1;
  std::int32_t direction = -1;  // numbered as in tissue/stencil.h
};

// Result of a frame for one tissue, and the edits that follow from it.
struct TissueStep {
  std::int32_t substeps = 0;
  std::int32_t retries = 0;  // how often the frame was repeated with shorter substeps
  bool calm = true;          // false: even the shortest substep exploded; the tissue was stopped
  std::vector<Vec3> force;   // on each obstacle, N; mean over the frame
  std::vector<TissueBond> torn;     // bonds stretched beyond their limit: to be severed
  std::vector<std::int32_t> letGo;  // tools whose grip slipped: to be released

  void forget() {  // resets to a frame without motion; keeps the memory
    substeps = retries = 0;
    calm = true;
    force.clear(), torn.clear(), letGo.clear();
  }
};

// Present placement of a cell with rest position X: a point of the tissue near the cell, with rest
// position X', is now at X' + displacement + gradient (X' - X).
struct CellPlacement {
  Vec3f displacement;        // m
  Eigen::Matrix3f gradient;  // F - I
};

class TissueModel {
 public:
  virtual ~TissueModel() = default;

  // False for tissue that never leaves its rest positions.
  virtual bool moves() const = 0;

  // A frame of `duration` > 0, s, consists of beginFrame(), a number of equal substeps with one
  // call of substep() each, and endFrame(). tissue/move_tissues.h chooses the number and calls
  // these functions; with joints, all tissues take the same number. `obstacles` stay valid until
  // endFrame().
  virtual void beginFrame(double duration, std::span<const Obstacle> obstacles) = 0;
  // Least number of substeps that the tissue needs in this frame; 0: it needs none.
  virtual int substepsWanted() const = 0;
  // Computes one substep. number: from 1 to count. False when the tissue has exploded.
  virtual bool substep(int number, int count) = 0;
  // Restores the tissue to the frame's beginning. exploded: the tissue has exploded, and needs
  // shorter substeps from now on. False if shorter ones are not allowed: the tissue is then stopped
  // and takes no further part in the frame.
  virtual bool startAgain(bool exploded) = 0;
  // Writes the frame's result to `step`, whose memory is reused.
  virtual void endFrame(TissueStep& step) = 0;
  // Additional outside force on a cell, N, for the next substep only. mayPull() must have been
  // called for the cell before.
  virtual void pull(std::int64_t cell, const Vec3& force) = 0;
  virtual void mayPull(std::int64_t cell) = 0;

  // The functions down to settle() are edits. They take effect at once; settle() then updates
  // derived data.
  virtual void remove(std::int64_t cell) = 0;
  virtual void sever(std::int64_t cell, int direction) = 0;  // direction: tissue/stencil.h
  // The tool grips the cell: the cell's present position relative to the tool is held from now on.
  // pose: the tool's pose at the start of this frame.
  virtual void grip(std::int64_t cell, std::int32_t tool, const Pose& pose) = 0;
  virtual void release(std::int32_t tool) = 0;
  virtual void settle() = 0;
  // Null if the model has no materials or the cell is gone; setMaterial() then does nothing.
  virtual const TissueMaterial* material(std::int64_t cell) const = 0;
  virtual void setMaterial(std::int64_t cell, const TissueMaterial& material) = 0;
  virtual std::int32_t gripped(std::int32_t tool) const = 0;  // cells that the tool holds

  virtual bool solid(std::int64_t cell) const = 0;
  virtual std::uint32_t bonds(std::int64_t cell) const = 0;  // bit d: bonded in direction d
  virtual Vec3 displacement(std::int64_t cell) const = 0;    // m
  virtual Vec3 velocity(std::int64_t cell) const = 0;        // m/s
  virtual double mass(std::int64_t cell) const = 0;          // kg; 0: immovable
  // The cells whose centres are now inside a box of the world or on its sides, ascending.
  virtual std::vector<std::int64_t> cellsIn(const Aabb& box) const = 0;
  virtual Mat3 deformation(std::int64_t cell) const = 0;  // F
  // The placements of many cells at once; places.size() = cells.size().
  virtual void place(std::span<const std::int64_t> cells,
                     std::span<CellPlacement> places) const = 0;

  // Visits the state, field by field (base/state/state_visitor.h). To load a state, call
  // beginRestore(), visit() with a reader, then endRestore(), which derives the rest. endRestore()
  // throws Error when the fields do not fit this tissue; the tissue is then unusable until another
  // state is loaded.
  virtual void visit(StateVisitor& visitor) = 0;
  virtual void visitMade(StateVisitor& visitor) = 0;
  virtual void beginRestore() = 0;
  // alive: one flag per cell of the lattice, 1 where the organ has a particle now.
  virtual void endRestore(std::span<const std::uint8_t> alive) = 0;
};

}  // namespace resect
