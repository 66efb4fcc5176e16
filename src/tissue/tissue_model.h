// Interface of tissue models. Resect has two models, still tissue and elastic tissue; users can add
// others.
//
// Cells are given by their index in the organ's lattice. Tissue "explodes" when its time
// integration becomes unstable.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/state/state_visitor.h"
#include "geometry/aabb.h"
#include "geometry/pose.h"
#include "tissue/breathing.h"
#include "tissue/cord.h"
#include "tissue/material.h"
#include "tissue/obstacle.h"
#include "tissue/touch.h"

namespace resect {

// A bond: the connection between two neighbouring cells. It is given by one of the cells, and the
// direction from this cell to the other.
struct TissueBond {
  std::int64_t cell = -1;
  std::int32_t direction = -1;  // numbered as in tissue/stencil.h
};

// Result of a frame for one tissue, and the edits that follow from it.
struct TissueStep {
  std::int32_t substeps = 0;
  std::int32_t retries = 0;  // number of repetitions of the frame with shorter substeps
  bool calm = true;  // false: the tissue still exploded with the shortest substep, and was stopped
  std::vector<Vec3> force;          // per obstacle: mean force on it over the frame, N
  std::vector<TissueBond> torn;     // bonds that have torn; the caller severs them
  std::vector<std::int32_t> letGo;  // tools whose grip slipped; the caller releases them
  std::vector<TissueCut> cuts;      // cuts that edges made, in the order of the obstacles

  void forget() {  // resets to a frame without motion; keeps the memory
    substeps = retries = 0;
    calm = true;
    force.clear(), torn.clear(), letGo.clear(), cuts.clear();
  }
};

// Present placement of a cell with rest position X. A point of the tissue near the cell, with rest
// position X', is now at X' + displacement + gradient (X' - X).
struct CellPlacement {
  Vec3f displacement;        // m
  Eigen::Matrix3f gradient;  // F - I
};

// A small patch of the surface of tissue at rest.
struct SurfacePatch {
  std::int64_t cell = -1;  // solid cell that the patch belongs to
  // place: middle of the patch in rest space. area: the patch's area times its outward normal.
  Vec3f place = Vec3f::Zero();  // m
  Vec3f area = Vec3f::Zero();   // m^2
};

class TissueModel {
 public:
  virtual ~TissueModel() = default;

  // False for tissue that never leaves its rest positions.
  virtual bool moves() const = 0;

  // Tells the model where the surface of the tissue at rest is. Obstacles then touch the tissue at
  // this surface. Call before the first frame. A model may ignore the call. patches: ascending by
  // cell.
  virtual void setSurface(std::span<const SurfacePatch>) {}

  // Replaces all cords, the springs that stand for the walls of vessels. The model may make some
  // cords less stiff, so that they are stable. Cords whose cells hold no tissue are ignored. Cords
  // are not part of the state: after a state was restored, they must be set again. A model may
  // ignore all cords.
  virtual void setCords(std::span<const TissueCord>) {}

  // Gives the motion of the tissue's attachments, such as its ligaments, in the next frame.
  // `BreathMotion` gives displacements from the attachments' positions at rest. Call before
  // beginFrame(), in every frame in which the attachments move or are displaced. A model may ignore
  // the call.
  virtual void moveHolds(const BreathMotion&) {}

  // A frame lasts `duration` s, > 0. It consists of one call of beginFrame(), one call of substep()
  // for each of several equal substeps, and one call of endFrame(). moveTissues()
  // (tissue/move_tissues.h) chooses the number of substeps and makes these calls. If organs are
  // connected by joints, all tissues take the same number of substeps. `obstacles` must stay valid
  // until endFrame().
  virtual void beginFrame(double duration, std::span<const Obstacle> obstacles) = 0;
  // Least number of substeps that the tissue needs in this frame; may be 0.
  virtual int substepsWanted() const = 0;
  // Computes substep `number`, from 1 to `count`. Returns false if the tissue has exploded.
  virtual bool substep(int number, int count) = 0;
  // Restores the tissue to the frame's beginning. exploded: whether this tissue has exploded; if
  // so, this tissue takes shorter substeps from now on. Returns false if shorter substeps are not
  // allowed. In that case the tissue is stopped and takes no further part in the frame.
  virtual bool startAgain(bool exploded) = 0;
  // Writes the frame's result to `step`, whose memory is reused.
  virtual void endFrame(TissueStep& step) = 0;
  // Writes to `touch` how the tool presses and holds the tissue at the end of the last frame, in
  // the order of the cells. Call after endFrame(). Between endFrame() and touchOf(), the tissue may
  // be changed by tears, but not in any other way. `touch` is overwritten; its memory is reused.
  // Tissue that does not move leaves `touch` empty.
  virtual void touchOf(std::int32_t, TissueTouch& touch) const { touch.clear(); }
  // Applies an additional external force, N, to a cell, for the next substep only. mayPull() must
  // have been called for this cell before.
  virtual void pull(std::int64_t cell, const Vec3& force) = 0;
  virtual void mayPull(std::int64_t cell) = 0;

  // The functions from here down to settle() are edits. They take effect immediately. Call settle()
  // afterwards: it updates the derived data.
  virtual void remove(std::int64_t cell) = 0;
  virtual void sever(std::int64_t cell, int direction) = 0;  // direction: tissue/stencil.h
  // The tool grips the cell: from now on, the tool holds the cell at the cell's present position
  // relative to the tool. pose: the tool's pose at the start of this frame.
  virtual void grip(std::int64_t cell, std::int32_t tool, const Pose& pose) = 0;
  virtual void release(std::int32_t tool) = 0;
  virtual void settle() = 0;
  // If the model has no materials, or if the cell is gone, material() returns null and
  // setMaterial() does nothing.
  virtual const TissueMaterial* material(std::int64_t cell) const = 0;
  virtual void setMaterial(std::int64_t cell, const TissueMaterial& material) = 0;
  virtual std::int32_t gripped(std::int32_t tool) const = 0;  // number of cells that the tool grips

  virtual bool solid(std::int64_t cell) const = 0;           // whether the cell holds tissue now
  virtual std::uint32_t bonds(std::int64_t cell) const = 0;  // bit d: bonded in direction d
  virtual Vec3 displacement(std::int64_t cell) const = 0;    // m
  virtual Vec3 velocity(std::int64_t cell) const = 0;        // m/s
  virtual double mass(std::int64_t cell) const = 0;          // kg; 0: immovable
  // The cells whose present centres lie in a box (world, m) or on its sides, ascending.
  virtual std::vector<std::int64_t> cellsIn(const Aabb& box) const = 0;
  virtual Mat3 deformation(std::int64_t cell) const = 0;  // F
  // Writes the placements of many cells at once. places.size() must be cells.size().
  virtual void place(std::span<const std::int64_t> cells,
                     std::span<CellPlacement> places) const = 0;

  // Visits the state, field by field (base/state/state_visitor.h). To load a state, call
  // beginRestore(), then visit() with a visitor that loads, then endRestore(). endRestore()
  // computes the derived data. It throws Error if the loaded fields do not fit this tissue. After
  // this error the tissue is unusable until another state is loaded.
  virtual void visit(StateVisitor& visitor) = 0;
  virtual void visitMade(StateVisitor& visitor) = 0;
  virtual void beginRestore() = 0;
  // alive: one flag per cell of the lattice, 1 for each cell that holds tissue of the organ now.
  virtual void endRestore(std::span<const std::uint8_t> alive) = 0;
};

}  // namespace resect
