#include "inventor/gl/SoShadowMaps.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <Inventor/SbBox2f.h>
#include <Inventor/SbMatrix.h>
#include <Inventor/SbViewVolume.h>
#include <Inventor/SbViewportRegion.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/elements/SoViewingMatrixElement.h>
#include <Inventor/errors/SoDebugError.h>
#include <Inventor/misc/SoState.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoPolygonOffset.h>
#include <Inventor/nodes/SoSeparator.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "inventor/gl/gl_program.h"
#include "inventor/gl/map_texture.h"

namespace resect {

namespace {

constexpr GLenum kLampUnit = GL_TEXTURE0 + kLampShadowUnit, kAboveUnit = GL_TEXTURE6,
                 kGridUnit = GL_TEXTURE0 + kShadowGridUnit;

// Clip space [-1,1]^3 -> texture space [0,1]^3, for row vectors.
SbMatrix clipToTexture() {
  SbMatrix half;
  half.setTransform(SbVec3f(0.5f, 0.5f, 0.5f), SbRotation::identity(), SbVec3f(0.5f, 0.5f, 0.5f));
  return half;
}

// World space -> clip space, for row vectors.
SbMatrix worldToClip(const SoCamera* camera) { return camera->getViewVolume(1.0f).getMatrix(); }

// Bounds of the box in the camera's picture, 0 to 1 along each axis.
SbBox2f placesOf(const Aabb& box, const SoCamera* camera) {
  const SbViewVolume volume = camera->getViewVolume(1.0f);
  SbBox2f places;
  for (int corner = 0; corner < 8; ++corner) {
    SbVec3f place;
    volume.projectToScreen(SbVec3f(float(corner & 1 ? box.max.x() : box.min.x()),
                                   float(corner & 2 ? box.max.y() : box.min.y()),
                                   float(corner & 4 ? box.max.z() : box.min.z())),
                           place);
    places.extendBy(SbVec2f(place[0], place[1]));
  }
  return places;
}

// The texels that contain these bounds, with `margin` more on each side.
PixelRect texelsOf(const SbBox2f& places, GLsizei texels, int margin) {
  const auto texel = [&](float place) {
    return int(std::clamp(place, 0.0f, 1.0f) * float(texels));
  };
  const SbVec2f low = places.getMin(), high = places.getMax();
  return {std::max(texel(low[0]) - margin, 0), std::max(texel(low[1]) - margin, 0),
          std::min(texel(high[0]) + 1 + margin, int(texels)),
          std::min(texel(high[1]) + 1 + margin, int(texels))};
}

void clipTo(const PixelRect& part) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(part.left, part.bottom, std::max(part.right - part.left, 0),
            std::max(part.top - part.bottom, 0));
}

void setTextureMatrix(GLenum unit, const SbMatrix& matrix) {
  glActiveTexture(unit);
  glMatrixMode(GL_TEXTURE);
  glLoadMatrixf(matrix[0]);
}

}  // namespace

struct SoShadowMaps::ContextMaps {
  MapTexture stillLamp, stillAbove;  // of the casters
  MapTexture lamp, above, grid;      // of casters and movers
  GLuint program = 0;
  SbUniqueId drawn = 0, drawnCasters = 0;  // the node ids that the maps show
  SbMatrix drawnFrom;                      // the lamp's matrix at that time
  Aabb changed;                            // bounds of changes since then
  bool anywhere = false;                   // bounds are unknown
  std::unique_ptr<SoGLRenderAction> action;

  void make(GLsizei size) {
    if (lamp.size > 0) freeMaps();
    for (MapTexture* map : {&stillLamp, &stillAbove, &lamp, &above}) map->make(size, true);
    grid.make(std::max(size * 3 / 16, 16), false);
  }
  void freeMaps() const {
    for (const MapTexture* map : {&stillLamp, &stillAbove, &lamp, &above, &grid}) map->free();
  }
  void free() const {
    freeMaps();
    if (program) glDeleteProgram(program);
  }
};

SO_NODE_SOURCE(SoShadowMaps);

void SoShadowMaps::initClass() {
  if (classTypeId != SoType::badType()) return;
  // Not SO_NODE_INIT_CLASS: it would keep the So in the name that files use.
  PRIVATE_COMMON_INIT_CODE(SoShadowMaps, "ShadowMaps", &SoShadowMaps::createInstance, SoNode);
  SO_ENABLE(SoGLRenderAction, SoViewingMatrixElement);
}

