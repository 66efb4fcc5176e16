// A square render target: a texture of depths or of colours with its framebuffer. Its functions
// need the context current in which it was made.
#pragma once

#include <GL/gl.h>

namespace resect {

struct MapTexture {
  GLuint texture = 0, framebuffer = 0;
  GLsizei size = 0;  // texels along each side

  // Leaves the texture and the framebuffer bound.
  void make(GLsizei texels, bool isDepth);
  void use() const;  // makes it the render target, with its full size
  void free() const;
};

}  // namespace resect
