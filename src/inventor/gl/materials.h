// Shader programs for the materials of the operating room. They are written in GLSL 1.20, in
// data/shaders.
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
  Gather,  // stores for each pixel the inputs of Liver's shading; for SoShadeOnce
  Steel,   // instruments; looks like plastic where the specular colour is dark
  Glove,   // the surgeon's hands and sleeves
  // Walls of vessels that have no tissue round them. The material is for an SoOrganShape with the
  // vertices that operation/blood/vessel_walls.h makes.
  Strand,
  // The drape on the table, and the drapes round the operative field (the opened abdomen).
  Cloth,
  // Tissue of the operative field that never moves. Gut is the material of stomach and bowel.
  Skin,
  Fat,
  Muscle,
  Gut,
  Room,   // the background, on a quad behind everything
  Drop,   // drops of blood, on points
  Smoke,  // smoke, for SoSmoke
  Scope,  // the black mask round a laparoscope's picture, on a quad in front of everything
};

// A new node, with the reference count 0. In the scene it must come before the geometry, and after
// the camera, three spot lights and a SoShadowMaps node. The spot lights are the two lamps and the
// light at the viewer's eye. If a shader does not compile, OffscreenView::render() throws an Error.
SoShaderProgram* makeMaterial(RoomMaterial material);

// A new separator without a render cache. It is meant for contents that change often or that
// shaders draw.
SoSeparator* uncachedSeparator();
// A new separator without a render cache. Its children are the material's shader program, followed
// by `nodes`.
SoSeparator* withMaterial(RoomMaterial material, std::initializer_list<SoNode*> nodes);

// GLSL source. It begins with the version line, and then contains files of data/shaders. parts:
// names of these files. Throws Error if a file cannot be read.
std::string shaderSource(const std::vector<std::string_view>& parts);

}  // namespace resect
