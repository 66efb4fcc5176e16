// Blood that is on no organ, bare vessels, clips, what hangs on an organ, and smoke, in the room.
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoSeparator.h>

#include <utility>

#include "inventor/blood/SoBloodPool.h"
#include "inventor/blood/SoSmoke.h"
#include "inventor/gl/SoOrganShape.h"
#include "inventor/scene/model_nodes.h"
#include "inventor/scene/operating_room.h"
#include "operation/blood/bare_vessels.h"
#include "operation/blood/loose_blood.h"

namespace resect {
namespace {

// Polymer clips: nothing else in an abdomen is of this colour.
const Finish kClip{Vec3f(0.50f, 0.95f, 0.90f), Vec3f(0.05f, 0.05f, 0.05f), 0.35f};

}  // namespace

void OperatingRoom::setLooseBlood(const LooseBlood* blood) {
  pool_->set(blood ? blood->pool : std::vector<std::uint8_t>());
  const int count = blood ? int(blood->drops.size()) : 0;
  if (count == 0 && drops_->point.getNum() == 0) return;
  drops_->point.setNum(count);
  if (count > 0)
    drops_->point.setValues(0, count, reinterpret_cast<const float(*)[3]>(blood->drops.data()));
}

void OperatingRoom::setBareVessels(const BareVessels* vessels) {
  static const BareVessels kNone;
  const BareVessels& shown = vessels ? *vessels : kNone;
  const SurfaceCopy& walls = shown.walls;
  if (!walls.triangles.empty() || bare_->triangleCount() > 0)
    bare_->update(
        wholeSurface(walls.points, walls.normals, walls.cut, walls.triangles, walls.rest));
  clips_->removeAllChildren();
  if (shown.clips.triangles.empty()) return;
  DrawnPart part;
  part.mesh = shown.clips;
  part.normals = shown.clipNormals;
  part.finish = kClip;
  part.closed = true;
  clips_->addChild(makePart(part));
}

void OperatingRoom::setAdnexa(const SurfaceCopy* adnexa) {
  if (!adnexa && adnexa_->triangleCount() == 0) return;
  static const SurfaceCopy kNone;
  const SurfaceCopy& shown = adnexa ? *adnexa : kNone;
  adnexa_->update(
      wholeSurface(shown.points, shown.normals, shown.cut, shown.triangles, shown.rest));
}

void OperatingRoom::setSmoke(std::vector<SmokeBall> smoke) { smoke_->set(std::move(smoke)); }

}  // namespace resect
