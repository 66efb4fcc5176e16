#include "inventor/gl/SoShadeOnce.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <Inventor/SbVec4f.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/elements/SoGLShaderProgramElement.h>
#include <Inventor/elements/SoModelMatrixElement.h>
#include <Inventor/elements/SoProjectionMatrixElement.h>
#include <Inventor/elements/SoViewingMatrixElement.h>
#include <Inventor/elements/SoViewportRegionElement.h>
#include <Inventor/misc/SoState.h>
#include <Inventor/nodes/SoShaderProgram.h>

#include <algorithm>
#include <cmath>

#include "inventor/gl/SoOrganShape.h"
#include "inventor/gl/SoShadowMaps.h"
#include "inventor/gl/gl_program.h"
#include "inventor/gl/materials.h"

namespace resect {

namespace {

constexpr int kPlacesUnit = 3, kBendsUnit = 4;
// Stencil values of the organ's pixels; 0: other pixels.
constexpr int kPlain = 1, kRich = 2;

// The current depth renderbuffer; 0 if there is none or it is multisampled.
GLuint singleDepths() {
  GLint framebuffer = 0, samples = 0, kind = GL_NONE, name = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  glGetIntegerv(GL_SAMPLES, &samples);
  if (framebuffer == 0 || samples > 1) return 0;
  const auto ask = [](GLenum what, GLint& answer) {
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, what, &answer);
  };
  ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, kind);
  if (kind == GL_RENDERBUFFER) ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, name);
  return GLuint(name);
}

}  // namespace

struct SoShadeOnce::ContextTextures {
  GLuint framebuffer = 0, textures[2] = {};
  // mark finds the pixels of rich tissue. plain and rich shade.
  GLuint mark = 0, plain = 0, rich = 0;
  int width = 0, height = 0;

  bool hasPrograms() const { return mark != 0 && plain != 0 && rich != 0; }
  // At least this large.
  void make(int w, int h) {
    if (mark == 0) {
      mark = makeProgram({"deferred/gathered.vert"},
                         {"noise.glsl", "blood.glsl", "deferred/mark_rich.frag"});
      plain = makeProgram({"deferred/gathered.vert"},
                          {"deferred/plain.glsl", "light.glsl", "noise.glsl", "wet.glsl",
                           "liver.glsl", "deferred/gathered.frag"});
      rich = makeProgram({"deferred/gathered.vert"},
                         {"light.glsl", "noise.glsl", "blood.glsl", "vessels.glsl", "wet.glsl",
                          "liver.glsl", "deferred/gathered.frag"});
    }
    if (w <= width && h <= height) return;
    glPushAttrib(GL_TEXTURE_BIT);
    freeTextures();
    width = std::max(w, width), height = std::max(h, height);
    glGenTextures(2, textures);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    for (int t = 0; t < 2; ++t) {
      glBindTexture(GL_TEXTURE_2D, textures[t]);
      glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
      glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GLenum(GL_COLOR_ATTACHMENT0 + t), GL_TEXTURE_2D,
                             textures[t], 0);
    }
    const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(2, both);
    glPopAttrib();
  }
  void freeTextures() {
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(2, textures);
  }
  void free() {
    freeTextures();
    for (const GLuint program : {mark, plain, rich})
      if (program) glDeleteProgram(program);
  }
};

SO_NODE_SOURCE(SoShadeOnce);

void SoShadeOnce::initClass() {
  if (classTypeId != SoType::badType()) return;
  // Not SO_NODE_INIT_CLASS: it would keep the So in the name that files use.
  PRIVATE_COMMON_INIT_CODE(SoShadeOnce, "ShadeOnce", &SoShadeOnce::createInstance, SoGroup);
}

SoShadeOnce::SoShadeOnce() {
  SO_NODE_CONSTRUCTOR(SoShadeOnce);
  gathering_ = makeMaterial(RoomMaterial::Gather);
  gathering_->ref();
}

SoShadeOnce::~SoShadeOnce() { gathering_->unref(); }

// Pixels that the children can cover, within the scissor box if there is one.
PixelRect SoShadeOnce::pixels(SoGLRenderAction* action) const {
  SoState* state = action->getState();
  GLint view[4], scissor[4];
  glGetIntegerv(GL_VIEWPORT, view);
  PixelRect drawn{view[0], view[1], view[0] + view[2], view[1] + view[3]};
  if (glIsEnabled(GL_SCISSOR_TEST)) {
    glGetIntegerv(GL_SCISSOR_BOX, scissor);
    drawn = {std::max(drawn.left, scissor[0]), std::max(drawn.bottom, scissor[1]),
             std::min(drawn.right, scissor[0] + scissor[2]),
             std::min(drawn.top, scissor[1] + scissor[3])};
  }
  SoGetBoundingBoxAction bounds(SoViewportRegionElement::get(state));
  bounds.apply(const_cast<SoShadeOnce*>(this));
  const SbBox3f box = bounds.getBoundingBox();
  if (box.isEmpty()) return {};
  SbMatrix toClip = SoModelMatrixElement::get(state);
  toClip.multRight(SoViewingMatrixElement::get(state));
  toClip.multRight(SoProjectionMatrixElement::get(state));
  SbVec2f low(1e9f, 1e9f), high(-1e9f, -1e9f);
  for (int corner = 0; corner < 8; ++corner) {
    const SbVec3f &a = box.getMin(), &b = box.getMax();
    const SbVec4f p((corner & 1 ? b : a)[0], (corner & 2 ? b : a)[1], (corner & 4 ? b : a)[2], 1);
    SbVec4f clip;
    toClip.multVecMatrix(p, clip);
    if (clip[3] < 1e-6f) return drawn;  // extends behind the eye
    for (int i = 0; i < 2; ++i) {
      const float place = std::clamp(clip[i] / clip[3], -2.0f, 2.0f);
      low[i] = std::min(low[i], place), high[i] = std::max(high[i], place);
    }
  }
  const auto pixel = [&](float place, int axis) {
    return float(view[axis]) + 0.5f * (place + 1) * float(view[2 + axis]);
  };
  return {std::max(drawn.left, int(std::floor(pixel(low[0], 0))) - 1),
          std::max(drawn.bottom, int(std::floor(pixel(low[1], 1))) - 1),
          std::min(drawn.right, int(std::ceil(pixel(high[0], 0))) + 1),
          std::min(drawn.top, int(std::ceil(pixel(high[1], 1))) + 1)};
}

