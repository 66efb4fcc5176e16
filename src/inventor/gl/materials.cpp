#include "inventor/gl/materials.h"

#include <Inventor/nodes/SoFragmentShader.h>
#include <Inventor/nodes/SoShaderParameter.h>
#include <Inventor/nodes/SoShaderProgram.h>
#include <Inventor/nodes/SoVertexShader.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.h"
#include "inventor/blood/SoBloodPool.h"
#include "inventor/gl/SoShadowMaps.h"
#include "io/data_folder.h"

namespace resect {

namespace {

struct Stages {
  std::string_view vertex;
  std::vector<std::string_view> fragment;
};

Stages stages(RoomMaterial material) {
  switch (material) {
    case RoomMaterial::Liver:
      return {"organ.vert",
              {"light.glsl", "noise.glsl", "rim.glsl", "blood.glsl", "vessels.glsl", "liver.glsl",
               "liver.frag"}};
    case RoomMaterial::Gather:
      return {"organ.vert", {"noise.glsl", "rim.glsl", "gather.frag"}};
    case RoomMaterial::Steel:
      return {"surface.vert", {"light.glsl", "noise.glsl", "steel.frag"}};
    case RoomMaterial::Cloth:
      return {"surface.vert", {"light.glsl", "noise.glsl", "cloth.frag"}};
    case RoomMaterial::Room:
      return {"room.vert", {"light.glsl", "noise.glsl", "room.frag"}};
  }
  throw usageError("there is no material {} in the room; use one of RoomMaterial", int(material));
}

void setSource(SoShaderObject* shader, const std::vector<std::string_view>& parts) {
  shader->sourceType = SoShaderObject::GLSL_PROGRAM;
  shader->sourceProgram = shaderSource(parts).c_str();
}

}  // namespace

std::string shaderSource(const std::vector<std::string_view>& parts) {
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
  const Stages files = stages(material);
  auto* vertex = new SoVertexShader;
  setSource(vertex, {files.vertex});
  auto* fragment = new SoFragmentShader;
  setSource(fragment, files.fragment);
  // The texture units of SoShadowMaps.
  const auto sampler = [&](const char* name, int unit) {
    auto* parameter = new SoShaderParameter1i;
    parameter->name = name;
    parameter->value = unit;
    fragment->parameter.set1Value(fragment->parameter.getNum(), parameter);
  };
  if (material != RoomMaterial::Gather) {
    sampler("lampShadow", kLampShadowUnit);
    sampler("shadowGrid", kShadowGridUnit);
    if (material == RoomMaterial::Cloth) sampler("pool", kPoolUnit);
  }

  auto* program = new SoShaderProgram;
  program->shaderObject.set1Value(0, vertex);
  program->shaderObject.set1Value(1, fragment);
  return program;
}

}  // namespace resect
