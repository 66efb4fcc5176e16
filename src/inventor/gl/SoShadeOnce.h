// Inventor group with deferred shading: each pixel is shaded once, however many triangles cover it.
//
// A software renderer shades blocks of 4 x 4 pixels, triangle by triangle. Where triangles are as
// small as pixels, it shades each pixel about ten times. This group instead draws its shapes into a
// G-buffer (Saito and Takahashi 1990): a shader program (data/shaders/gather.frag) stores the
// inputs of the liver's shading in two textures. Depths go to the picture's own depth buffer. Then
// a second program (data/shaders/gathered.frag) shades each pixel once.
//
// The group does this if a shader program is in use and the framebuffer is single-sampled and has a
// depth renderbuffer. Otherwise it acts as a plain SoGroup: in antialiased pictures, in shadow maps
// and for picking. On a graphics card all pictures are antialiased, so there it is always a plain
// group. Its children must be shapes with the attributes of SoOrganShape.
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

  int pictures() const { return pictures_; }  // number drawn so far with deferred shading

 protected:
  ~SoShadeOnce() override;
  void GLRender(SoGLRenderAction* action) override;

 private:
  struct ContextTextures;

  bool gather(SoGLRenderAction* action, ContextTextures& textures, unsigned depths);
  PixelRect pixels(SoGLRenderAction* action) const;

  PerContext<ContextTextures> contexts_;
  SoShaderProgram* gathering_;
  int pictures_ = 0;
};

}  // namespace resect
