#include "inventor/scene/model_nodes.h"

#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoIndexedFaceSet.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoNormal.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShapeHints.h>
#include <Inventor/nodes/SoTransform.h>
#include <Inventor/nodes/SoTranslation.h>

#include <algorithm>
#include <numbers>

#include "base/error.h"

namespace resect {

namespace {

std::vector<SbVec3f> toSb(const std::vector<Vec3>& points) {
  std::vector<SbVec3f> result(points.size());
  std::ranges::transform(points, result.begin(), [](const Vec3& p) {
    return SbVec3f(float(p.x()), float(p.y()), float(p.z()));
  });
  return result;
}

SoShapeHints* makeHints(double creaseDegrees) {
  auto* hints = new SoShapeHints;
  hints->vertexOrdering = SoShapeHints::COUNTERCLOCKWISE;
  hints->creaseAngle = float(creaseDegrees * std::numbers::pi / 180.0);
  return hints;
}

void addTriangles(SoSeparator* model, const TriangleMesh& mesh) {
  auto* coordinates = new SoCoordinate3;
  const std::vector<SbVec3f> points = toSb(mesh.points);
  coordinates->point.setValues(0, int(points.size()), points.data());
  model->addChild(coordinates);
  auto* faces = new SoIndexedFaceSet;
  std::vector<std::int32_t> indices;
  indices.reserve(4 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) indices.insert(indices.end(), {t[0], t[1], t[2], -1});
  faces->coordIndex.setValues(0, int(indices.size()), indices.data());
  model->addChild(faces);
}

SoMaterial* materialNode(const Finish& finish) {
  auto* material = new SoMaterial;
  const Vec3f ambient = 0.35f * finish.diffuse;
  material->ambientColor.setValue(ambient.x(), ambient.y(), ambient.z());
  material->diffuseColor.setValue(finish.diffuse.x(), finish.diffuse.y(), finish.diffuse.z());
  material->specularColor.setValue(finish.specular.x(), finish.specular.y(), finish.specular.z());
  material->shininess = finish.shininess;
  return material;
}

}  // namespace

SoSeparator* makePart(const DrawnPart& part) {
  constexpr double kCreaseDegrees = 30;
  auto* model = new SoSeparator;
  SoShapeHints* hints = makeHints(kCreaseDegrees);
  if (part.closed) hints->shapeType = SoShapeHints::SOLID;
  model->addChild(hints);
  model->addChild(materialNode(part.finish.value_or(Finish())));
  if (!part.normals.empty()) {
    auto* normals = new SoNormal;
    std::vector<SbVec3f> vectors;
    for (const Vec3f& n : part.normals) vectors.emplace_back(n.x(), n.y(), n.z());
    normals->vector.setValues(0, int(vectors.size()), vectors.data());
    model->addChild(normals);
  }
  addTriangles(model, part.mesh);
  return model;
}

SoNode* makeModel(const TriangleMesh& mesh, double creaseDegrees) {
  auto* model = new SoSeparator;
  model->addChild(makeHints(creaseDegrees));
  addTriangles(model, mesh);
  return model;
}

ToolNodes makeToolNodes(const ToolModel& tool) {
  if (tool.drawn.empty()) requireTriangles(tool.mesh);
  for (const DrawnPart& part : tool.drawn) {
    requireTriangles(part.mesh);
    require(part.normals.empty() || part.normals.size() == part.mesh.points.size(),
            "a drawn part has {} normals for {} points; give one for each, or none",
            part.normals.size(), part.mesh.points.size());
  }
  auto* model = new SoSeparator;
  ToolNodes nodes{model, {}};
  if (tool.drawn.empty()) model->addChild(makePart({tool.mesh}));
  for (const DrawnPart& part : tool.drawn) {
    SoSeparator* separator = makePart(part);
    if (part.opens != 0) {
      auto* turn = new SoTransform;
      const Vec3f pivot = tool.jaws.pivot.cast<float>();
      turn->center.setValue(pivot.x(), pivot.y(), pivot.z());
      separator->insertChild(turn, 0);
      nodes.jaws.push_back({turn, tool.jaws.axis.cast<float>(), float(part.opens)});
    }
    model->addChild(separator);
  }
  return nodes;
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
