#include "inventor/materials.h"

#include <Inventor/nodes/SoFragmentShader.h>
#include <Inventor/nodes/SoShaderParameter.h>
#include <Inventor/nodes/SoShaderProgram.h>
#include <Inventor/nodes/SoVertexShader.h>

#include <string>
#include <string_view>

#include "base/assert.h"

namespace resect {

std::string_view shaderText(std::string_view name);  // embedded by CMake

namespace {

struct Stages {
  std::string_view vertex, fragment;
};

Stages stages(RoomMaterial material) {
  switch (material) {
    case RoomMaterial::Liver: return {"organ.vert", "liver.frag"};
    case RoomMaterial::Steel: return {"surface.vert", "steel.frag"};
    case RoomMaterial::Cloth: return {"surface.vert", "cloth.frag"};
    case RoomMaterial::Room: return {"room.vert", "room.frag"};
  }
  RESECT_ASSERT(false);
  return {};
}

void setSource(SoShaderObject* shader, std::initializer_list<std::string_view> parts) {
  std::string source = "#version 120\n";
  for (const std::string_view part : parts) {
    RESECT_ASSERT(!shaderText(part).empty());
    source += shaderText(part);
  }
  shader->sourceType = SoShaderObject::GLSL_PROGRAM;
  shader->sourceProgram = source.c_str();
}

}  // namespace

SoShaderProgram* makeMaterial(RoomMaterial material) {
  auto* vertex = new SoVertexShader;
  setSource(vertex, {stages(material).vertex});
  auto* fragment = new SoFragmentShader;
  setSource(fragment, {"light.glsl", "noise.glsl", stages(material).fragment});
  // The texture units of SoShadowMaps.
  const auto sampler = [&](const char* name, int unit) {
    auto* parameter = new SoShaderParameter1i;
    parameter->name = name;
    parameter->value = unit;
    fragment->parameter.set1Value(fragment->parameter.getNum(), parameter);
  };
  sampler("lampShadow", 7);
  sampler("heightMap", 6);

  auto* program = new SoShaderProgram;
  program->shaderObject.set1Value(0, vertex);
  program->shaderObject.set1Value(1, fragment);
  return program;
}

}  // namespace resect
