#define GL_GLEXT_PROTOTYPES
#include "inventor/blood/tissue_texture.h"

#include <GL/glext.h>

namespace resect {

void TissueTexture::bind(const std::shared_ptr<const TissueMap>& map, GLuint program) {
  const auto at = [&](const char* what) {
    return glGetUniformLocation(program, (name + what).c_str());
  };
  const GLint low = at("Low"), perMetre = at("PerMetre");
  if (low < 0) return;  // another material
  glUniform1i(at("Map"), unit);
  if (!map || map->texels.empty()) {
    glUniform3f(perMetre, 0, 0, 0);
    return;
  }
  GLint active = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  glActiveTexture(GLenum(GL_TEXTURE0 + unit));
  if (texture == 0) glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_3D, texture);
  if (sent != map) {
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
      glTexParameteri(GL_TEXTURE_3D, axis, GL_CLAMP_TO_EDGE);
    GLint alignment = 4;
    glGetIntegerv(GL_UNPACK_ALIGNMENT, &alignment);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_LUMINANCE_ALPHA, map->dims.x(), map->dims.y(), map->dims.z(),
                 0, GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, map->texels.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
    sent = map;
  }
  glActiveTexture(GLenum(active));
  // The middles of texels lie half a texel from the texture's sides.
  const Vec3f size = map->spacing.cwiseProduct(map->dims.cast<float>()),
              corner = map->low - 0.5f * map->spacing;
  glUniform3f(low, corner.x(), corner.y(), corner.z());
  glUniform3f(perMetre, 1 / size.x(), 1 / size.y(), 1 / size.z());
}

void TissueTexture::free() const {
  if (texture) glDeleteTextures(1, &texture);
}

}  // namespace resect
