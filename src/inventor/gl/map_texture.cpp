#define GL_GLEXT_PROTOTYPES
#include "inventor/gl/map_texture.h"

#include <GL/glext.h>

namespace resect {

void MapTexture::make(GLsizei texels, bool isDepth) {
  size = texels;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, isDepth ? GL_DEPTH_COMPONENT24 : GL_RGBA8, size, size, 0,
               isDepth ? GL_DEPTH_COMPONENT : GL_RGBA, isDepth ? GL_UNSIGNED_INT : GL_UNSIGNED_BYTE,
               nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  // Border: nothing casts there; far depth, unoccluded, height 0.
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

void MapTexture::use() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, size, size);
}

void MapTexture::free() const {
  glDeleteFramebuffers(1, &framebuffer);
  glDeleteTextures(1, &texture);
}

}  // namespace resect
