// The vessels of an organ (VesselPicture), as textures for shaders (data/shaders/vessels.glsl).
#pragma once

#include <GL/gl.h>

#include <memory>

#include "surface/vessel_picture.h"

namespace resect {

inline constexpr int kVesselBinsUnit = 9, kVesselListUnit = 10;  // texture units

struct VesselTexture {
  GLuint textures[2] = {};                    // VesselPicture::bins and VesselPicture::entries
  float rows[2] = {1, 1};                     // heights of the two textures, texels
  std::shared_ptr<const VesselPicture> sent;  // the vessels that the textures hold

  // Binds the textures, and tells `program` where in the organ the vessels lie. The program must be
  // in use. picture: null if there are no vessels.
  void bind(const std::shared_ptr<const VesselPicture>& picture, GLuint program);
  void free() const;
};

}  // namespace resect
