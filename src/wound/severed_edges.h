// The severed grid edges of an organ, and the traces of blades: the lines in which blades crossed
// the grid's faces.
//
// The grid is the grid of the colour field's nodes. All lengths are in node spacings. A severed
// edge keeps the position and the normal of its first cut, and never becomes whole again. An uncut
// organ stores nothing. The first cut allocates a few bytes for every brick (block of 4 x 4 x 4
// nodes) of the grid. In addition, each brick that a blade went through gets a record. After the
// first cut, severing an edge costs O(1).
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.h"

namespace resect {

constexpr float kWhole = -1;  // cut position of an edge that is not severed
// A cut keeps at least this distance from both ends of the edge, as a fraction of the edge's
// length. So there is a piece of the edge on each side of the cut.
constexpr float kCutMargin = 0.03f;

// A straight line that a blade left on a face. Each end of the line has two coordinates in the
// face, from 0 to 1. The first is along nextAxis() of the face's axis, the second along lastAxis()
// (wound/cut_grid.h).
struct FaceTrace {
  Eigen::Vector2f from = Eigen::Vector2f::Zero(), to = Eigen::Vector2f::Zero();
};

struct TouchedBrick {
  std::int64_t brick;
  bool within;  // true: grid cells of the brick have changed; false: only cells near the brick
};

class SeveredEdges {
 public:
  // brickDims: number of bricks along each axis. refine: number of nodes per lattice cell (cell of
  // tissue) along each axis.
  SeveredEdges(const Vec3i& brickDims, int refine) : brickDims_(brickDims), refine_(refine) {}

  bool empty() const { return records_.empty(); }
  std::int64_t count() const { return count_; }  // number of severed edges

  // Severs the edge from `node` along `axis` at the fraction t of its length; t is clamped to
  // [kCutMargin, 1 - kCutMargin]. normal: the blade's normal in rest space, of any length and sign.
  // If the edge is severed already, returns false and changes nothing.
  bool sever(const Vec3i& node, int axis, double t, const Vec3& normal);
  // Records a trace on the face at `node` whose normal is along `axis`. If the new trace continues
  // an earlier trace of the face in the same straight line, the earlier trace is extended instead.
  void trace(const Vec3i& node, int axis, const FaceTrace& line);

  // at(), betweenCells(), normal() and visitTraces() also accept nodes outside the grid, where
  // nothing is severed. at(): the cut's position as a fraction of the edge's length, 0 to 1; kWhole
  // for an edge that is not severed.
  float at(const Vec3i& node, int axis) const;
  // Between the mid-planes of two neighbouring lattice cells (the planes through their centres), a
  // grid line has a stretch of `refine` edges. Returns whether any edge is severed in the stretch
  // that contains the given edge. The node's coordinate along the axis must not be negative.
  bool betweenCells(const Vec3i& node, int axis) const;
  // Normal of the cut in a severed edge; unit, and not negative along `axis`.
  Vec3f normal(const Vec3i& node, int axis) const;
  // Calls visit(const FaceTrace&) for the traces on a face, in the order in which they were
  // recorded.
  template <typename Visit>
  void visitTraces(const Vec3i& node, int axis, Visit visit) const {
    const Record* r = record(node);
    if (!r) return;
    for (int i = r->firstTrace[slot(node, axis)]; i >= 0; i = r->traces[std::size_t(i)].next)
      visit(r->traces[std::size_t(i)].line);
  }

