// A map of an organ's tissue as a texture for shaders (data/shaders/blood.glsl).
#pragma once

#include <GL/gl.h>

#include <memory>
#include <string>

#include "surface/tissue_map.h"

namespace resect {

inline constexpr int kBloodUnit = 6, kHeatUnit = 8, kStructureUnit = 11;  // texture units

struct TissueTexture {
  std::string name;  // the shader's uniforms are `name` + "Map", "Low" and "PerMetre"
  int unit = 0;
  GLuint texture = 0;
  std::shared_ptr<const TissueMap> sent;  // the map that the texture holds

  // Binds the texture, and tells `program` where the map lies. map: null if there is nothing to
  // show. The program must be in use.
  void bind(const std::shared_ptr<const TissueMap>& map, GLuint program);
  void free() const;
};

}  // namespace resect
