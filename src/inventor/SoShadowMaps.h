// Which parts of the scene does the surgical lamp reach, and how much of the room does each point
// see?
//
// Draws the casters twice, seen from the lamp and from straight above, into two depth textures, and
// hands them to the shaders of all nodes that follow:
//   texture unit 7, gl_TextureMatrix[7]: eye space -> depth seen from the lamp (hard comparison)
//   texture unit 6, gl_TextureMatrix[6]: eye space -> height map seen from above
//   gl_TextureMatrix[5]: eye space -> world space (rotation and translation)
// Stands after the camera. Redraws only when a caster or a field has changed. Needs
// OpenGL 3.0 or framebuffer objects; two depth textures of resolution^2 per context.
//
// Sources: shadow maps, Williams 1978; percentage-closer filtering, Reeves et al. 1987; the height
// map serves the ambient light as in Evans 2006 and Oat and Sander 2007.
#pragma once

#include <Inventor/fields/SoSFFloat.h>
#include <Inventor/fields/SoSFInt32.h>
#include <Inventor/nodes/SoSubNode.h>
#include <Inventor/fields/SoSFNode.h>
#include <Inventor/fields/SoSFVec3f.h>
#include <Inventor/nodes/SoNode.h>

#include <cstdint>
#include <map>
#include <memory>

class SoGLRenderAction;
class SoOrthographicCamera;
class SoPerspectiveCamera;
class SoSeparator;

namespace resect {

class SoShadowMaps : public SoNode {
  SO_NODE_HEADER(SoShadowMaps);

 public:
  static void initClass();
  SoShadowMaps();

  SoSFNode casters;        // drawn without lights and materials
  SoSFVec3f lampPosition;  // world, m
  SoSFVec3f focus;         // world, m: centre of the region with shadows
  SoSFFloat radius;        // m, > 0: the region is the sphere of this radius round `focus`
  SoSFInt32 resolution;    // texels along each side of both maps, 64 to 4096

  // How often the maps were drawn.
  int redraws() const { return redraws_; }

 protected:
  ~SoShadowMaps() override;
  void GLRender(SoGLRenderAction* action) override;

 private:
  struct Map;
  struct ContextMaps;

  void draw(ContextMaps& maps, std::uint32_t context);
  static void contextDestroyed(std::uint32_t context, void* node);

  std::map<std::uint32_t, std::unique_ptr<ContextMaps>> contexts_;
  SoSeparator* fromLamp_;
  SoSeparator* fromAbove_;
  SoPerspectiveCamera* lamp_;
  SoOrthographicCamera* above_;
  int redraws_ = 0;
};

}  // namespace resect
