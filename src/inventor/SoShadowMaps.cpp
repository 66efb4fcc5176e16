#include "inventor/SoShadowMaps.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <Inventor/SbMatrix.h>
#include <Inventor/SbViewVolume.h>
#include <Inventor/SbViewportRegion.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/elements/SoViewingMatrixElement.h>
#include <Inventor/errors/SoDebugError.h>
#include <Inventor/misc/SoContextHandler.h>
#include <Inventor/misc/SoState.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoPolygonOffset.h>
#include <Inventor/nodes/SoSeparator.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "inventor/materials.h"

namespace resect {

namespace {

constexpr GLenum kLampUnit = GL_TEXTURE7, kAboveUnit = GL_TEXTURE6, kGridUnit = GL_TEXTURE5;

// Clip space [-1,1]^3 -> texture space [0,1]^3, for row vectors.
SbMatrix clipToTexture() {
  SbMatrix half;
  half.setTransform(SbVec3f(0.5f, 0.5f, 0.5f), SbRotation::identity(), SbVec3f(0.5f, 0.5f, 0.5f));
  return half;
}

// World space -> clip space, for row vectors.
SbMatrix worldToClip(const SoCamera* camera) { return camera->getViewVolume(1.0f).getMatrix(); }

// 0 when the sources do not compile; Coin's error handler is then told why.
GLuint makeProgram(const char* vertexFile, const char* fragmentFile) {
  const GLuint program = glCreateProgram();
  char log[2000] = "";
  for (const auto& [file, stage] :
       {std::pair(vertexFile, GL_VERTEX_SHADER), std::pair(fragmentFile, GL_FRAGMENT_SHADER)}) {
    const std::string source = shaderSource({file});
    const char* text = source.c_str();
    const GLuint shader = glCreateShader(GLenum(stage));
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    glAttachShader(program, shader);
    glDeleteShader(shader);
  }
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked) return program;
  if (log[0] == '\0') glGetProgramInfoLog(program, sizeof log, nullptr, log);
  SoDebugError::post("SoShadowMaps", "GLSL shader %s: %s", fragmentFile, log);
  glDeleteProgram(program);
  return 0;
}

void setTextureMatrix(GLenum unit, const SbMatrix& matrix) {
  glActiveTexture(unit);
  glMatrixMode(GL_TEXTURE);
  glLoadMatrixf(matrix[0]);
}

}  // namespace

// A texture to draw into.
struct SoShadowMaps::Map {
  GLuint texture = 0, framebuffer = 0;
  GLsizei size = 0;

  void make(GLsizei texels, bool isDepth) {
    size = texels;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, isDepth ? GL_DEPTH_COMPONENT24 : GL_RGBA8, size, size, 0,
                 isDepth ? GL_DEPTH_COMPONENT : GL_RGBA,
                 isDepth ? GL_UNSIGNED_INT : GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    // Outside nothing casts: depth is far; all is seen, of a surface at no height.
    const float outside[4] = {1.0f, 1.0f, 1.0f, isDepth ? 1.0f : 0.0f};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, outside);
    if (isDepth) {
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
      glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_LUMINANCE);
    }
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, isDepth ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0,
                           GL_TEXTURE_2D, texture, 0);
    glDrawBuffer(isDepth ? GL_NONE : GL_COLOR_ATTACHMENT0);
    glReadBuffer(isDepth ? GL_NONE : GL_COLOR_ATTACHMENT0);
  }

  void use() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, size, size);
  }

  void free() const {
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
  }
};

struct SoShadowMaps::ContextMaps {
  Map lamp, above, grid;
  GLuint program = 0;
  SbUniqueId drawn = 0;  // the node id that the maps show
  std::unique_ptr<SoGLRenderAction> action;

