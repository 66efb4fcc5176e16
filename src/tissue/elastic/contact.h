// Which cells do obstacles (instruments, the table) touch in a frame, and how are they pushed?
//
// Cut faces of one body do not pass through each other either: the ends of cut bonds are pushed
// apart like balls that do not rebound.
//
// Once per frame the cells that can come near are listed; after every substep each of them that is
// nearer to a body than its stand-off is put back along the surface's normal, loses its speed
// towards the body and, up to Coulomb's limit, its speed along it. The momentum so taken, over the
// frame, is the force on the body: in rest it equals what the tissue presses with.
#pragma once

#include <vector>

#include "tissue/elastic/elastic_state.h"
#include "tissue/tissue_model.h"

namespace resect {

class TissueContacts {
 public:
  // Lists the cells for a frame of `duration` s. `world` gives rest positions: world = rest + u.
  // `gripper[cell of the box]`, when not empty, is the tool that holds the cell, or -1: it is not
  // pushed by its holder.
  void list(const ElasticState& state, const Vec3& origin, double duration,
            std::span<const Obstacle> obstacles, std::span<const std::int32_t> gripper);

  // After a substep that ends at `share` of the frame; `lookAhead` as in the passes.
  void push(ElasticState& state, double share, double lookAhead);

  // The two ends of a bond that is cut meet again but do not pass each other: from now on they keep
  // nine tenths of their distance at rest, or what they have now.
  void keepApart(const ElasticState& state, std::int32_t cell, int direction);
  void forgetCell(std::int32_t cell);
  // Do all pairs lie in a box of so many cells?
  bool fit(std::int32_t cells) const;

  // Momentum given to each obstacle since list(), kg m/s.
  std::span<const Vec3> impulse() const { return impulse_; }
  void forgetImpulses();

  template <class Visitor>
  void visit(Visitor& v) {
    v("cut", cut_);
  }
  template <class Visitor>
  void visitMade(Visitor& v) {
    v.made(bodies_, bodyCount_, impulse_);
  }

 private:
  struct Near {
    std::int32_t cell;
    Vec3 rest;  // where it was, world, m
  };
  struct Body {
    Obstacle obstacle;
    Vec3 velocity, spin;  // world, m/s and 1/s
    std::vector<Near> cells;
  };
  struct CutPair {
    std::int32_t a = 0, b = 0;
    float distance = 0;          // kept, m
    Vec3f rest = Vec3f::Zero();  // from a to b at rest, m

    template <class Visitor>
    void visit(Visitor& v) {
      v("a", a), v("b", b), v("distance", distance), v("rest", rest);
    }
  };
  void pushCutFaces(ElasticState& state, double lookAhead);
  std::vector<Body> bodies_;
  std::size_t bodyCount_ = 0;
  std::vector<CutPair> cut_;
  std::vector<Vec3> impulse_;  // by obstacle
};

}  // namespace resect
