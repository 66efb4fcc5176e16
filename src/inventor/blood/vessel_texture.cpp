#define GL_GLEXT_PROTOTYPES
#include "inventor/blood/vessel_texture.h"

#include <GL/glext.h>

#include <algorithm>
#include <vector>

namespace resect {
namespace {

constexpr GLsizei kWidth = 1024;  // texels of a row; also in vessels.glsl

// Sends rows of texels with this number of floats each; the last row is filled up.
float send(std::vector<float> values, int channels, GLint inside, GLenum format) {
  const std::size_t row = std::size_t(kWidth) * std::size_t(channels);
  const std::size_t rows = std::max<std::size_t>(1, (values.size() + row - 1) / row);
  values.resize(rows * row, 0);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, inside, kWidth, GLsizei(rows), 0, format, GL_FLOAT, values.data());
  return float(rows);
}

}  // namespace

void VesselTexture::bind(const std::shared_ptr<const VesselPicture>& picture, GLuint program) {
  const auto at = [&](const char* name) { return glGetUniformLocation(program, name); };
  const GLint bin = at("vesselBin");
  if (bin < 0) return;  // another material
  glUniform1i(at("vesselBins"), kVesselBinsUnit);
  glUniform1i(at("vesselList"), kVesselListUnit);
  glUniform1f(bin, picture ? picture->bin : 0.0f);
  if (!picture) return;
  GLint active = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  const bool fresh = sent != picture;
  if (textures[0] == 0) glGenTextures(2, textures);
  glActiveTexture(GLenum(GL_TEXTURE0 + kVesselBinsUnit));
  glBindTexture(GL_TEXTURE_2D, textures[0]);
  if (fresh) {
    std::vector<float> values;
    for (const auto& b : picture->bins) values.insert(values.end(), b.begin(), b.end());
    rows[0] = send(std::move(values), 2, GL_RG32F, GL_RG);
  }
  glActiveTexture(GLenum(GL_TEXTURE0 + kVesselListUnit));
  glBindTexture(GL_TEXTURE_2D, textures[1]);
  if (fresh) {
    std::vector<float> values;
    for (const auto& e : picture->entries) values.insert(values.end(), e.begin(), e.end());
    rows[1] = send(std::move(values), 4, GL_RGBA32F, GL_RGBA);
    sent = picture;
  }
  glActiveTexture(GLenum(active));
  glUniform3f(at("vesselLow"), picture->low.x(), picture->low.y(), picture->low.z());
  const Vec3f dims = picture->dims.cast<float>();
  glUniform3f(at("vesselDims"), dims.x(), dims.y(), dims.z());
  glUniform2f(at("vesselRows"), rows[0], rows[1]);
}

void VesselTexture::free() const {
  if (textures[0]) glDeleteTextures(2, textures);
}

}  // namespace resect