void SoShadeOnce::GLRender(SoGLRenderAction* action) {
  SoState* state = action->getState();
  const GLuint depths = SoGLShaderProgramElement::get(state) ? singleDepths() : 0;
  if (depths != 0) {
    SoGLCacheContextElement::shouldAutoCache(state, SoGLCacheContextElement::DONT_AUTO_CACHE);
    const auto context = std::uint32_t(SoGLCacheContextElement::get(state));
    if (gather(action, contexts_[context], depths)) return;
  }
  SoGroup::GLRender(action);
}

bool SoShadeOnce::gather(SoGLRenderAction* action, ContextTextures& textures, unsigned depths) {
  const PixelRect part = pixels(action);
  if (part.empty()) return true;
  GLint target = 0, view[4];
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  glGetIntegerv(GL_VIEWPORT, view);
  // Not GL_COLOR_BUFFER_BIT: the children's material may switch blending, and Coin remembers that.
  glPushAttrib(GL_SCISSOR_BIT | GL_STENCIL_BUFFER_BIT);
  GLfloat clear[4];
  glGetFloatv(GL_COLOR_CLEAR_VALUE, clear);
  textures.make(view[0] + view[2], view[1] + view[3]);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, textures.framebuffer);
  const auto attach = [](GLuint name) {
    glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                              name);
  };
  attach(depths);
  const bool works = textures.hasPrograms() &&
                     glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  if (works) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(part.left, part.bottom, part.right - part.left, part.top - part.bottom);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glClearColor(clear[0], clear[1], clear[2], clear[3]);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, kPlain, ~0u);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    action->getState()->push();
    gathering_->GLRender(action);
    SoGroup::GLRender(action);
    action->getState()->pop();
  }
  attach(0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(target));
  if (works) {
    shade(action, textures);
    ++pictures_;
  }
  glPopAttrib();
  return works;
}

// Shades the pixels whose stencil value gather() has set.
void SoShadeOnce::shade(SoGLRenderAction* action, ContextTextures& textures) {
  const auto context = std::uint32_t(SoGLCacheContextElement::get(action->getState()));
  GLint before = 0, unit = 0, view[4];
  glGetIntegerv(GL_VIEWPORT, view);
  // Coin caches OpenGL's state: everything is restored.
  glGetIntegerv(GL_CURRENT_PROGRAM, &before);
  glGetIntegerv(GL_ACTIVE_TEXTURE, &unit);
  glPushAttrib(GL_ENABLE_BIT | GL_DEPTH_BUFFER_BIT | GL_TEXTURE_BIT | GL_POLYGON_BIT);
  for (const int t : {0, 1}) {
    glActiveTexture(GLenum(GL_TEXTURE0 + (t == 0 ? kPlacesUnit : kBendsUnit)));
    glBindTexture(GL_TEXTURE_2D, textures.textures[t]);
  }
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  const auto cover = [&](GLuint program, int stencil) {
    glUseProgram(program);
    const auto at = [&](const char* name) { return glGetUniformLocation(program, name); };
    glUniform1i(at("places"), kPlacesUnit);
    glUniform1i(at("bends"), kBendsUnit);
    glUniform1i(at("lampShadow"), kLampShadowUnit);
    glUniform1i(at("shadowGrid"), kShadowGridUnit);
    glUniform2f(at("texel"), 1.0f / float(textures.width), 1.0f / float(textures.height));
    glUniform4f(at("viewport"), float(view[0]), float(view[1]), float(view[2]), float(view[3]));
    for (int i = 0; i < getNumChildren(); ++i)
      if (getChild(i)->isOfType(SoOrganShape::getClassTypeId()))
        static_cast<SoOrganShape*>(getChild(i))->bindInside(context, program);
    glStencilFunc(GL_EQUAL, stencil, ~0u);
    glRectf(-1, -1, 1, 1);
  };
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);  // from kPlain to kRich
  cover(textures.mark, kPlain);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  cover(textures.plain, kPlain);
  cover(textures.rich, kRich);
  glPopAttrib();
  glActiveTexture(GLenum(unit));
  glUseProgram(GLuint(before));
}

}  // namespace resect
