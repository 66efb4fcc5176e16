// Which cells do tools and table touch in a frame, and how are they pushed?
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

#include "tissue/elastic_state.h"
#include "tissue/tissue_model.h"

namespace resect {

class TissueContacts {
 public:
  // Lists the cells for a frame of `duration` s. `world` gives rest positions: world = rest + u.
  // `gripper[cell of the box]`, when not empty, is the tool that holds the cell, or -1: it is not
  // pushed by its holder.
  void list(const ElasticState& state, const Vec3& origin, double duration,
            const TissueSurroundings& surroundings, std::span<const std::int32_t> gripper);

  // After a substep that ends at `share` of the frame; `lookAhead` as in the passes.
  void push(ElasticState& state, double share, double lookAhead);

  // The two ends of a bond that is cut meet again but do not pass each other: from now on they keep
  // nine tenths of their distance at rest, or what they have now.
  void keepApart(const ElasticState& state, std::int32_t cell, int direction);
  void forgetCell(std::int32_t cell);

  // Momentum given since list(), kg m/s; by place in surroundings.tools.
  const std::vector<Vec3>& toolImpulse() const { return toolImpulse_; }
  const Vec3& tableImpulse() const { return tableImpulse_; }
  void forgetImpulses();

 private:
  struct Near {
    std::int32_t cell;
    Vec3 rest;  // where it was, world, m
  };
  struct Body {
    TissueTool tool;
    Vec3 velocity, spin;  // world, m/s and 1/s
    std::vector<Near> cells;
  };
  struct CutPair {
    std::int32_t a, b;
    float distance;  // kept, m
    Vec3f rest;      // from a to b at rest, m
  };
  void pushCutFaces(ElasticState& state, double lookAhead);
  std::vector<Body> bodies_;
  std::size_t bodyCount_ = 0;
  std::vector<Near> onTable_;
  std::vector<CutPair> cut_;
  std::vector<Vec3> toolImpulse_;
  Vec3 tableImpulse_ = Vec3::Zero();
};

}  // namespace resect