  void make(GLsizei size) {
    if (lamp.size > 0) freeMaps();
    lamp.make(size, true);
    above.make(size, true);
    grid.make(std::max(size * 3 / 16, 16), false);
  }
  void freeMaps() const {
    for (const Map* map : {&lamp, &above, &grid}) map->free();
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
    // A little deeper than the truth, else a surface shades itself.
    auto* offset = new SoPolygonOffset;
    offset->factor = 1.5f;
    offset->units = 4.0f;
    root->addChild(offset);
    return root;
  };
  fromLamp_ = seenFrom(lamp_ = new SoPerspectiveCamera);
  fromAbove_ = seenFrom(above_ = new SoOrthographicCamera);
  SoContextHandler::addContextDestructionCallback(contextDestroyed, this);
}

SoShadowMaps::~SoShadowMaps() {
  SoContextHandler::removeContextDestructionCallback(contextDestroyed, this);
  for (auto& [context, maps] : contexts_)
    SoGLCacheContextElement::scheduleDeleteCallback(
        context,
        [](void* closure, std::uint32_t) {
          const std::unique_ptr<ContextMaps> dead(static_cast<ContextMaps*>(closure));
          dead->free();
        },
        maps.release());
  fromLamp_->unref();
  fromAbove_->unref();
}

void SoShadowMaps::contextDestroyed(std::uint32_t context, void* node) {
  auto* self = static_cast<SoShadowMaps*>(node);
  const auto found = self->contexts_.find(context);
  if (found == self->contexts_.end()) return;
  found->second->free();
  self->contexts_.erase(found);
}

void SoShadowMaps::draw(ContextMaps& maps, std::uint32_t context) {
  const auto size = GLsizei(std::clamp(resolution.getValue(), 64, 4096));
  if (maps.lamp.size != size) {
    maps.make(size);
    maps.action = std::make_unique<SoGLRenderAction>(SbViewportRegion(short(size), short(size)));
    maps.action->setCacheContext(context);
  }

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

  for (auto [map, root] : {std::pair(&maps.lamp, fromLamp_), std::pair(&maps.above, fromAbove_)}) {
    if (root->getNumChildren() == 3) root->addChild(casters.getValue());
    if (root->getChild(3) != casters.getValue()) root->replaceChild(3, casters.getValue());
    map->use();
    glDepthMask(GL_TRUE);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_DEPTH_BUFFER_BIT);
    maps.action->apply(root);
  }
  drawGrid(maps);
  ++redraws_;
}

// One quad over the grid; what each texel is, is worked out in data/shaders/grid.frag.
void SoShadowMaps::drawGrid(ContextMaps& maps) const {
  if (maps.program == 0) maps.program = makeProgram("grid.vert", "grid.frag");
  if (maps.program == 0) return;
  const auto uniform = [&](const char* name) { return glGetUniformLocation(maps.program, name); };
  const auto bindDepths = [&](const Map& map, GLenum unit) {
    glActiveTexture(unit);
    glBindTexture(GL_TEXTURE_2D, map.texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_NONE);
  };
  maps.grid.use();
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
  std::unique_ptr<ContextMaps>& maps = contexts_[context];
  if (!maps) maps = std::make_unique<ContextMaps>();

  if (maps->drawn != getNodeId()) {
    // Coin keeps a shadow copy of OpenGL's state: everything the inner drawing touches is put back.
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
    glDisable(GL_SCISSOR_TEST);  // a picture may be drawn in part, its shadows never
    draw(*maps, context);
    maps->drawn = getNodeId();
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
  glBindTexture(GL_TEXTURE_2D, maps->grid.texture);
  setTextureMatrix(kAboveUnit, toTexture(above_));
  glBindTexture(GL_TEXTURE_2D, maps->above.texture);
  setTextureMatrix(kLampUnit, toTexture(lamp_));
  glBindTexture(GL_TEXTURE_2D, maps->lamp.texture);
  glActiveTexture(GLenum(unit));
  glMatrixMode(GLenum(mode));
}

}  // namespace resect