  // mask() and shares() give data of 64 edges along an axis: the edges whose lower nodes are the
  // nodes of the brick. mask(): which of these edges are severed. Bit n stands for the edge whose
  // lower node is node n of the brick. shares(): for each of these edges, in the order of the
  // nodes, the value that at() gives. shares() is null if the brick has no record.
  std::uint64_t mask(std::int64_t brick, int axis) const {
    const Record* r = recordOfBrick(brick);
    return r ? r->severed[std::size_t(axis)] : 0;
  }
  const float* shares(std::int64_t brick, int axis) const {
    const Record* r = recordOfBrick(brick);
    return r ? r->share[std::size_t(axis)].data() : nullptr;
  }
  // A lattice cube has the centres of 2 x 2 x 2 neighbouring lattice cells as corners. near() is
  // true if a blade severed an edge or left a trace in a lattice cube that contains a grid cell of
  // the brick. near() may also be true for other bricks round the blade. Where near() is false, the
  // surface is the same as that of an uncut organ.
  bool near(std::int64_t brick) const { return !near_.empty() && near_[std::size_t(brick)] != 0; }

  // The bricks whose surface has to be computed again, because an edge was severed or a trace was
  // recorded in or near the brick after the last update(). Each brick is listed once, in ascending
  // order. Bricks for which near() is false are left out. The span is valid until the next call of
  // update().
  std::span<const TouchedBrick> update();
  // The bricks that the next update() will examine, in any order.
  std::span<const std::int64_t> pending() const { return pending_; }

  std::size_t bytes() const;

  template <class Visitor>
  void visit(Visitor& v) {
    v("recordOf", recordOf_), v("records", records_), v("near", near_), v("count", count_);
    v("pendingOf", pendingOf_), v("pending", pending_);
  }
  template <class Visitor>
  void visitMade(Visitor& v) {
    v.made(brickDims_, refine_, touched_);
  }
  // Checks a loaded state: whether all numbers are in range and agree with each other.
  bool fit() const;

 private:
  struct Trace {
    FaceTrace line;
    std::int32_t next = -1;

    template <class Visitor>
    void visit(Visitor& v) {
      v("from", line.from), v("to", line.to), v("next", next);
    }
  };
  struct Record {
    Record();
    bool fit() const;
    template <class Visitor>
    void visit(Visitor& v) {
      v("severed", severed), v("share", share), v("normal", normal);
      v("firstTrace", firstTrace), v("traces", traces);
    }
    std::array<std::uint64_t, 3> severed{};
    std::array<std::array<float, 64>, 3> share;
    std::array<std::array<Vec3f, 64>, 3> normal;
    std::array<std::int32_t, 192> firstTrace;
    std::vector<Trace> traces;
  };

  static int slot(const Vec3i& node, int axis) {
    return 64 * axis + ((node.z() & 3) * 4 + (node.y() & 3)) * 4 + (node.x() & 3);
  }
  bool contains(const Vec3i& node) const {
    return (node.array() >= 0).all() && (node.array() < 4 * brickDims_.array()).all();
  }
  std::int64_t brickIndex(const Vec3i& b) const {
    return (std::int64_t(b.z()) * brickDims_.y() + b.y()) * brickDims_.x() + b.x();
  }
  const Record* recordOfBrick(std::int64_t brick) const {
    return empty() || recordOf_[std::size_t(brick)] < 0
               ? nullptr
               : &records_[std::size_t(recordOf_[std::size_t(brick)])];
  }
  const Record* record(const Vec3i& node) const {
    return contains(node) ? recordOfBrick(brickIndex(node / 4)) : nullptr;
  }
  Record& takeRecord(const Vec3i& node, int axis);
  template <typename Visit>
  void visitBricks(const Vec3i& low, const Vec3i& high, Visit visit) const;
  template <typename Visit>
  void visitNear(const Vec3i& node, Visit visit) const;
  void touch(const Vec3i& node);
  bool countAndNearFit() const;

  Vec3i brickDims_;
  int refine_;
  std::vector<std::int32_t> recordOf_;  // per brick: index in records_, or -1; empty: no records
  std::vector<Record> records_;
  std::vector<std::uint8_t> near_;       // per brick: near()
  std::vector<std::uint8_t> pendingOf_;  // per brick: 0, or bits for the next update()
  std::vector<std::int64_t> pending_;
  std::vector<TouchedBrick> touched_;
  std::int64_t count_ = 0;
};

}  // namespace resect
