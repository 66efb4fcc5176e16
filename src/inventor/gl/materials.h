// Shader programs (GLSL 1.20, from data/shaders) of the operating room's materials.
#pragma once

#include <string>
#include <string_view>
#include <vector>

class SoShaderProgram;

namespace resect {

enum class RoomMaterial {
  Liver,   // wet capsule and cut parenchyma, for SoOrganShape
  Gather,  // writes the inputs of Liver's shading for each pixel, for SoShadeOnce
  Steel,   // instruments; plastic where the model's specular colour is dark
  Cloth,   // the drape on the table
  Room,    // background: for the quad that OperatingRoom draws behind everything
};

// A new node (reference count 0). In the scene it must come after the camera, two spot lights and
// SoShadowMaps, and before the geometry. A shader that does not compile is reported by
// OffscreenView::render.
SoShaderProgram* makeMaterial(RoomMaterial material);

// GLSL source: the version line, then these files of data/shaders, concatenated. Throws Error if
// one cannot be read.
std::string shaderSource(const std::vector<std::string_view>& parts);

}  // namespace resect
