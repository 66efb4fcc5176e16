#include "inventor/materials.h"

#include <Inventor/nodes/SoFragmentShader.h>
#include <Inventor/nodes/SoShaderParameter.h>
#include <Inventor/nodes/SoShaderProgram.h>
#include <Inventor/nodes/SoVertexShader.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/assert.h"
#include "base/error.h"
#include "io/data_folder.h"

namespace resect {

namespace {

struct Stages {
  std::string_view vertex, fragment;
};

Stages stages(RoomMaterial material) {
  switch (material) {
    case RoomMaterial::Liver:
      return {"organ.vert", "liver.frag"};
    case RoomMaterial::Steel:
      return {"surface.vert", "steel.frag"};
    case RoomMaterial::Cloth:
      return {"surface.vert", "cloth.frag"};
    case RoomMaterial::Room:
      return {"room.vert", "room.frag"};
  }
  RESECT_ASSERT(false);
  return {};
}

void setSource(SoShaderObject* shader, std::initializer_list<std::string_view> parts) {
  shader->sourceType = SoShaderObject::GLSL_PROGRAM;
  shader->sourceProgram = shaderSource(parts).c_str();
}

}  // namespace

std::string shaderSource(std::initializer_list<std::string_view> parts) {
  std::string source = "#version 120\n";
  for (const std::string_view part : parts) {
    const std::filesystem::path path = dataFolder() / "shaders" / part;
    std::ifstream in(path);
    source.append(std::istreambuf_iterator<char>(in), {});
    if (!in)
      throw error("{} cannot be read; set RESECT_DATA to the data folder of Resect", path.string());
    source += "\n";
  }
  return source;
}

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
  sampler("shadowGrid", 5);

  auto* program = new SoShaderProgram;
  program->shaderObject.set1Value(0, vertex);
  program->shaderObject.set1Value(1, fragment);
  return program;
}

}  // namespace resect
