// The operative field: an opened abdomen round the organs.
#include <Inventor/nodes/SoPickStyle.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTransform.h>

#include <utility>

#include "inventor/gl/materials.h"
#include "inventor/gl/vectors.h"
#include "inventor/scene/model_nodes.h"
#include "inventor/scene/operating_room.h"
#include "operation/room.h"

namespace resect {
namespace {

// The shaders of the parts of the operative field, by the parts' names in its file.
std::optional<RoomMaterial> fieldMaterial(std::string_view part) {
  constexpr std::pair<std::string_view, RoomMaterial> kParts[] = {
      {"drape", RoomMaterial::Cloth}, {"skin", RoomMaterial::Skin},     {"fat", RoomMaterial::Fat},
      {"omentum", RoomMaterial::Fat}, {"muscle", RoomMaterial::Muscle}, {"gut", RoomMaterial::Gut},
      {"dome", RoomMaterial::Gut},    {"steel", RoomMaterial::Steel}};
  for (const auto& [name, material] : kParts)
    if (name == part) return material;
  return std::nullopt;
}

}  // namespace

void OperatingRoom::setField(SoNode* model, const Aabb& organs) {
  for (SoGroup* part : {static_cast<SoGroup*>(field_), static_cast<SoGroup*>(fieldWall_),
                        static_cast<SoGroup*>(fieldDome_)})
    part->removeAllChildren();
  adnexaShown_->whichChild = model ? SO_SWITCH_ALL : SO_SWITCH_NONE;
  if (!model) return updateHands();
  model->ref();
  const FieldPlace at = fieldPlace(organs);
  const auto scale = float(at.scale);
  auto* place = new SoTransform;
  place->translation = toSb(at.position);
  place->scaleFactor = SbVec3f(scale, scale, scale);
  auto* unpickable = new SoPickStyle;
  unpickable->style = SoPickStyle::UNPICKABLE;
  field_->addChild(unpickable);
  field_->addChild(place);
  const auto* parts = static_cast<SoSeparator*>(model);
  for (int i = 0; i < parts->getNumChildren(); ++i) {
    const std::string_view name = parts->getChild(i)->getName().getString();
    const auto material = fieldMaterial(name);
    if (!material) continue;
    SoGroup* parent = fieldWall_;
    if (name == "dome") parent = fieldDome_;
    if (name == "omentum" || name == "gut") parent = field_;
    parent->addChild(withMaterial(*material, {parts->getChild(i)}));
  }
  field_->addChild(fieldWall_);
  field_->addChild(fieldDome_);
  model->unref();  // its parts stay
  updateHands();
}

}  // namespace resect
