#include "inventor/scene/model_nodes.h"

#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoIndexedFaceSet.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShapeHints.h>
#include <Inventor/nodes/SoTranslation.h>

#include <algorithm>
#include <numbers>

namespace resect {

SoNode* makeModel(const TriangleMesh& mesh, double creaseDegrees) {
  auto* model = new SoSeparator;
  auto* hints = new SoShapeHints;
  hints->vertexOrdering = SoShapeHints::COUNTERCLOCKWISE;
  hints->creaseAngle = float(creaseDegrees * std::numbers::pi / 180.0);
  model->addChild(hints);
  auto* coordinates = new SoCoordinate3;
  std::vector<SbVec3f> points(mesh.points.size());
  std::ranges::transform(mesh.points, points.begin(), [](const Vec3& p) {
    return SbVec3f(float(p.x()), float(p.y()), float(p.z()));
  });
  coordinates->point.setValues(0, int(points.size()), points.data());
  model->addChild(coordinates);
  auto* faces = new SoIndexedFaceSet;
  std::vector<std::int32_t> indices;
  indices.reserve(4 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) indices.insert(indices.end(), {t[0], t[1], t[2], -1});
  faces->coordIndex.setValues(0, int(indices.size()), indices.data());
  model->addChild(faces);
  return model;
}

SoNode* makePickProxy(SoNode* model) {
  constexpr float kLeast = 0.02f;  // m
  SoGetBoundingBoxAction measure(SbViewportRegion(100, 100));
  measure.apply(model);
  const SbBox3f box = measure.getBoundingBox();
  auto* proxy = new SoSeparator;
  if (box.isEmpty()) return proxy;
  auto* unseen = new SoDrawStyle;
  unseen->style = SoDrawStyle::INVISIBLE;
  proxy->addChild(unseen);
  auto* middle = new SoTranslation;
  middle->translation = box.getCenter();
  proxy->addChild(middle);
  auto* cube = new SoCube;
  const SbVec3f size = box.getMax() - box.getMin();
  cube->width = std::max(size[0], kLeast);
  cube->height = std::max(size[1], kLeast);
  cube->depth = std::max(size[2], kLeast);
  proxy->addChild(cube);
  return proxy;
}

}  // namespace resect
