// Shader programs for the materials of the operating room (GLSL 1.20, from data/shaders).
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

class SoNode;
class SoSeparator;
class SoShaderProgram;

namespace resect {

enum class RoomMaterial {
  Liver,   // wet capsule and cut parenchyma, for SoOrganShape
  Gather,  // per pixel, the inputs for shading Liver later; for SoShadeOnce
  Steel,   // instruments; drawn as plastic where the specular colour is dark
  Cloth,   // the drape on the table, and the drapes of the operative field
  Skin,    // still tissue of the operative field: skin, fat, muscle, stomach and bowel
  Fat,
  Muscle,
  Gut,
  Room,   // background, on a quad that OperatingRoom draws behind everything
  Drop,   // of blood, on points
  Scope,  // black round a laparoscope's picture, on a quad before everything
};

// A new node (reference count 0). In the scene it must come after the camera, three spot lights
// (two lamps and the one at the eye) and a SoShadowMaps node, and before the geometry. If a shader
// does not compile, OffscreenView::render throws an Error.
SoShaderProgram* makeMaterial(RoomMaterial material);

// A separator that keeps no render cache: its contents change often, or are drawn by shaders.
SoSeparator* uncachedSeparator();
// Such a separator whose children are the material's shader program and then these nodes.
SoSeparator* withMaterial(RoomMaterial material, std::initializer_list<SoNode*> nodes);

// GLSL source: the version line, followed by the given files of data/shaders. parts: their names.
// Throws Error if a file cannot be read.
std::string shaderSource(const std::vector<std::string_view>& parts);

}  // namespace resect
