// Shadow maps of the surgical lamp, and ambient occlusion of the room's light, for the nodes that
// follow in the scene.
//
// The node draws the shapes under `casters` and `movers` into two depth textures: one as seen from
// the lamp, and one as seen from straight above. From these it computes, for each point of a square
// grid over the table, which shares of the room and of the lamp are visible. Shaders of the nodes
// that follow find the results here:
// - Texture unit 7: depths seen from the lamp, for comparison (shadow2D). gl_TextureMatrix[7] leads
//   from eye space to the coordinates and the depth in this texture.
// - Texture unit 6: depths seen from above. gl_TextureMatrix[6] leads from eye space to x and y,
//   the coordinates in the textures of units 6 and 5, and z, the depth from above.
// - Texture unit 5: the grid. Red: share of the room seen from the table plane y = 0. Green: share
//   of the lamp seen from this plane. Blue: share of the room seen from the topmost surface. Alpha:
//   height of the topmost surface over the table, as a fraction of `radius`.
// - gl_TextureMatrix[5] leads from eye space to world space (rotation and translation).
//
// In the scene this node must come after the camera. It redraws the textures only if a caster, a
// mover or a field has changed, and then only the part given to changedIn(). Separate depth maps
// hold the casters alone; for a redraw, the movers are drawn over a copy of these maps.
//
// Sources: shadow maps, Williams 1978; percentage-closer soft shadows, Fernando 2005; occlusion of
// the room's light over a height field, Oat and Sander 2007.
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

  SoSFNode casters;        // shapes that cast shadows; drawn without lights and materials
  SoSFNode movers;         // further such shapes: small ones that move often
  SoSFVec3f lampPosition;  // world, m
  SoSFVec3f focus;         // world, m: centre of the region with shadows
  SoSFFloat radius;        // m, > 0: the region is the sphere of this radius round `focus`
  // Number of texels along each side of the depth maps, 64 to 4096. The grid has 3/16 as many along
  // each side, but at least 16.
  SoSFInt32 resolution;

  // To be called after a change of casters or movers. `box`: contains the change (world, m). An
  // empty box means that the change may be anywhere. If changedIn() was not called since the last
  // drawing, the maps are redrawn as a whole.
  void changedIn(const Aabb& box);

  // hold(true): the maps are not redrawn until hold(false) is called. But if they were never drawn,
  // they are drawn once even then.
  void hold(bool held) { held_ = held; }

  // redraws(): how often the maps were redrawn, in part or as a whole. wholeRedraws(): how often
  // they were redrawn as a whole.
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
