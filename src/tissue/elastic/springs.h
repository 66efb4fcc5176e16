// Springs on single cells, for attachments of an organ (tissue/attachment.h) and for the grips of
// tools.
//
// Each spring is damped and leads from a cell to an anchor. For a grip, the anchor is fixed in the
// tool's coordinates. For an attachment, the anchor is fixed in the world, or moves with the
// patient's breathing. While a cell has springs, its load (ElasticState::load) is computed anew in
// each substep. The load is the sum of the forces of these springs and of the cell's joints, which
// are springs to other organs.
#pragma once

#include <span>
#include <vector>

#include "tissue/elastic/elastic_state.h"
#include "tissue/tissue_model.h"

namespace resect {

struct TissueSpring {
  std::int32_t cell = 0;       // index in ElasticState::box
  std::int32_t tool = -1;      // number of the tool that grips the cell; -1: an attachment
  Vec3 anchor = Vec3::Zero();  // m; of a grip: in the tool's coordinates; otherwise: world
  double stiffness = 0;        // N/m
  double damping = 0;          // N s/m

  template <class Visitor>
  void visit(Visitor& v) {
    v("cell", cell), v("tool", tool), v("anchor", anchor);
    v("stiffness", stiffness), v("damping", damping);
  }
};

class TissueSprings {
 public:
  void add(const TissueSpring& spring) { springs_.push_back(spring); }
  // Removes the springs for which drop(spring) is true. Returns the cells of the removed springs.
  template <typename Drop>
  std::vector<std::int32_t> drop(Drop drop) {
    std::vector<std::int32_t> cells;
    std::erase_if(springs_, [&](const TissueSpring& spring) {
      if (drop(spring)) cells.push_back(spring.cell);
      return drop(spring);
    });
    return cells;
  }
  std::span<const TissueSpring> all() const { return springs_; }

  // Adds the springs' forces to the loads of their cells, for one substep. held: motion of the
  // anchors of attachments. dt: duration of the substep, s. share: time at which the substep ends,
  // as a fraction of the frame, 0 to 1. frame: duration of the frame, s. origin: rest position of
  // the centre of cell (0, 0, 0), m. If a tool is not among the obstacles, its springs exert no
  // force.
  void pull(ElasticState& state, const Vec3& origin, std::span<const Obstacle> obstacles,
            const BreathMotion& held, double share, double frame, double dt);
  // Per obstacle: the momentum that the springs have given to the obstacle since the last
  // forgetImpulses(), kg m/s.
  std::span<const Vec3> impulse() const { return impulse_; }
  // Sets all entries of impulse() to 0. obstacles: number of obstacles.
  void forgetImpulses(std::size_t obstacles) { impulse_.assign(obstacles, Vec3::Zero()); }

  template <class Visitor>
  void visit(Visitor& v) {
    v("springs", springs_);
  }
  template <class Visitor>
  void visitMade(Visitor& v) {
    v.made(impulse_);
  }

 private:
  std::vector<TissueSpring> springs_;
  std::vector<Vec3> impulse_;  // per obstacle, kg m/s
};

}  // namespace resect
