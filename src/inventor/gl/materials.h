// Shader programs (GLSL 1.20, from data/shaders) of the operating room's materials.
#pragma once

#include <string>
#include <string_view>
#include <vector>

class SoShaderProgram;

namespace resect {

enum class RoomMaterial {
  Liver,   // wet capsule, cut parenchyma; for SoOrganShape
  Gather,  // the inputs of Liver's shading for each pixel, for SoShadeOnce
  Steel,   // instruments; plastic where the model's specular colour is dark
  Cloth,   // the drape on the table
  Room,    // background, for the quad of an OperatingRoom
};

// A new node (reference count 0), to be placed before the geometry and after the camera, two spot
// lights and SoShadowMaps. Broken GLSL is reported by OffscreenView::render.
SoShaderProgram* makeMaterial(RoomMaterial material);

// The version line and these files of data/shaders, concatenated. Throws Error if one cannot be
// read.
std::string shaderSource(const std::vector<std::string_view>& parts);

}  // namespace resect
