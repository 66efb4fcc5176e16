// How does an organ's tissue move, and what does it feel? What a simulation asks of any kind of
// tissue: still as in the original system, elastic, or one's own.
//
// Cells are named by their index in the organ's lattice.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "collision/signed_distance.h"
#include "geometry/aabb.h"
#include "geometry/pose.h"

namespace resect {

// A bond by one of its ends.
struct TissueBond {
  std::int64_t cell = -1;
  std::int32_t direction = -1;  // tissue/stencil.h
};

// A rigid instrument as tissue feels it in one frame.
struct TissueTool {
  std::int32_t tool = 0;                  // its number in the simulation
  const SignedDistance* shape = nullptr;  // in the tool's frame; null: it pushes nothing
  Pose from, to;                          // at the start and the end of the frame
  double standOff = 0;                    // cells' centres are kept this far from its surface, m
  double friction = 0.3;
  double slipForce = 0;  // of its grip, N: beyond it all that it holds is let go
};

struct TissueSurroundings {
  std::span<const TissueTool> tools;  // in the order of their numbers; those in hand alone
  bool table = false;                 // a level top at y = 0 with friction 0.3
};

// What happened to tissue in a frame.
struct TissueStep {
  std::int32_t substeps = 0;
  std::int32_t retries = 0;  // how often the frame was started again with shorter substeps
  bool calm = true;          // false: even the shortest exploded; the tissue was stopped
  std::int32_t torn = 0;     // bonds
  std::vector<TissueBond> tornBonds;
  std::vector<Vec3> toolForce;      // on each of the tools, mean over the frame, N
  std::vector<std::int32_t> letGo;  // tools whose grip slipped
  Vec3 tableForce = Vec3::Zero();   // on the table, mean over the frame, N
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

  // False for tissue that never leaves its rest positions: then nothing below but remove() counts.
  virtual bool moves() const = 0;

  // Moves on by `duration` > 0, s. `step` is overwritten; its memory is used again.
  virtual void move(double duration, const TissueSurroundings& surroundings, TissueStep& step) = 0;

  virtual void remove(std::int64_t cell) = 0;
  // Direction as in tissue/stencil.h.
  virtual void sever(std::int64_t cell, int direction) = 0;
  // The tool holds on to the cell at the place where both are: its pose in this frame's start.
  virtual void grip(std::int64_t cell, std::int32_t tool, const Pose& pose) = 0;
  virtual void release(std::int32_t tool) = 0;
  virtual std::int32_t gripped(std::int32_t tool) const = 0;  // cells that the tool holds

  virtual bool solid(std::int64_t cell) const = 0;
  virtual std::uint32_t bonds(std::int64_t cell) const = 0;  // bit d: bonded in direction d
  virtual Vec3 displacement(std::int64_t cell) const = 0;    // m
  // The cells whose centres are now in a closed box of the world, ascending.
  virtual std::vector<std::int64_t> cellsIn(const Aabb& box) const = 0;
  virtual Mat3 deformation(std::int64_t cell) const = 0;  // F
  // The same for many cells at once; places.size() = cells.size().
  virtual void place(std::span<const std::int64_t> cells,
                     std::span<CellPlacement> places) const = 0;
  virtual std::uint64_t stateHash() const = 0;
  virtual std::size_t bytes() const = 0;  // memory held
};

}  // namespace resect