SoShadowMaps::SoShadowMaps() {
  SO_NODE_CONSTRUCTOR(SoShadowMaps);
  SO_NODE_ADD_FIELD(casters, (nullptr));
  SO_NODE_ADD_FIELD(movers, (nullptr));
  SO_NODE_ADD_FIELD(lampPosition, (0.3f, 1.3f, 0.3f));
  SO_NODE_ADD_FIELD(focus, (0.0f, 0.0f, 0.0f));
  SO_NODE_ADD_FIELD(radius, (0.5f));
  SO_NODE_ADD_FIELD(resolution, (1024));

  const auto seenFrom = [](SoCamera* camera) {
    auto* root = new SoSeparator;
    root->ref();
    root->renderCaching = SoSeparator::OFF;
    root->addChild(camera);
    auto* flat = new SoLightModel;
    flat->model = SoLightModel::BASE_COLOR;
    root->addChild(flat);
    // Depth offset against self-shadowing.
    auto* offset = new SoPolygonOffset;
    offset->factor = 1.5f;
    offset->units = 4.0f;
    root->addChild(offset);
    return root;
  };
  fromLamp_ = seenFrom(lamp_ = new SoPerspectiveCamera);
  fromAbove_ = seenFrom(above_ = new SoOrthographicCamera);
}

SoShadowMaps::~SoShadowMaps() {
  fromLamp_->unref();
  fromAbove_->unref();
}

void SoShadowMaps::changedIn(const Aabb& box) {
  for (auto& [context, maps] : contexts_)
    box.empty() ? void(maps->anywhere = true) : maps->changed.grow(box);
}

// Sets the two cameras from the fields.
void SoShadowMaps::aim() {
  const SbVec3f centre = focus.getValue();
  const float r = std::max(radius.getValue(), 1e-4f);
  const float distance = std::max((lampPosition.getValue() - centre).length(), 1.1f * r);
  lamp_->position = lampPosition.getValue();
  lamp_->pointAt(centre, SbVec3f(0.0f, 0.0f, -1.0f));
  lamp_->nearDistance = distance - r;
  lamp_->farDistance = distance + r;
  lamp_->heightAngle = 2.0f * std::asin(r / distance);
  above_->position = centre + SbVec3f(0.0f, r, 0.0f);
  above_->orientation = SbRotation(SbVec3f(1.0f, 0.0f, 0.0f), -float(M_PI_2));
  above_->nearDistance = 0.0f;
  above_->farDistance = 2.0f * r;
  above_->height = 2.0f * r;
}

void SoShadowMaps::draw(ContextMaps& maps, std::uint32_t context) {
  const auto size = GLsizei(std::clamp(resolution.getValue(), 64, 4096));
  aim();
  const SbMatrix seen = worldToClip(lamp_);
  bool whole = maps.anywhere || maps.changed.empty() || seen != maps.drawnFrom;
  if (maps.lamp.size != size) {
    maps.make(size);
    maps.action = std::make_unique<SoGLRenderAction>(SbViewportRegion(short(size), short(size)));
    maps.action->setCacheContext(context);
    whole = true;
  }
  const bool stillChanged = whole || maps.drawnCasters != casters.getValue()->getNodeId();
  if (stillChanged && whole) ++wholeRedraws_;

  struct View {
    const MapTexture &still, &full;
    SoSeparator* root;
    const SoCamera* camera;
  };
  for (const View& view : {View{maps.stillLamp, maps.lamp, fromLamp_, lamp_},
                           View{maps.stillAbove, maps.above, fromAbove_, above_}}) {
    const auto apply = [&](SoNode* shapes) {
      if (view.root->getNumChildren() == 3) view.root->addChild(shapes);
      if (view.root->getChild(3) != shapes) view.root->replaceChild(3, shapes);
      maps.action->apply(view.root);
    };
    glDepthMask(GL_TRUE);
    glEnable(GL_DEPTH_TEST);
    if (stillChanged) {
      view.still.use();
      if (!whole) clipTo(texelsOf(placesOf(maps.changed, view.camera), size, 2));
      glClear(GL_DEPTH_BUFFER_BIT);
      apply(casters.getValue());
      glDisable(GL_SCISSOR_TEST);
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, view.still.framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, view.full.framebuffer);
    glBlitFramebuffer(0, 0, size, size, 0, 0, size, size, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    view.full.use();
    if (movers.getValue()) apply(movers.getValue());
  }
  drawGrid(maps, whole ? PixelRect{0, 0, maps.grid.size, maps.grid.size}
                       : gridPart(maps.changed, maps.grid.size));
  maps.drawnFrom = seen;
  maps.drawnCasters = casters.getValue()->getNodeId();
  maps.changed = {};
  maps.anywhere = false;
  ++redraws_;
}

// The texels of the grid that a change in this box can affect: those within reach of occlusion, and
// those in its shadow on the table.
PixelRect SoShadowMaps::gridPart(const Aabb& changed, std::int32_t texels) const {
  constexpr double kNear = 0.125, kSoft = 0.08;  // m; beyond the widest patterns of grid.frag
  const SbVec3f lamp = lampPosition.getValue(), centre = focus.getValue();
  Aabb reach = changed.padded(kNear);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p = changed.corner(corner);
    const double fall = std::max(lamp[1] - p.y(), 0.01), share = std::max(p.y(), 0.0) / fall;
    const Vec3 foot = p + share * (p - Vec3(lamp[0], lamp[1], lamp[2]));
    reach.grow(Aabb{foot, foot}.padded(kSoft));
  }
  const double side = 2.0 * std::max(radius.getValue(), 1e-4f);
  const auto place = [&](double x, double z) {
    return SbVec2f(float(0.5 + (x - centre[0]) / side), float(0.5 - (z - centre[2]) / side));
  };
  SbBox2f places;
  places.extendBy(place(reach.min.x(), reach.min.z()));
  places.extendBy(place(reach.max.x(), reach.max.z()));
  return texelsOf(places, texels, 1);
}

