// How do the surfaces of the operating room look? GLSL 1.20 programs, from data/shaders.
#pragma once

#include <string>
#include <string_view>
#include <vector>

class SoShaderProgram;

namespace resect {

enum class RoomMaterial {
  Liver,   // wet capsule, cut parenchyma; for SoOrganShape
  Gather,  // what Liver must know of each pixel, for SoShadeOnce
  Steel,   // instruments; plastic where the model's specular colour is dark
  Cloth,   // the drape on the table
  Room,    // background, for the quad of an OperatingRoom
};

// A new node (reference count 0) to stand before the geometry, after the camera, two spot lights
// and SoShadowMaps. Broken GLSL is reported by OffscreenView::render.
SoShaderProgram* makeMaterial(RoomMaterial material);

// The version line and these files of data/shaders, one after the other. Throws Error when one
// cannot be read.
std::string shaderSource(const std::vector<std::string_view>& parts);

}  // namespace resect
