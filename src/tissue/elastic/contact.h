// Contact of tissue cells with obstacles (instruments, the table, the tool box), and of the two
// faces of a cut with each other.
//
// Once per frame the cells that can come near an obstacle are listed. After every substep each
// listed cell that is nearer to the obstacle than the stand-off is moved back along the normal of
// the obstacle's surface. It loses its velocity towards the obstacle and, up to Coulomb's limit,
// its tangential velocity with the way it went by it in the substep. The momentum that cells lose,
// divided by the frame's duration, is the force on the obstacle. For tissue at rest this is the
// force with which the tissue presses on the obstacle.
//
// The faces of a cut are kept from passing through each other: the two ends of each cut bond are
// pushed apart like inelastic balls.
#pragma once

#include <vector>

#include "tissue/elastic/elastic_state.h"
#include "tissue/tissue_model.h"

namespace resect {

class TissueContacts {
 public:
  // To be called once per frame: lists the cells that can come near an obstacle in the frame.
  // duration: of the frame, s. origin: rest position of cell (0, 0, 0), m. gripper: for each cell
  // of the box the tool that holds it, or -1; may be empty. A tool does not push the cells that it
  // holds.
  void list(const ElasticState& state, const Vec3& origin, double duration,
            std::span<const Obstacle> obstacles, std::span<const std::int32_t> gripper);

  // To be called after each substep: pushes cells out of obstacles, and the ends of cut bonds
  // apart. share: the fraction of the frame at which the substep ends, 0 to 1. dt: length of the
  // substep, s. lookAhead: SubstepConstants::lookAhead.
  void push(ElasticState& state, double share, double dt, double lookAhead);

  // To be called when the bond from `cell` in `direction` is cut. From then on the two ends of the
  // bond are pushed apart when they come nearer to each other than a minimum distance. This is nine
  // tenths of their rest distance, or their distance at the time of the cut if that is less.
  void keepApart(const ElasticState& state, std::int32_t cell, int direction);
  // Forgets the cut bonds that end at the cell.
  void forgetCell(std::int32_t cell);
  // Whether the ends of all cut bonds are valid indices in a box of `cells` cells.
  bool fit(std::int32_t cells) const;

  // Momentum that cells have given to each obstacle since list(), kg m/s.
  std::span<const Vec3> impulse() const { return impulse_; }
  // Sets impulse() to zero.
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
  // A cell that can come near an obstacle.
  struct Near {
    std::int32_t cell;
    Vec3 rest;  // rest position, m
  };
  // An obstacle in this frame.
  struct Body {
    Obstacle obstacle;
    Vec3 velocity, spin;  // of the obstacle in the frame, world, m/s and rad/s
    std::vector<Near> cells;
    Pose back;   // from the world to the obstacle's coordinate frame at the end of the frame
    Aabb box;    // where the obstacle can touch cells in the frame, in that coordinate frame
    Aabb world;  // bounds of `box` in the world
    Vec3 up[2];  // outward normal of a half-space at the start and at the end of the frame
  };
  // The two ends of a cut bond, as indices in the box.
  struct CutPair {
    std::int32_t a = 0, b = 0;
    float distance = 0;          // below it the two are pushed apart, m
    Vec3f rest = Vec3f::Zero();  // from a to b at rest, m

    template <class Visitor>
    void visit(Visitor& v) {
      v("a", a), v("b", b), v("distance", distance), v("rest", rest);
    }
  };
  void pushCutFaces(ElasticState& state, double lookAhead);
  std::vector<Body> bodies_;  // the first bodyCount_ are in use
  std::size_t bodyCount_ = 0;
  std::vector<CutPair> cut_;
  std::vector<Vec3> impulse_;  // per obstacle, kg m/s
};

}  // namespace resect
