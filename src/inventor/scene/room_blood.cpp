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
  clips_->removeAllChildren();
  if (!vessels) return;
  const auto add = [](SoGroup* to, const TriangleMesh& mesh, const Finish& finish) {
    if (mesh.triangles.empty()) return;
    DrawnPart part;
    part.mesh = mesh;
    part.finish = finish;
    part.closed = true;
    to->addChild(makePart(part));
  };
  // Colours as on a screen: portal vein in its sheath, hepatic vein, artery, bile duct.
  const std::array<Vec3f, kVesselKinds> kColours = {
      Vec3f(0.70f, 0.47f, 0.42f), Vec3f(0.45f, 0.24f, 0.30f), Vec3f(0.76f, 0.45f, 0.38f),
      Vec3f(0.58f, 0.54f, 0.28f)};
  for (std::size_t kind = 0; kind < kColours.size(); ++kind)
    add(bare_, vessels->tubes[kind], {.diffuse = kColours[kind]});
  add(bare_, vessels->mouths, {.diffuse = Vec3f(0.13f, 0.02f, 0.02f)});
  add(bare_, vessels->sealed, {.diffuse = Vec3f(0.42f, 0.33f, 0.26f)});
  add(clips_, vessels->clips, {});
}

}  // namespace resect
