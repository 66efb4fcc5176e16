// A map of an organ's tissue (TissueMap), as a texture for shaders (data/shaders/blood.glsl).
#pragma once

#include <GL/gl.h>

#include <memory>
#include <string>

#include "surface/tissue_map.h"

namespace resect {

// Texture units of the maps of blood, heat and structures.
inline constexpr int kBloodUnit = 6, kHeatUnit = 8, kStructureUnit = 11;

struct TissueTexture {
  // Beginning of the names of the shader's uniforms. For "blood" the uniforms are bloodMap,
  // bloodLow and bloodPerMetre.
  std::string name;
  int unit = 0;  // texture unit
  GLuint texture = 0;
  std::shared_ptr<const TissueMap> sent;  // the map that the texture holds

  // Binds the texture, and tells `program` where in the organ the map lies. The program must be in
  // use. map: null if there is nothing to show.
  void bind(const std::shared_ptr<const TissueMap>& map, GLuint program);
  void free() const;
};

}  // namespace resect
