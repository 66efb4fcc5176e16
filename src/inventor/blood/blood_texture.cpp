#define GL_GLEXT_PROTOTYPES
#include "inventor/blood/blood_texture.h"

#include <GL/glext.h>

namespace resect {

void BloodTexture::bind(const std::shared_ptr<const BloodMap>& map, GLuint program) {
  const GLint low = glGetUniformLocation(program, "bloodLow");
  if (low < 0) return;  // another material
  const GLint perMetre = glGetUniformLocation(program, "bloodPerMetre"),
              sampler = glGetUniformLocation(program, "bloodMap");
  glUniform1i(sampler, kBloodUnit);
  if (!map) {
    glUniform3f(perMetre, 0, 0, 0);
    return;
  }
  GLint unit = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &unit);
  glActiveTexture(GLenum(GL_TEXTURE0 + kBloodUnit));
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
  glActiveTexture(GLenum(unit));
  // The middles of texels lie half a texel from the texture's sides.
  const Vec3f size = map->spacing * map->dims.cast<float>(),
              corner = map->low - Vec3f::Constant(0.5f * map->spacing);
  glUniform3f(low, corner.x(), corner.y(), corner.z());
  glUniform3f(perMetre, 1 / size.x(), 1 / size.y(), 1 / size.z());
}

void BloodTexture::free() const {
  if (texture) glDeleteTextures(1, &texture);
}

}  // namespace resect
