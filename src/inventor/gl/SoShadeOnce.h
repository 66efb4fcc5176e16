// Inventor group with deferred shading. Each pixel is shaded only once, even if many triangles
// cover it.
//
// A software renderer shades blocks of 4 x 4 pixels, triangle by triangle. Where triangles are as
// small as pixels, it shades each pixel about ten times. With this group it shades each pixel once,
// in two passes. The first pass draws the shapes into a G-buffer (Saito and Takahashi 1990): a
// shader program (data/shaders/deferred/gather.frag) stores the inputs of the liver's shading in
// two textures. Depths go to the picture's own depth buffer, and the organ's pixels are marked in
// the picture's stencil buffer. In the second pass, data/shaders/deferred/gathered.frag shades each
// marked pixel.
//
// A software renderer also evaluates both sides of each branch in a shader. Therefore two shader
// programs are used. Tissue is rich if it is cut, bloody or heated, or has a structure under the
// skin. The pixels of rich tissue are marked with a value of their own
// (data/shaders/deferred/mark_rich.frag). All other pixels are shaded by a program that does not
// contain the code for rich tissue (data/shaders/deferred/plain.glsl).
//
// The group shades in this way if three conditions hold: a shader program is in use, the
// framebuffer has one sample per pixel, and it has a renderbuffer for depth and stencil. In all
// other cases the group acts as a plain SoGroup. Examples are antialiased pictures, shadow maps and
// picking. On a machine with a graphics card all pictures are antialiased, so the group always acts
// as a plain SoGroup there. The children of the group must be shapes with the attributes of
// SoOrganShape.
#pragma once

#include <Inventor/nodes/SoGroup.h>
#include <Inventor/nodes/SoSubNode.h>

#include "inventor/gl/damage.h"
#include "inventor/gl/per_context.h"

class SoShaderProgram;
class SoState;

namespace resect {

class SoShadeOnce : public SoGroup {
  SO_NODE_HEADER(SoShadeOnce);

 public:
  static void initClass();
  SoShadeOnce();

  // Number of pictures that were drawn with deferred shading so far.
  int pictures() const { return pictures_; }

 protected:
  ~SoShadeOnce() override;
  void GLRender(SoGLRenderAction* action) override;

 private:
  struct ContextTextures;

  bool gather(SoGLRenderAction* action, ContextTextures& textures, unsigned depths);
  void shade(SoGLRenderAction* action, ContextTextures& textures);
  PixelRect pixels(SoGLRenderAction* action) const;

  PerContext<ContextTextures> contexts_;
  SoShaderProgram* gathering_;
  int pictures_ = 0;
};

}  // namespace resect
