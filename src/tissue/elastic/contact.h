// Contact of tissue cells with obstacles (instruments, the table, the tray), and between the faces
// of a cut.
//
// The faces of a cut are kept from passing through each other: the two ends of a cut bond are
// pushed apart like inelastic balls.
//
// Once per frame the cells that can come near an obstacle are listed. After every substep each
// listed cell that is nearer to the obstacle than the stand-off is moved back along the normal of
// the obstacle's surface. It loses its velocity towards the obstacle and, up to Coulomb's limit,
// its tangential velocity. The momentum that cells lose, divided by the frame's duration, is the
// force on the obstacle. For tissue at rest it is the force with which the tissue presses on the
// obstacle.
#pragma once

#include <vector>

#include "tissue/elastic/elastic_state.h"
#include "tissue/tissue_model.h"

namespace resect {

class TissueContacts {
 public:
  // Lists the cells for a frame of `duration` s. origin: rest position of cell (0, 0, 0), m.
  // gripper: for each cell of the box the tool that holds it, or -1; may be empty. A tool does not
  // push the cells that it holds.
  void list(const ElasticState& state, const Vec3& origin, double duration,
            std::span<const Obstacle> obstacles, std::span<const std::int32_t> gripper);

  // Pushes cells out of obstacles, and the ends of cut bonds apart. To be called after a substep
  // that ends at the fraction `share` (0 to 1) of the frame. lookAhead:
  // SubstepConstants::lookAhead.
  void push(ElasticState& state, double share, double lookAhead);

  // From now on the two ends of a cut bond are pushed apart when they are nearer to each other than
  // nine tenths of their rest distance, or than their present distance if that is less.
  void keepApart(const ElasticState& state, std::int32_t cell, int direction);
  void forgetCell(std::int32_t cell);
  // Whether the ends of all cut bonds are indices of a box of `cells` cells.
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
    Vec3 rest;  // rest position, m
  };
  struct Body {
    Obstacle obstacle;
    Vec3 velocity, spin;  // world, m/s and 1/s
    std::vector<Near> cells;
    // Where the obstacle can touch cells in the frame.
    Pose back;   // from the world to the obstacle's coordinate frame at the frame's end
    Aabb box;    // in that coordinate frame
    Aabb world;  // bounds of `box` in the world
    Vec3 up[2];  // outward normal of a half space at the frame's start and end
  };
  struct CutPair {
    std::int32_t a = 0, b = 0;
    float distance = 0;          // minimum distance of a and b, m
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
