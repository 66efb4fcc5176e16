// Shadow maps of the surgical lamp, and ambient occlusion of the room's light, for the nodes that
// follow in the scene.
//
// Draws the casters twice into depth textures: seen from the lamp, and from straight above. From
// both it computes two kinds of share on a square grid: how much of the room the table plane y = 0
// and the topmost surface see, and how much of the lamp the table plane sees. Shaders of the nodes
// that follow find the results here:
//   texture unit 7: depths seen from the lamp, for comparison (shadow2D). gl_TextureMatrix[7]: eye
//     space -> coordinates in this texture and depth
//   texture unit 6: depths seen from above. gl_TextureMatrix[6]: eye space -> coordinates x, y in
//     the textures of units 6 and 5; z: depth from above
//   texture unit 5: the grid. Red: share of the room seen from the table; green: share of the lamp
//     seen from the table; blue: share of the room seen from the topmost surface; alpha: height of
//     that surface over the table, as a share of `radius`
//   gl_TextureMatrix[5]: eye space -> world space (rotation and translation)
// The node must follow the camera. It redraws only if a caster, a mover or a field has changed, and
// only the part given to changedIn(). The casters are kept in depth maps of their own; the movers
// are drawn over a copy of these.
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

  SoSFNode casters;        // drawn without lights and materials
  SoSFNode movers;         // the same, for small objects that move often
  SoSFVec3f lampPosition;  // world, m
  SoSFVec3f focus;         // world, m: centre of the region with shadows
  SoSFFloat radius;        // m, > 0: the region is the sphere of this radius round `focus`
  // Texels along each side of the depth maps, 64 to 4096; the grid has 3/16 as many, at least 16.
  SoSFInt32 resolution;

  // Call after a change of casters or movers. `box`: contains the change, world, m; an empty box
  // means that it may be anywhere. Without any call the maps are redrawn as a whole.
  void changedIn(const Aabb& box);

  // While held, the maps are not redrawn; only the first drawing is made all the same.
  void hold(bool held) { held_ = held; }

  // How often the maps were drawn, and how often as a whole with all casters.
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
