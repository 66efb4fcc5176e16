#include "inventor/reading/scene_model.h"

#include <Inventor/SoPath.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/VRMLnodes/SoVRMLCoordinate.h>
#include <Inventor/VRMLnodes/SoVRMLIndexedFaceSet.h>
#include <Inventor/VRMLnodes/SoVRMLIndexedLineSet.h>
#include <Inventor/VRMLnodes/SoVRMLPointSet.h>
#include <Inventor/VRMLnodes/SoVRMLText.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/draggers/SoDragger.h>
#include <Inventor/nodes/SoArray.h>
#include <Inventor/nodes/SoAsciiText.h>
#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoImage.h>
#include <Inventor/nodes/SoIndexedFaceSet.h>
#include <Inventor/nodes/SoIndexedLineSet.h>
#include <Inventor/nodes/SoIndexedNurbsCurve.h>
#include <Inventor/nodes/SoIndexedNurbsSurface.h>
#include <Inventor/nodes/SoIndexedPointSet.h>
#include <Inventor/nodes/SoIndexedTriangleStripSet.h>
#include <Inventor/nodes/SoLineSet.h>
#include <Inventor/nodes/SoMultipleCopy.h>
#include <Inventor/nodes/SoNormalBinding.h>
#include <Inventor/nodes/SoNurbsCurve.h>
#include <Inventor/nodes/SoNurbsSurface.h>
#include <Inventor/nodes/SoPointSet.h>
#include <Inventor/nodes/SoQuadMesh.h>
#include <Inventor/nodes/SoText2.h>
#include <Inventor/nodes/SoTriangleStripSet.h>
#include <Inventor/nodes/SoVertexProperty.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

#include "base/error.h"
#include "inventor/reading/face_set.h"
#include "inventor/reading/indexed_face_set.h"
#include "inventor/reading/indexed_triangle_strip_set.h"
#include "inventor/reading/scene_limits.h"
#include "inventor/reading/scene_places.h"
#include "inventor/reading/triangle_strip_set.h"

namespace resect {
namespace {

constexpr std::size_t kMostTriangles = 20'000'000;

// The material of the shape that is traversed, brought into range; none if that is Inventor's own,
// which shapes without a Material node have, or a number is not finite.
std::optional<Finish> finishAt(const SoCallbackAction& action) {
  SbColor ambient, diffuse, specular, emission;
  float shininess = 0, transparency = 0;
  action.getMaterial(ambient, diffuse, specular, emission, shininess, transparency);
  if (diffuse == SbColor(0.8f, 0.8f, 0.8f) && specular == SbColor(0, 0, 0) && shininess == 0.2f)
    return std::nullopt;
  Finish finish{Vec3f(diffuse.getValue()), Vec3f(specular.getValue()), shininess};
  if (!finish.diffuse.allFinite() || !finish.specular.allFinite() || !std::isfinite(shininess))
    return std::nullopt;
  finish.diffuse = finish.diffuse.cwiseMax(0).cwiseMin(1);
  finish.specular = finish.specular.cwiseMax(0).cwiseMin(1);
  finish.shininess = std::clamp(shininess, 0.0f, 1.0f);
  return finish;
}

// The normals of a shape without indices, one for each of its points, in the world; none unless the
// scene gives each point one.
std::vector<Vec3f> normalsAt(const SoTriangleStripSet& shape, const SoCallbackAction& action,
                             std::size_t points) {
  const auto binding = action.getNormalBinding();
  const bool each =
      binding == SoNormalBinding::PER_VERTEX || binding == SoNormalBinding::PER_VERTEX_INDEXED;
  if (!each || shape.vertexProperty.getValue() || shape.startIndex.getValue() != 0 ||
      std::size_t(action.getNumNormals()) < points)
    return {};
  const SbMatrix turn = action.getModelMatrix().inverse().transpose();
  std::vector<Vec3f> normals(points, Vec3f::Zero());
  for (std::size_t i = 0; i < points; ++i) {
    SbVec3f n;
    turn.multDirMatrix(action.getNormal(int(i)), n);
    const Vec3f unit = Vec3f(n.getValue()).normalized();
    if (std::abs(unit.norm() - 1) < 1e-4f) normals[i] = unit;
  }
  return normals;
}

// Collects triangles in the callbacks of one traversal.
class Collector {
 public:
  explicit Collector(Model& model) : model_(model) {}

