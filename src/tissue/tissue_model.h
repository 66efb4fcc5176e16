// How does an organ's tissue move, and what does it feel? What a simulation asks of any kind of
// tissue: still as in the original system, elastic, or one's own.
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

// A bond by one of its ends.
struct TissueBond {
  std::int64_t cell = -1;
  std::int32_t direction = -1;  // tissue/stencil.h
};

// What happened to tissue in a frame, and what ought to be done to it because of that.
struct TissueStep {
  std::int32_t substeps = 0;
  std::int32_t retries = 0;         // how often the frame was started again with shorter substeps
  bool calm = true;                 // false: even the shortest exploded; the tissue was stopped
  std::vector<Vec3> force;          // on each of the obstacles, mean over the frame, N
  std::vector<TissueBond> torn;     // bonds stretched beyond their limit: to be severed
  std::vector<std::int32_t> letGo;  // tools whose grip slipped: to be released

  void forget() {  // as of a frame in which nothing moved; keeps the memory
    substeps = retries = 0;
    calm = true;
    force.clear(), torn.clear(), letGo.clear();
  }
};

// Where a cell is, for whatever hangs on it: a point X' near its rest position X
// is at X' + displacement + gradient (X' - X).
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
  virtual int substepsWanted() const = 0;  // at least so many in this frame; 0: it does not care
  // False when the tissue has exploded.
  virtual bool substep(int number, int count) = 0;  // number: from 1 to count
  // Puts the tissue back to the frame's beginning; exploded: shorter substeps from now on. False
  // when there are none shorter: then it is stopped and takes no part in the frame any more.
  virtual bool startAgain(bool exploded) = 0;
  // `step` is overwritten; its memory is used again.
  virtual void endFrame(TissueStep& step) = 0;
  // From outside, on top of what else acts on a cell, N; for the coming substep alone. The cell has
  // been named by mayPull() before.
  virtual void pull(std::int64_t cell, const Vec3& force) = 0;
  virtual void mayPull(std::int64_t cell) = 0;

  // Edits. They take effect at once; settle() brings what depends on them up to date.
  virtual void remove(std::int64_t cell) = 0;
  virtual void sever(std::int64_t cell, int direction) = 0;  // direction: tissue/stencil.h
  // The tool holds on to the cell at the place where both are: its pose in this frame's start.
  virtual void grip(std::int64_t cell, std::int32_t tool, const Pose& pose) = 0;
  virtual void release(std::int32_t tool) = 0;
  virtual void settle() = 0;
  // Null: none is known. Another one may be given where one is known.
  virtual const TissueMaterial* material(std::int64_t cell) const = 0;
  virtual void setMaterial(std::int64_t cell, const TissueMaterial& material) = 0;
  virtual std::int32_t gripped(std::int32_t tool) const = 0;  // cells that the tool holds

  virtual bool solid(std::int64_t cell) const = 0;
  virtual std::uint32_t bonds(std::int64_t cell) const = 0;  // bit d: bonded in direction d
  virtual Vec3 displacement(std::int64_t cell) const = 0;    // m
  virtual Vec3 velocity(std::int64_t cell) const = 0;        // m/s
  virtual double mass(std::int64_t cell) const = 0;          // kg; 0: nothing moves it
  // The cells whose centres are now in a closed box of the world, ascending.
  virtual std::vector<std::int64_t> cellsIn(const Aabb& box) const = 0;
  virtual Mat3 deformation(std::int64_t cell) const = 0;  // F
  // The same for many cells at once; places.size() = cells.size().
  virtual void place(std::span<const std::int64_t> cells,
                     std::span<CellPlacement> places) const = 0;

  // The state, field by field (base/state/state_visitor.h). Before fields are loaded comes
  // beginRestore(), then endRestore(), which makes all that depends on them; it throws Error when
  // they do not fit this tissue, which is then of no use until another state is loaded.
  virtual void visit(StateVisitor& visitor) = 0;
  virtual void visitMade(StateVisitor& visitor) = 0;
  virtual void beginRestore() = 0;
  // alive: per cell of the lattice, where the organ has its particles now.
  virtual void endRestore(std::span<const std::uint8_t> alive) = 0;
};

}  // namespace resect
