// The blood on an organ as a texture for shaders (data/shaders/blood.glsl).
#pragma once

#include <GL/gl.h>

#include <memory>

#include "surface/blood_map.h"

namespace resect {

inline constexpr int kBloodUnit = 6;  // texture unit

struct BloodTexture {
  GLuint texture = 0;
  std::shared_ptr<const BloodMap> sent;  // the map in the texture

  // Binds the texture, and tells `program` where the map lies. map: null if there is no blood. The
  // program must be in use.
  void bind(const std::shared_ptr<const BloodMap>& map, GLuint program);
  void free() const;
};

}  // namespace resect
