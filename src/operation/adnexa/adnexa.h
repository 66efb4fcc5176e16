// Follows what hangs on an organ and is only drawn: structures that are moved by the organ's
// tissue, and that neither tissue nor instruments meet.
#pragma once

#include <memory>
#include <vector>

#include "operation/adnexa/liver_adnexa.h"
#include "simulation/simulation.h"
#include "surface/surface_update.h"

namespace resect {

class Adnexa {
 public:
  // The present shapes, for viewers; null if there are none. Only the built-in liver has adnexa,
  // and only if it is the only organ. `rest` is in the organ's rest space, and `cut` is
  // LiverAdnexa::look. A triangle is left out ({0, 0, 0}) where the tissue that holds it was
  // removed, where a cut runs between its anchors, or where they have been drawn far apart. To be
  // called with the same simulation each time. Cost: some 0.4 ms, the first time 50 ms.
  std::shared_ptr<const SurfaceCopy> follow(const Simulation& simulation);

 private:
  // The tissue that carries an anchor: particles, the nearest first.
  struct Holder {
    std::vector<std::int64_t> particles;
    std::vector<double> weights;  // their sum is 1
    // Per particle: a bond that leads to it from one that is named before it, as long as both are
    // tissue. If it is severed, a cut lies between. Cell -1: there is no such bond.
    std::vector<TissueBond> bonds;
    // The bonds from the tissue of the anchor before to that of this anchor. Empty: no bonds.
    std::vector<TissueBond> before;
  };
  // The motion of the tissue round an anchor: the point X at rest is now at map * X + offset, m.
  struct Motion {
    Mat3 map = Mat3::Zero();
    Vec3 offset = Vec3::Zero();
    bool held = false;  // false: the tissue there has gone
    bool cut = false;   // a cut lies between this anchor and the one before

    bool operator==(const Motion&) const = default;
  };
  void begin(const OperatedOrgan& organ);
  std::vector<Motion> motionsIn(const OperatedOrgan& organ) const;
  std::vector<double> heights() const;

  bool begun_ = false;                 // begin() was called
  LiverAdnexa shapes_;                 // empty: this organ has none
  Pose place_;                         // of the liver in the organ's rest space
  std::vector<Vec3f> rest_, normals_;  // of the points, in the organ's rest space
  std::vector<Holder> holders_;        // per anchor
  std::vector<Motion> motions_;        // per anchor, of last_
  std::shared_ptr<const SurfaceCopy> last_;
};

}  // namespace resect
