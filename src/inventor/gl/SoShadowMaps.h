// Shadow maps of the surgical lamp, and ambient occlusion of the room's light. They serve the nodes
// that come after this node in the scene.
//
// This node draws the shapes under its fields `casters` and `movers` into two depth textures. One
// texture shows the shapes as seen from the lamp, the other as seen from straight above. From these
// textures the node computes, for each point of a square grid over the table, which fraction of the
// room and which fraction of the lamp can be seen from the point. The shaders of later nodes find
// the results here:
// - Texture unit 7: the depths as seen from the lamp. Shaders compare depths with this texture by
//   shadow2D. gl_TextureMatrix[7] converts eye space to the coordinates and the depth in this
//   texture.
// - Texture unit 6: the depths as seen from above. gl_TextureMatrix[6] converts eye space to three
//   numbers. The first two, x and y, are the coordinates in the textures of units 6 and 5. The
//   third number, z, is the depth from above.
// - Texture unit 5: the grid. Red: fraction of the room that can be seen from the table plane
//   y = 0. Green: fraction of the lamp that can be seen from the table plane. Blue: fraction of the
//   room that can be seen from the topmost surface. Alpha: height of the topmost surface over the
//   table, divided by `radius`.
// - gl_TextureMatrix[5] converts eye space to world space. It contains a rotation and a
//   translation.
//
// In the scene this node must come after the camera. The node redraws the textures only if a
// caster, a mover or a field has changed. It then redraws only the part that was passed to
// changedIn(). Two more depth maps contain the casters alone. In each redraw, these maps are
// copied, and the movers are drawn over the copies. So the casters are drawn again only if a caster
// has changed or if the maps are redrawn as a whole.
//
// Sources: Williams 1978 (shadow maps), Fernando 2005 (percentage-closer soft shadows), Oat and
// Sander 2007 (occlusion of the room's light over a height field).
#pragma once

#include <Inventor/fields/SoSFFloat.h>
#include <Inventor/fields/SoSFInt32.h>
#include <Inventor/fields/SoSFNode.h>
#include <Inventor/fields/SoSFVec3f.h>
#include <Inventor/nodes/SoNode.h>
#include <Inventor/nodes/SoSubNode.h>

#include <cstdint>

#include "geometry/aabb.h"
#include "inventor/gl/damage.h"
#include "inventor/gl/per_context.h"

class SoGLRenderAction;
class SoOrthographicCamera;
class SoPerspectiveCamera;
class SoSeparator;

namespace resect {

constexpr int kLampShadowUnit = 7, kShadowGridUnit = 5;  // texture units

class SoShadowMaps : public SoNode {
  SO_NODE_HEADER(SoShadowMaps);

 public:
  static void initClass();
  SoShadowMaps();

  SoSFNode casters;        // shapes that cast shadows
  SoSFNode movers;         // other shapes that cast shadows: small, and often moved
  SoSFVec3f lampPosition;  // world, m
  SoSFVec3f focus;         // centre of the sphere in which there are shadows; world, m
  SoSFFloat radius;        // radius of this sphere, m, > 0
  // Number of texels along each side of the depth maps, 64 to 4096. The grid has 3/16 of this
  // number of texels along each side, but at least 16.
  SoSFInt32 resolution;

  // Call this after a change of casters or movers. box: contains the change; world, m. An empty box
  // means that the change may be anywhere. If something has changed but changedIn() was not called
  // since the last drawing, the maps are redrawn as a whole.
  void changedIn(const Aabb& box);

  // After hold(true) the maps are not redrawn until hold(false) is called. Exception: maps that
  // were never drawn are drawn once.
  void hold(bool held) { held_ = held; }

  // redraws() says how often the maps were redrawn, in part or as a whole. wholeRedraws() counts
  // only those redraws in which the maps were redrawn as a whole.
  int redraws() const { return redraws_; }
  int wholeRedraws() const { return wholeRedraws_; }

 protected:
  ~SoShadowMaps() override;
  void GLRender(SoGLRenderAction* action) override;

 private:
  struct ContextMaps;

  void aim();
  void draw(ContextMaps& maps, std::uint32_t context);
  void drawGrid(ContextMaps& maps, const PixelRect& part) const;
  PixelRect gridPart(const Aabb& changed, std::int32_t texels) const;

  PerContext<ContextMaps> contexts_;
  SoSeparator* fromLamp_;
  SoSeparator* fromAbove_;
  SoPerspectiveCamera* lamp_;
  SoOrthographicCamera* above_;
  bool held_ = false;
  int redraws_ = 0, wholeRedraws_ = 0;
};

}  // namespace resect
