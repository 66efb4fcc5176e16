#define GL_GLEXT_PROTOTYPES
#include "inventor/blood/SoBloodPool.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/elements/SoGLCacheContextElement.h>

#include <cmath>

namespace resect {

struct SoBloodPool::ContextTexture {
  GLuint texture = 0;
  int sent = -1;  // revision in the texture

  void free() const {
    if (texture) glDeleteTextures(1, &texture);
  }
};

SO_NODE_SOURCE(SoBloodPool);

void SoBloodPool::initClass() {
  if (classTypeId != SoType::badType()) return;
  // Not SO_NODE_INIT_CLASS: it would keep the So in the name that files use.
  PRIVATE_COMMON_INIT_CODE(SoBloodPool, "BloodPool", &SoBloodPool::createInstance, SoNode);
}

SoBloodPool::SoBloodPool() {
  SO_NODE_CONSTRUCTOR(SoBloodPool);
  SO_NODE_ADD_FIELD(revision, (0));
}

SoBloodPool::~SoBloodPool() = default;

void SoBloodPool::set(std::vector<std::uint8_t> depths) {
  if (depths == depths_) return;
  depths_ = std::move(depths);
  revision = revision.getValue() + 1;
}

void SoBloodPool::GLRender(SoGLRenderAction* action) {
  SoState* state = action->getState();
  SoGLCacheContextElement::shouldAutoCache(state, SoGLCacheContextElement::DONT_AUTO_CACHE);
  ContextTexture& kept = contexts_[std::uint32_t(SoGLCacheContextElement::get(state))];
  GLint unit = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &unit);
  glActiveTexture(GLenum(GL_TEXTURE0 + kPoolUnit));
  if (kept.texture == 0) glGenTextures(1, &kept.texture);
  glBindTexture(GL_TEXTURE_2D, kept.texture);
  if (kept.sent != revision.getValue()) {
    const std::uint8_t none = 0;
    const auto side = GLsizei(depths_.empty() ? 1 : std::lround(std::sqrt(double(depths_.size()))));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    GLint alignment = 4;
    glGetIntegerv(GL_UNPACK_ALIGNMENT, &alignment);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, side, side, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE,
                 depths_.empty() ? &none : depths_.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
    kept.sent = revision.getValue();
  }
  glActiveTexture(GLenum(unit));
}

}  // namespace resect
