#include "inventor/scene/scene_file.h"

#include <Inventor/SoOutput.h>
#include <Inventor/actions/SoWriteAction.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoIndexedFaceSet.h>
#include <Inventor/nodes/SoInfo.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoMaterialBinding.h>
#include <Inventor/nodes/SoNormal.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShapeHints.h>
#include <Inventor/nodes/SoSpotLight.h>
#include <Inventor/nodes/SoTransform.h>

#include <cmath>
#include <cstdlib>
#include <ostream>

#include "inventor/reading/scene_places.h"
#include "io/output/atomic_file.h"

namespace resect {
namespace {

SoSeparator* placed(const Pose& pose, SoNode* model) {
  auto* separator = new SoSeparator;
  auto* transform = new SoTransform;
  setPose(transform, pose);
  separator->addChild(transform);
  separator->addChild(model);
  return separator;
}

// Materials for cut shares in five steps from the capsule's colour to the parenchyma's.
SoSeparator* organNode(const SurfaceTracker::Compact& organ) {
  constexpr int kShades = 5;
  auto* separator = new SoSeparator;
  separator->setName(kOrganNode);
  auto* hints = new SoShapeHints;
  hints->vertexOrdering = SoShapeHints::COUNTERCLOCKWISE;
  separator->addChild(hints);
  auto* material = new SoMaterial;
  for (int i = 0; i < kShades; ++i) {
    const float share = float(i) / (kShades - 1);
    const Vec3f c = (1 - share) * kLiverColour + share * kCutColour;
    material->diffuseColor.set1Value(i, c.x(), c.y(), c.z());
  }
  material->specularColor.setValue(0.35f, 0.33f, 0.32f);
  material->shininess = 0.6f;
  separator->addChild(material);
  auto* binding = new SoMaterialBinding;
  binding->value = SoMaterialBinding::PER_VERTEX_INDEXED;
  separator->addChild(binding);

  auto* coordinates = new SoCoordinate3;
  std::vector<SbVec3f> points, normals;
  for (const Vec3& p : organ.mesh.points)
    points.emplace_back(float(p.x()), float(p.y()), float(p.z()));
  for (const Vec3f& n : organ.normals) normals.emplace_back(n.x(), n.y(), n.z());
  coordinates->point.setValues(0, int(points.size()), points.data());
  separator->addChild(coordinates);
  auto* normal = new SoNormal;
  normal->vector.setValues(0, int(normals.size()), normals.data());
  separator->addChild(normal);
  auto* faces = new SoIndexedFaceSet;
  std::vector<std::int32_t> corners, shades;
  for (const Triangle& t : organ.mesh.triangles) {
    for (const std::int32_t v : t) {
      corners.push_back(v);
      shades.push_back(int(std::lround(organ.cut[std::size_t(v)] * (kShades - 1))));
    }
    corners.push_back(-1);
    shades.push_back(-1);
  }
  faces->coordIndex.setValues(0, int(corners.size()), corners.data());
  faces->materialIndex.setValues(0, int(shades.size()), shades.data());
  separator->addChild(faces);
  return separator;
}

}  // namespace

void writeSceneFile(const std::filesystem::path& path, const OperatingRoom& room,
                    const SurfaceTracker::Compact& organ) {
  auto* root = new SoSeparator;
  root->ref();
  auto* info = new SoInfo;
  info->string = kSceneMark;
  root->addChild(info);
  SoNode* camera = room.camera()->copy();
  camera->setName(kCameraNode);
  root->addChild(camera);
  for (int i : {0, 1}) root->addChild(room.lamp(i)->copy());
  if (room.tableModel()) root->addChild(room.tableModel());
  if (room.toolboxModel()) root->addChild(room.toolboxModel());
  for (int i = 0; i < room.toolCount(); ++i) {
    SoSeparator* tool = placed(getPose(*room.toolTransform(i)), room.toolModel(i));
    tool->getChild(0)->setName(toolNode(i).c_str());
    root->addChild(tool);
  }
  root->addChild(organNode(organ));

  SoOutput out;
  std::size_t size = 1 << 20;
  void* buffer = std::malloc(size);
  out.setBuffer(buffer, size, [](void* old, size_t wanted) { return std::realloc(old, wanted); });
  SoWriteAction(&out).apply(root);
  root->unref();
  out.getBuffer(buffer, size);
  std::string text(static_cast<const char*>(buffer), size);
  std::free(buffer);
  writeFileAtomically(path, [&](std::ostream& stream) { stream << text; });
}

void setCamera(OperatingRoom& room, const ScenePlaces& places) {
  SoPerspectiveCamera& camera = *room.camera();
  const Eigen::Quaterniond& q = places.camera.rotation;
  const Vec3f p = places.camera.position.cast<float>();
  camera.position.setValue(p.x(), p.y(), p.z());
  camera.orientation.setValue(float(q.x()), float(q.y()), float(q.z()), float(q.w()));
  camera.heightAngle = float(places.heightAngle);
  camera.focalDistance = float(places.focalDistance);
  camera.nearDistance = float(0.05 * places.focalDistance);
  camera.farDistance = float(20 * places.focalDistance);
}

}  // namespace resect