  // Runs `work`; its Error is kept for after the traversal, since exceptions must not pass through
  // Coin.
  template <typename Work>
  SoCallbackAction::Response guarded(Work work) {
    try {
      return work();
    } catch (const Error& e) {
      if (!failure_) failure_ = e;
    } catch (const std::bad_alloc&) {
      if (!failure_) failure_ = error("{}: needs too much memory; simplify the model", model_.path);
    }
    return SoCallbackAction::ABORT;
  }

  void add(const SoCallbackAction& action, TriangleMesh mesh, std::vector<Vec3f> normals = {}) {
    triangles_ += mesh.triangles.size();
    if (triangles_ > kMostTriangles)
      throw error("{}: more than {} triangles; simplify the model", model_.path, kMostTriangles);
    addToPart(model_, {partName(action), std::move(mesh), std::move(normals), finishAt(action)});
  }

  // Coin's triangles come one by one and are collected per shape.
  void addCorner(const SoCallbackAction& action, const SoPrimitiveVertex& vertex) {
    gathered_.points.push_back(inWorld(action, vertex.getPoint()));
  }
  void endTriangle() {
    const auto n = std::int32_t(gathered_.points.size());
    gathered_.triangles.push_back({n - 3, n - 2, n - 1});
  }
  void endShape(const SoCallbackAction& action) { add(action, std::exchange(gathered_, {})); }
  bool full() const { return triangles_ + gathered_.triangles.size() > kMostTriangles; }

  void throwFailure() const {
    if (failure_) throw *failure_;
  }
  const std::string& path() const { return model_.path; }

  static Vec3 inWorld(const SoCallbackAction& action, const SbVec3f& point) {
    SbVec3f p;
    action.getModelMatrix().multVecMatrix(point, p);
    return {p[0], p[1], p[2]};
  }

 private:
  static std::string partName(const SoCallbackAction& action) {
    const SoFullPath& path =
        *static_cast<const SoFullPath*>(const_cast<SoCallbackAction&>(action).getCurPath());
    for (int i = path.getLength() - 1; i >= 0; --i) {
      const SbName name = path.getNode(i)->getName();
      if (name.getLength() > 0) return name.getString();
    }
    return "";
  }

