#include "inventor/scene/operating_room.h"

#include <GL/gl.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoCallback.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoEventCallback.h>
#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoPickStyle.h>
#include <Inventor/nodes/SoPointSet.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShaderProgram.h>
#include <Inventor/nodes/SoShapeHints.h>
#include <Inventor/nodes/SoSpotLight.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTransform.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "geometry/normals.h"
#include "geometry/topology.h"
#include "inventor/blood/SoBloodPool.h"
#include "inventor/blood/SoSmoke.h"
#include "inventor/gl/SoOrganShape.h"
#include "inventor/gl/SoShadeOnce.h"
#include "inventor/gl/SoShadowMaps.h"
#include "inventor/gl/materials.h"
#include "inventor/gl/vectors.h"
#include "inventor/init.h"
#include "inventor/scene/model_nodes.h"

namespace resect {

namespace {

// A quad whose corners the vertex shader moves to those of the picture; tiny, so that it does not
// affect the scene's bounds.
SoNode* backgroundQuad() {
  auto* quad = new SoSeparator;
  auto* corners = new SoCoordinate3;
  const float e = 1e-4f;
  const SbVec3f points[4] = {{-e, -e, 0.0f}, {e, -e, 0.0f}, {e, e, 0.0f}, {-e, e, 0.0f}};
  corners->point.setValues(0, 4, points);
  quad->addChild(corners);
  auto* face = new SoFaceSet;
  face->numVertices = 4;
  quad->addChild(face);
  return quad;
}

// Drops of blood at these places.
SoSeparator* dropsIn(SoCoordinate3* places) {
  auto* sprites = new SoCallback;  // so that drop.frag knows where on the point it is
  sprites->setCallback([](void*, SoAction* action) {
    if (action->isOfType(SoGLRenderAction::getClassTypeId())) glEnable(GL_POINT_SPRITE);
  });
  auto* style = new SoDrawStyle;
  style->pointSize = 4;
  auto* unpickable = new SoPickStyle;
  unpickable->style = SoPickStyle::UNPICKABLE;
  return withMaterial(RoomMaterial::Drop, {sprites, style, unpickable, places, new SoPointSet});
}

// Colour, hints and shape of one tissue. Back faces of a closed surface are culled.
struct Tissue {
  SoBaseColor* colour;
  SoShapeHints* hints;
  SoOrganShape* shape;
};

Tissue appendTissue(SoSeparator* tissue, const Vec3f& colour) {
  SoSeparator* separator = uncachedSeparator();
  auto* hints = new SoShapeHints;
  hints->vertexOrdering = SoShapeHints::COUNTERCLOCKWISE;
  hints->shapeType = SoShapeHints::UNKNOWN_SHAPE_TYPE;
  auto* base = new SoBaseColor;
  base->rgb.setValue(colour.data());
  auto* shape = new SoOrganShape;
  auto* once = new SoShadeOnce;
  once->addChild(shape);
  separator->addChild(base);
  separator->addChild(hints);
  separator->addChild(once);
  tissue->addChild(separator);
  return {base, hints, shape};
}

// An uncut surface with smooth normals.
void setMesh(const Tissue& tissue, const TriangleMesh& mesh) {
  const Topology form = topology(mesh);
  tissue.hints->shapeType =
      form.closed() && form.oriented() ? SoShapeHints::SOLID : SoShapeHints::UNKNOWN_SHAPE_TYPE;
  std::vector<Vec3f> points(mesh.points.size()), normals(mesh.points.size());
  std::ranges::transform(mesh.points, points.begin(),
                         [](const Vec3& p) { return Vec3f(p.cast<float>()); });
  std::ranges::transform(pointNormals(mesh), normals.begin(),
                         [](const Vec3& n) { return Vec3f(n.cast<float>()); });
  const std::vector<float> cut(points.size(), 0.0f);
  tissue.shape->update(wholeSurface(points, normals, cut, mesh.triangles));
}

}  // namespace

void setPose(SoTransform* transform, const Pose& pose) {
  const Eigen::Quaterniond& q = pose.rotation;
  transform->translation = toSb(pose.position);
  transform->rotation = SbRotation(float(q.x()), float(q.y()), float(q.z()), float(q.w()));
}

Pose getPose(const SoTransform& transform) {
  const SbVec3f& p = transform.translation.getValue();
  const float* q = transform.rotation.getValue().getValue();
  return {Vec3(p[0], p[1], p[2]), Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized()};
}

OperatingRoom::OperatingRoom() {
  initInventor();
  root_ = uncachedSeparator();
  root_->ref();
  camera_ = new SoPerspectiveCamera;
  root_->addChild(camera_);
  for (SoSpotLight*& lamp : lamps_) root_->addChild(lamp = new SoSpotLight);
  lamps_[0]->color = SbColor(1.0f, 0.93f, 0.83f);
  lamps_[1]->color = SbColor(0.72f, 0.86f, 1.0f);
  root_->addChild(head_ = new SoSpotLight);
  head_->color = SbColor(1.0f, 0.985f, 0.95f);

  shadows_ = new SoShadowMaps;
  root_->addChild(shadows_);
  casters_ = uncachedSeparator();
  shadows_->casters = casters_;

  table_ = uncachedSeparator();
  toolbox_ = uncachedSeparator();
  tools_ = uncachedSeparator();
  toolShadows_ = uncachedSeparator();
  tissue_ = uncachedSeparator();
  auto* unpickable = new SoPickStyle;
  unpickable->style = SoPickStyle::UNPICKABLE;
  tissue_->addChild(unpickable);
  tissue_->addChild(organPose_ = new SoTransform);
  const Tissue organ = appendTissue(tissue_, kLiverColour);
  organColour_ = organ.colour;
  organHints_ = organ.hints;
  organs_ = {organ.shape};
  for (SoNode* node : {toolbox_, tissue_}) casters_->addChild(node);
  shadows_->movers = toolShadows_;

  root_->addChild(withMaterial(RoomMaterial::Liver, {tissue_}));
  steel_ = makeMaterial(RoomMaterial::Steel);
  steel_->ref();
  root_->addChild(withMaterial(RoomMaterial::Steel, {toolbox_}));
  root_->addChild(tools_);
  root_->addChild(handsShown_ = new SoSwitch);
  bare_ = new SoOrganShape;
  clips_ = uncachedSeparator();
  auto* closed = new SoShapeHints;
  closed->vertexOrdering = SoShapeHints::COUNTERCLOCKWISE;
  closed->shapeType = SoShapeHints::SOLID;
  auto* notPickedEither = new SoPickStyle;
  notPickedEither->style = SoPickStyle::UNPICKABLE;
  root_->addChild(withMaterial(RoomMaterial::Strand, {notPickedEither, closed, bare_}));
  root_->addChild(withMaterial(RoomMaterial::Steel, {notPickedEither, clips_}));
  adnexa_ = new SoOrganShape;
  adnexa_->showBloodOf(*organs_[0]);
  adnexaShown_ = new SoSwitch;
  adnexaShown_->addChild(adnexa_);
  auto* sheets = new SoShapeHints;  // they are seen from both sides
  sheets->vertexOrdering = SoShapeHints::COUNTERCLOCKWISE;
  sheets->shapeType = SoShapeHints::UNKNOWN_SHAPE_TYPE;
  root_->addChild(withMaterial(RoomMaterial::Strand, {notPickedEither, sheets, adnexaShown_}));
  root_->addChild(pool_ = new SoBloodPool);
  root_->addChild(withMaterial(RoomMaterial::Cloth, {table_}));
  root_->addChild(field_ = uncachedSeparator());
  for (SoSwitch** part : {&fieldWall_, &fieldDome_}) (*part = new SoSwitch)->ref();
  drops_ = new SoCoordinate3;
  drops_->point.setNum(0);
  root_->addChild(dropsIn(drops_));
  // Drawn last, since most of it is hidden.
  auto* room = withMaterial(RoomMaterial::Room, {backgroundQuad()});
  auto* notPicked = new SoPickStyle;
  notPicked->style = SoPickStyle::UNPICKABLE;
  room->insertChild(notPicked, 0);
  root_->addChild(room);
  // Mixed with what is behind it.
  root_->addChild(withMaterial(RoomMaterial::Smoke, {smoke_ = new SoSmoke}));
  aids_ = uncachedSeparator();
  auto* flatColours = new SoLightModel;
  flatColours->model = SoLightModel::BASE_COLOR;
  aids_->addChild(flatColours);
  root_->addChild(aids_);
  scope_ = new SoSwitch;
  auto* mask = withMaterial(RoomMaterial::Scope, {backgroundQuad()});
  mask->insertChild(notPicked, 0);
  scope_->addChild(mask);
  root_->addChild(scope_);
  setLights(RoomView::Surgeon);
}

OperatingRoom::~OperatingRoom() {
  for (SoSwitch* part : {fieldWall_, fieldDome_}) part->unref();
  steel_->unref();
  root_->unref();
}

SoNode* OperatingRoom::root() const { return root_; }

void OperatingRoom::setTable(SoNode* model) {
  table_->removeAllChildren();
  if (model) table_->addChild(model);
}

void OperatingRoom::setToolbox(SoNode* model) {
  toolbox_->removeAllChildren();
  if (model) toolbox_->addChild(model);
}

SoNode* OperatingRoom::tableModel() const {
  return table_->getNumChildren() > 0 ? table_->getChild(0) : nullptr;
}

SoNode* OperatingRoom::toolboxModel() const {
  return toolbox_->getNumChildren() > 0 ? toolbox_->getChild(0) : nullptr;
}

void OperatingRoom::changedIn(const Aabb& box) {
  followTools();
  shadows_->changedIn(box);
}

void OperatingRoom::setShadowResolution(int texels) {
  if (shadows_->resolution.getValue() != texels) shadows_->resolution = texels;
}

void OperatingRoom::holdShadows(bool held) { shadows_->hold(held); }

void OperatingRoom::addListener(SoEventCallback* listener) {
  root_->insertChild(listener, root_->findChild(camera_) + 1);
}

void OperatingRoom::removeListener(SoEventCallback* listener) { root_->removeChild(listener); }

void OperatingRoom::setOrgan(const TriangleMesh& mesh, const Vec3f& colour) {
  setOrganColour(colour);
  setMesh({organColour_, organHints_, organs_[0]}, mesh);
}

void OperatingRoom::setOrganColour(const Vec3f& colour) {
  organColour_->rgb.setValue(colour.data());
}

// The surface of an organ is closed.
void OperatingRoom::addOrgan(const Vec3f& colour) {
  const Tissue organ = appendTissue(tissue_, colour);
  organ.hints->shapeType = SoShapeHints::SOLID;
  organs_.push_back(organ.shape);
}

void OperatingRoom::addTissue(const TriangleMesh& mesh, const Vec3f& colour) {
  setMesh(appendTissue(tissue_, colour), mesh);
}

void OperatingRoom::setOrganPose(const Pose& pose) { setPose(organPose_, pose); }

}  // namespace resect
