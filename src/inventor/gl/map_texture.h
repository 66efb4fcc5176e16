// A square render target: a texture of depths or of colours, with its framebuffer. Call its
// functions only while the context in which it was made is current.
#pragma once

#include <GL/gl.h>

namespace resect {

struct MapTexture {
  GLuint texture = 0, framebuffer = 0;
  GLsizei size = 0;  // texels along each side

  // Leaves the texture and the framebuffer bound.
  void make(GLsizei texels, bool isDepth);
  void use() const;  // makes it the render target and sets the viewport to all of it
  void free() const;
};

}  // namespace resect
