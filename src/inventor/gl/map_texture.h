// A square render target: a texture of depths or of colours, and the framebuffer that renders into
// it. The OpenGL context in which make() was called must be current in all calls.
#pragma once

#include <GL/gl.h>

namespace resect {

struct MapTexture {
  GLuint texture = 0, framebuffer = 0;
  GLsizei size = 0;  // texels along each side

  // Creates the texture and its framebuffer, and binds both. isDepth: whether the texture contains
  // depths; if not, it contains colours.
  void make(GLsizei texels, bool isDepth);
  // Binds the framebuffer, so that OpenGL renders into the texture, and sets the viewport to the
  // whole texture.
  void use() const;
  void free() const;
};

}  // namespace resect
