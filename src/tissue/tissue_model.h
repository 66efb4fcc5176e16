// Interface of tissue models: still tissue as in the original system, elastic tissue, or one's own.
//
// Cells are named by their index in the organ's lattice.
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

// A bond, given by one of its ends.
struct TissueBond {
  std::int64_t cell = -1;
  std::int32_t direction = -1;  // tissue/stencil.h
};

// Result of a frame for one tissue, and the edits that follow from it.
struct TissueStep {
  std::int32_t substeps = 0;
  std::int32_t retries = 0;  // how often the frame was repeated with shorter substeps
  bool calm = true;          // false: even the shortest substep exploded; the tissue was stopped
  std::vector<Vec3> force;   // on each obstacle, mean over the frame, N
  std::vector<TissueBond> torn;     // bonds stretched beyond their limit: to be severed
  std::vector<std::int32_t> letGo;  // tools whose grip slipped: to be released

  void forget() {  // resets to a frame without motion; keeps the memory
    substeps = retries = 0;
    calm = true;
    force.clear(), torn.clear(), letGo.clear();
  }
};

// Present placement of a cell: a point X' near its rest position X is now at X' + displacement +
// gradient (X' - X).
struct CellPlacement {
  Vec3f displacement;        // m
  Eigen::Matrix3f gradient;  // F - I
};

class TissueModel {
 public:
  virtual ~TissueModel() = default;

  // False for tissue that never leaves its rest positions.
  virtual bool moves() const = 0;

  // A frame of `duration` > 0, s, is beginFrame(), substep() for each of as many equal substeps as
  // are agreed on, endFrame(); tissue/move_tissues.h calls them, for several tissues together where
  // these are joined. `obstacles` stay valid until endFrame().
  virtual void beginFrame(double duration, std::span<const Obstacle> obstacles) = 0;
  virtual int substepsWanted() const = 0;  // least number of substeps in this frame; 0: any
  // False when the tissue has exploded.
  virtual bool substep(int number, int count) = 0;  // number: from 1 to count
  // Restores the tissue to the frame's beginning; exploded: with shorter substeps from now on.
  // False if there are no shorter ones: then it is stopped and takes no further part in the frame.
  virtual bool startAgain(bool exploded) = 0;
  // `step` is overwritten; its memory is used again.
  virtual void endFrame(TissueStep& step) = 0;
  // Additional outside force on a cell for the next substep only, N. The cell must have been named
  // by mayPull().
  virtual void pull(std::int64_t cell, const Vec3& force) = 0;
  virtual void mayPull(std::int64_t cell) = 0;

  // Edits. They take effect at once; settle() updates derived data.
  virtual void remove(std::int64_t cell) = 0;
  virtual void sever(std::int64_t cell, int direction) = 0;  // direction: tissue/stencil.h
  // The tool grips the cell at their present relative position; pose: the tool's at the start of
  // this frame.
  virtual void grip(std::int64_t cell, std::int32_t tool, const Pose& pose) = 0;
  virtual void release(std::int32_t tool) = 0;
  virtual void settle() = 0;
  // Null: the model has no materials, or the cell is gone. setMaterial() requires one.
  virtual const TissueMaterial* material(std::int64_t cell) const = 0;
  virtual void setMaterial(std::int64_t cell, const TissueMaterial& material) = 0;
  virtual std::int32_t gripped(std::int32_t tool) const = 0;  // cells that the tool holds

  virtual bool solid(std::int64_t cell) const = 0;
  virtual std::uint32_t bonds(std::int64_t cell) const = 0;  // bit d: bonded in direction d
  virtual Vec3 displacement(std::int64_t cell) const = 0;    // m
  virtual Vec3 velocity(std::int64_t cell) const = 0;        // m/s
  virtual double mass(std::int64_t cell) const = 0;          // kg; 0: immovable
  // The cells whose centres are now in a closed box of the world, ascending.
  virtual std::vector<std::int64_t> cellsIn(const Aabb& box) const = 0;
  virtual Mat3 deformation(std::int64_t cell) const = 0;  // F
  // The same for many cells at once; places.size() = cells.size().
  virtual void place(std::span<const std::int64_t> cells,
                     std::span<CellPlacement> places) const = 0;

  // The state, field by field (base/state/state_visitor.h). To load: beginRestore(), visit(), then
  // endRestore(), which derives the rest; it throws Error when the fields do not fit this tissue,
  // which is then unusable until another state is loaded.
  virtual void visit(StateVisitor& visitor) = 0;
  virtual void visitMade(StateVisitor& visitor) = 0;
  virtual void beginRestore() = 0;
  // alive: per cell of the lattice: 1 where the organ has a particle now.
  virtual void endRestore(std::span<const std::uint8_t> alive) = 0;
};

}  // namespace resect