  Model& model_;
  TriangleMesh gathered_;
  std::size_t triangles_ = 0;
  std::optional<Error> failure_;
};

std::vector<Vec3> pointsOf(const SoMFVec3f& field) {
  std::vector<Vec3> points;
  points.reserve(std::size_t(field.getNum()));
  for (int i = 0; i < field.getNum(); ++i)
    points.emplace_back(field[i][0], field[i][1], field[i][2]);
  return points;
}

std::vector<Vec3> pointsAt(const SoVertexShape& shape, const SoCallbackAction& action) {
  std::vector<Vec3> points;
  const SoNode* property = shape.vertexProperty.getValue();
  if (property && property->isOfType(SoVertexProperty::getClassTypeId())) {
    points = pointsOf(static_cast<const SoVertexProperty*>(property)->vertex);
    if (!points.empty()) return points;
  }
  const int count = action.getNumCoordinates();
  points.reserve(std::size_t(count));
  for (int i = 0; i < count; ++i) {
    const SbVec3f& p = action.getCoordinate3(i);
    points.emplace_back(p[0], p[1], p[2]);
  }
  return points;
}

TriangleMesh inWorld(const SoCallbackAction& action, TriangleMesh mesh) {
  for (Vec3& p : mesh.points)
    p = Collector::inWorld(action, SbVec3f(float(p.x()), float(p.y()), float(p.z())));
  return mesh;
}

template <typename Shape>
SoCallbackAction::Response convert(void* data, SoCallbackAction* action, const SoNode* node) {
  auto& collector = *static_cast<Collector*>(data);
  return collector.guarded([&] {
    const auto& shape = *static_cast<const Shape*>(node);
    TriangleMesh mesh{pointsAt(shape, *action), {}};
    appendTriangles(shape, mesh.points, collector.path() + ":", mesh.triangles);
    std::vector<Vec3f> normals;
    if constexpr (std::is_same_v<Shape, SoTriangleStripSet>)
      normals = normalsAt(shape, *action, mesh.points.size());
    collector.add(*action, inWorld(*action, std::move(mesh)), std::move(normals));
    return SoCallbackAction::PRUNE;
  });
}

SoCallbackAction::Response convertVrml(void* data, SoCallbackAction* action, const SoNode* node) {
  auto& collector = *static_cast<Collector*>(data);
  return collector.guarded([&] {
    const auto& shape = *static_cast<const SoVRMLIndexedFaceSet*>(node);
    const SoNode* coordinates = shape.coord.getValue();
    TriangleMesh mesh;
    if (coordinates && coordinates->isOfType(SoVRMLCoordinate::getClassTypeId()))
      mesh.points = pointsOf(static_cast<const SoVRMLCoordinate*>(coordinates)->point);
    appendFaces({shape.coordIndex.getValues(0), std::size_t(shape.coordIndex.getNum())},
                mesh.points, collector.path() + ": IndexedFaceSet", mesh.triangles);
    collector.add(*action, inWorld(*action, std::move(mesh)));
    return SoCallbackAction::PRUNE;
  });
}

SoCallbackAction::Response skip(void*, SoCallbackAction*, const SoNode*) {
  return SoCallbackAction::PRUNE;
}

SoCallbackAction::Response checkLimits(void* data, SoCallbackAction* action, const SoNode* node) {
  auto& collector = *static_cast<Collector*>(data);
  return collector.guarded([&] {
    checkNodeLimits(*node, *action, collector.path());
    return SoCallbackAction::CONTINUE;
  });
}

void takeTriangle(void* data, SoCallbackAction* action, const SoPrimitiveVertex* a,
                  const SoPrimitiveVertex* b, const SoPrimitiveVertex* c) {
  auto& collector = *static_cast<Collector*>(data);
  if (collector.full()) return;  // reported at the end of the shape
  collector.addCorner(*action, *a);
  collector.addCorner(*action, *b);
  collector.addCorner(*action, *c);
  collector.endTriangle();
}

SoCallbackAction::Response endShape(void* data, SoCallbackAction* action, const SoNode*) {
  auto& collector = *static_cast<Collector*>(data);
  return collector.guarded([&] {
    collector.endShape(*action);
    return SoCallbackAction::CONTINUE;
  });
}

}  // namespace

void addScene(SoNode* root, ShapeReading reading, Model& model) {
  Collector collector(model);
  SoCallbackAction action;
  // The check comes first: Coin calls the callbacks of a type in the order of registration.
  action.addPreCallback(SoNode::getClassTypeId(), checkLimits, &collector);
  if (reading == ShapeReading::Converted) {
    action.addPreCallback(SoTriangleStripSet::getClassTypeId(), convert<SoTriangleStripSet>,
                          &collector);
    action.addPreCallback(SoIndexedFaceSet::getClassTypeId(), convert<SoIndexedFaceSet>,
                          &collector);
    action.addPreCallback(SoIndexedTriangleStripSet::getClassTypeId(),
                          convert<SoIndexedTriangleStripSet>, &collector);
    action.addPreCallback(SoFaceSet::getClassTypeId(), convert<SoFaceSet>, &collector);
    action.addPreCallback(SoQuadMesh::getClassTypeId(), convert<SoQuadMesh>, &collector);
    action.addPreCallback(SoVRMLIndexedFaceSet::getClassTypeId(), convertVrml, &collector);
  }
  for (const SoType type :
       {SoLineSet::getClassTypeId(), SoIndexedLineSet::getClassTypeId(),
        SoPointSet::getClassTypeId(), SoIndexedPointSet::getClassTypeId(),
        SoNurbsCurve::getClassTypeId(), SoIndexedNurbsCurve::getClassTypeId(),
        SoText2::getClassTypeId(), SoAsciiText::getClassTypeId(), SoImage::getClassTypeId(),
        SoVRMLIndexedLineSet::getClassTypeId(), SoVRMLPointSet::getClassTypeId(),
        SoVRMLText::getClassTypeId(), SoDragger::getClassTypeId()})
    action.addPreCallback(type, skip, nullptr);
  action.addTriangleCallback(SoShape::getClassTypeId(), takeTriangle, &collector);
  action.addPostCallback(SoShape::getClassTypeId(), endShape, &collector);
  action.apply(root);
  collector.throwFailure();
  model.places = findPlaces(root);
}

}  // namespace resect
