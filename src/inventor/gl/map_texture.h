// A square render target: a texture of depths or of colours, with its framebuffer. Call the
// functions only while the OpenGL context in which make() was called is current.
#pragma once

#include <GL/gl.h>

namespace resect {

struct MapTexture {
  GLuint texture = 0, framebuffer = 0;
  GLsizei size = 0;  // texels along each side

  // Creates the texture (isDepth: of depths; otherwise of colours) and its framebuffer. Both are
  // bound afterwards.
  void make(GLsizei texels, bool isDepth);
  void use() const;  // renders into the texture from now on; sets the viewport to all of it
  void free() const;
};

}  // namespace resect
