// Blood that is on no organ, and bare vessels, in the room.
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoSeparator.h>

#include <array>

#include "inventor/blood/SoBloodPool.h"
#include "inventor/scene/model_nodes.h"
#include "inventor/scene/operating_room.h"
#include "operation/blood/bare_vessels.h"
#include "operation/blood/loose_blood.h"

namespace resect {

void OperatingRoom::setLooseBlood(const LooseBlood* blood) {
  pool_->set(blood ? blood->pool : std::vector<std::uint8_t>());
  const int count = blood ? int(blood->drops.size()) : 0;
  if (count == 0 && drops_->point.getNum() == 0) return;
  drops_->point.setNum(count);
  for (int i = 0; i < count; ++i)
    drops_->point.set1Value(i, SbVec3f(blood->drops[std::size_t(i)].data()));
}

void OperatingRoom::setBareVessels(const BareVessels* vessels) {
  bare_->removeAllChildren();
  if (!vessels) return;
  // Colours as on a screen: portal vein, hepatic vein, artery, bile duct, what heat has sealed.
  const std::array<Vec3f, kVesselKinds> kColours = {
      Vec3f(0.80f, 0.58f, 0.55f), Vec3f(0.50f, 0.38f, 0.50f), Vec3f(0.88f, 0.60f, 0.52f),
      Vec3f(0.72f, 0.70f, 0.40f)};
  const auto add = [&](const TriangleMesh& mesh, const Finish& finish) {
    if (mesh.triangles.empty()) return;
    DrawnPart part;
    part.mesh = mesh;
    part.finish = finish;
    part.closed = true;
    bare_->addChild(makePart(part));
  };
  for (std::size_t kind = 0; kind < kColours.size(); ++kind)
    add(vessels->tubes[kind], {kColours[kind], Vec3f::Constant(0.08f), 0.6f});
  add(vessels->sealed, {Vec3f(0.62f, 0.52f, 0.42f), Vec3f::Constant(0.03f), 0.2f});
  add(vessels->clips, {});
}

}  // namespace resect