// Draws one quad over the grid; data/shaders/grid.frag computes each texel.
void SoShadowMaps::drawGrid(ContextMaps& maps, const PixelRect& part) const {
  if (maps.program == 0) maps.program = makeProgram({"grid.vert"}, {"grid.frag"});
  if (maps.program == 0) return;
  const auto uniform = [&](const char* name) { return glGetUniformLocation(maps.program, name); };
  const auto bindDepths = [&](const MapTexture& map, GLenum unit) {
    glActiveTexture(unit);
    glBindTexture(GL_TEXTURE_2D, map.texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_NONE);
  };
  maps.grid.use();
  clipTo(part);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glUseProgram(maps.program);
  bindDepths(maps.above, kAboveUnit);
  bindDepths(maps.lamp, kLampUnit);
  glUniform1i(uniform("heightMap"), kAboveUnit - GL_TEXTURE0);
  glUniform1i(uniform("lampDepth"), kLampUnit - GL_TEXTURE0);
  const SbVec3f centre = focus.getValue();
  glUniform3fv(uniform("focus"), 1, centre.getValue());
  glUniform1f(uniform("radius"), radius.getValue());
  glUniform2f(uniform("lampRange"), lamp_->nearDistance.getValue(), lamp_->farDistance.getValue());
  glUniform1f(uniform("lampTan"), std::tan(0.5f * lamp_->heightAngle.getValue()));
  SbMatrix worldToLamp = worldToClip(lamp_);
  worldToLamp.multRight(clipToTexture());
  glUniformMatrix4fv(uniform("worldToLamp"), 1, GL_FALSE, worldToLamp[0]);
  glRectf(-1.0f, -1.0f, 1.0f, 1.0f);
  glDisable(GL_SCISSOR_TEST);
  glUseProgram(0);
  glActiveTexture(kLampUnit);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glActiveTexture(GL_TEXTURE0);
}

void SoShadowMaps::GLRender(SoGLRenderAction* action) {
  SoState* state = action->getState();
  SoGLCacheContextElement::shouldAutoCache(state, SoGLCacheContextElement::DONT_AUTO_CACHE);
  if (casters.getValue() == nullptr) return;
  const auto context = std::uint32_t(SoGLCacheContextElement::get(state));
  ContextMaps& maps = contexts_[context];

  if (maps.drawn != getNodeId() && !(held_ && maps.drawn != 0)) {
    // Coin caches OpenGL's state: everything that the inner drawing changes is restored.
    GLint drawBuffer = 0, readBuffer = 0, program = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawBuffer);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &readBuffer);
    glGetIntegerv(GL_CURRENT_PROGRAM, &program);
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    glUseProgram(0);
    glDisable(
        GL_SCISSOR_TEST);  // pictures may be drawn in part, shadow maps not by that scissor box
    draw(maps, context);
    maps.drawn = getNodeId();
    glUseProgram(GLuint(program));
    glMatrixMode(GL_PROJECTION);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    glPopMatrix();
    glPopClientAttrib();
    glPopAttrib();
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(drawBuffer));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(readBuffer));
  }

  const SbMatrix eyeToWorld = SoViewingMatrixElement::get(state).inverse();
  const auto toTexture = [&](const SoCamera* camera) {
    SbMatrix m = eyeToWorld;
    m.multRight(worldToClip(camera));
    m.multRight(clipToTexture());
    return m;
  };
  GLint mode = 0, unit = 0;
  glGetIntegerv(GL_MATRIX_MODE, &mode);
  glGetIntegerv(GL_ACTIVE_TEXTURE, &unit);
  setTextureMatrix(kGridUnit, eyeToWorld);
  glBindTexture(GL_TEXTURE_2D, maps.grid.texture);
  setTextureMatrix(kAboveUnit, toTexture(above_));
  glBindTexture(GL_TEXTURE_2D, maps.above.texture);
  setTextureMatrix(kLampUnit, toTexture(lamp_));
  glBindTexture(GL_TEXTURE_2D, maps.lamp.texture);
  glActiveTexture(GLenum(unit));
  glMatrixMode(GLenum(mode));
}

}  // namespace resect
