// Contact of tissue cells with obstacles (instruments, the table), and between the faces of a cut.
//
// Faces of a cut do not pass through each other: the two ends of a cut bond are pushed apart like
// inelastic balls.
//
// Once per frame the cells that can come near are listed. After every substep each of them that is
// nearer to an obstacle than its stand-off is moved back along the surface's normal and loses its
// velocity towards the obstacle and, up to Coulomb's limit, its tangential velocity. The momentum
// lost, over the frame's duration, is the force on the obstacle; at rest it equals the pressure of
// the tissue.
#pragma once

#include <vector>

#include "tissue/elastic/elastic_state.h"
#include "tissue/tissue_model.h"

namespace resect {

class TissueContacts {
 public:
  // Lists the cells for a frame of `duration` s. `world` gives rest positions: world = rest + u.
  // `gripper[cell of the box]`, when not empty, is the tool that holds the cell, or -1: a tool does
  // not push the cells that it holds.
  void list(const ElasticState& state, const Vec3& origin, double duration,
            std::span<const Obstacle> obstacles, std::span<const std::int32_t> gripper);

  // After a substep that ends at `share` of the frame; `lookAhead`: as in the passes
  // (SubstepConstants).
  void push(ElasticState& state, double share, double lookAhead);

  // From now on keeps the two ends of a cut bond at least nine tenths of their rest distance apart,
  // or their present distance if that is less.
  void keepApart(const ElasticState& state, std::int32_t cell, int direction);
  void forgetCell(std::int32_t cell);
  // Whether all pairs lie in a box of so many cells.
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
    // Where it reaches in the frame.
    Pose back;   // from the world to the obstacle
    Aabb box;    // in the obstacle's frame
    Aabb world;  // bounds of the box
    Vec3 up[2];  // of a half space, at the frame's start and end
  };
  struct CutPair {
    std::int32_t a = 0, b = 0;
    float distance = 0;          // minimum, m
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
