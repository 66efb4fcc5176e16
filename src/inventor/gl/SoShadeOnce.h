// How is an organ of many tiny triangles drawn at the cost of its pixels?
//
// A processor shades 4 x 4 pixels at a time, triangle by triangle: where triangles are as small as
// pixels each pixel is worked out some ten times over. This group draws its shapes with a program
// that only writes down what the liver's shading must know of each pixel
// (data/shaders/gather.frag), into two textures and the picture's own depths, and then shades each
// pixel once (data/shaders/gathered.frag). So G-buffers work (Saito and Takahashi 1990).
//
// It does so where a program is in use and a pixel is one sample in a framebuffer with a
// renderbuffer of depths; elsewhere, as for smooth pictures and on graphics cards, for shadow maps
// and picking, it is a plain group. Its children must be shapes, with OrganShape's attributes.
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

  int pictures() const { return pictures_; }  // shaded once each

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
