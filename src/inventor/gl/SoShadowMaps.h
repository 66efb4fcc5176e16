// Shadow maps of the surgical lamp, and ambient occlusion by the room, for the nodes that follow.
//
// Draws the casters twice, seen from the lamp and from straight above, into two depth textures;
// computes from both, on a square grid, how much of lamp and room the table plane y = 0 and the
// topmost surface see; and passes all to the shaders of the nodes that follow:
//   texture unit 7, gl_TextureMatrix[7]: eye space -> depth seen from the lamp (compared)
//   texture unit 6, gl_TextureMatrix[6]: eye space -> the grid's xy; z: depth from above
//   texture unit 5, the same matrix: share of the room seen from the table (red), share of the lamp
//     seen from the table (green), share of the room seen from the topmost surface (blue), height
//     of that surface over the table as a share of `radius` (alpha)
//   gl_TextureMatrix[5]: eye space -> world space (rotation and translation)
// Must follow the camera. Redraws only if a caster or a field has changed, and only the part given
// to changedIn(): the still casters are kept in depth maps of their own, and the movers are drawn
// over a copy of these.
//
// Sources: shadow maps, Williams 1978; percentage-closer soft shadows, Fernando 2005; the room's
// light over a height field after Oat and Sander 2007.
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
  SoSFInt32
      resolution;  // texels along each side of the depth maps, 64 to 4096; the grid has 3/16 of it

  // All changes of casters and movers since the last drawing are within this box, world, m. An
  // empty box, or a change without a call: anywhere.
  void changedIn(const Aabb& box);

  // While held, the maps are not redrawn.
  void hold(bool held) { held_ = held; }

  // How often the maps were drawn, and how often with all casters.
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
