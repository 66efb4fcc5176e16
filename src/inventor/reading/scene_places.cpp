#include "inventor/reading/scene_places.h"

#include <Inventor/SoPath.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/nodes/SoInfo.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoTransform.h>
#include <fmt/format.h>

namespace resect {
namespace {

template <typename Node>
const Node* named(SoNode* root, const std::string& name) {
  SoSearchAction search;
  search.setName(name.c_str());
  search.setType(Node::getClassTypeId());
  search.apply(root);
  return search.getPath() ? static_cast<const Node*>(search.getPath()->getTail()) : nullptr;
}

Pose poseAt(const SbVec3f& p, const SbRotation& rotation) {
  const float* q = rotation.getValue();
  // Inventor's quaternions are unit to single precision.
  return {Vec3(p[0], p[1], p[2]), Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized()};
}

bool isMarked(const SoNode& root) {
  if (!root.isOfType(SoGroup::getClassTypeId())) return false;
  const auto& group = static_cast<const SoGroup&>(root);
  if (group.getNumChildren() == 0 || !group.getChild(0)->isOfType(SoInfo::getClassTypeId()))
    return false;
  return static_cast<const SoInfo*>(group.getChild(0))->string.getValue() == kSceneMark;
}

}  // namespace

std::string toolNode(int tool) { return fmt::format("Tool_{}", tool + 1); }

std::optional<ScenePlaces> findPlaces(SoNode* root) {
  if (!isMarked(*root)) return std::nullopt;
  const auto* camera = named<SoPerspectiveCamera>(root, kCameraNode);
  if (!camera) return std::nullopt;
  ScenePlaces places;
  places.camera = poseAt(camera->position.getValue(), camera->orientation.getValue());
  places.heightAngle = camera->heightAngle.getValue();
  places.focalDistance = camera->focalDistance.getValue();
  // One more than there may be, for checkModel() to find.
  for (int i = 0; i <= int(kMostSceneTools); ++i) {
    const auto* tool = named<SoTransform>(root, toolNode(i));
    if (!tool) break;
    places.tools.push_back(poseAt(tool->translation.getValue(), tool->rotation.getValue()));
  }
  return places;
}

}  // namespace resect
