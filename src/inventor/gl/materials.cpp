#include "inventor/gl/materials.h"

#include <Inventor/nodes/SoFragmentShader.h>
#include <Inventor/nodes/SoSeparator.h>
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

// Still tissue of the operative field.
Stages scenery(std::string_view kind) {
  return {"surface.vert", {"light.glsl", "noise.glsl", "blood.glsl", "field/scenery.glsl", kind}};
}

Stages stages(RoomMaterial material) {
  switch (material) {
    case RoomMaterial::Liver:
      return {"organ.vert",
              {"light.glsl", "noise.glsl", "rim.glsl", "blood.glsl", "vessels.glsl", "wet.glsl",
               "liver.glsl", "liver.frag"}};
    case RoomMaterial::Gather:
      return {"organ.vert", {"noise.glsl", "rim.glsl", "deferred/gather.frag"}};
    case RoomMaterial::Steel:
      return {"surface.vert", {"light.glsl", "noise.glsl", "steel.frag"}};
    case RoomMaterial::Glove:
      return {"surface.vert", {"light.glsl", "noise.glsl", "glove.frag"}};
    case RoomMaterial::Strand:
      return {"organ.vert", {"light.glsl", "noise.glsl", "blood.glsl", "wet.glsl", "strand.frag"}};
    case RoomMaterial::Cloth:
      return {"surface.vert", {"light.glsl", "noise.glsl", "cloth.frag"}};
    case RoomMaterial::Skin:
      return scenery("field/skin.frag");
    case RoomMaterial::Fat:
      return scenery("field/fat.frag");
    case RoomMaterial::Muscle:
      return scenery("field/muscle.frag");
    case RoomMaterial::Gut:
      return scenery("field/gut.frag");
    case RoomMaterial::Room:
      return {"room.vert", {"light.glsl", "noise.glsl", "room.frag"}};
    case RoomMaterial::Drop:
      return {"drop.vert", {"drop.frag"}};
    case RoomMaterial::Smoke:
      return {"smoke.vert", {"light.glsl", "noise.glsl", "smoke.frag"}};
    case RoomMaterial::Scope:
      return {"scope.vert", {"scope.frag"}};
  }
  throw usageError("there is no material {} in the room; use one of RoomMaterial", int(material));
}

bool isLit(RoomMaterial material) {
  return material != RoomMaterial::Gather && material != RoomMaterial::Drop &&
         material != RoomMaterial::Scope;
}

// Whether blood on the table is drawn on it.
bool showsPool(RoomMaterial material) {
  return material == RoomMaterial::Cloth ||
         (material >= RoomMaterial::Skin && material <= RoomMaterial::Gut);
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
  if (isLit(material)) {
    sampler("lampShadow", kLampShadowUnit);
    sampler("shadowGrid", kShadowGridUnit);
    if (showsPool(material)) sampler("pool", kPoolUnit);
  }

  auto* program = new SoShaderProgram;
  program->shaderObject.set1Value(0, vertex);
  program->shaderObject.set1Value(1, fragment);
  return program;
}

SoSeparator* uncachedSeparator() {
  auto* separator = new SoSeparator;
  separator->renderCaching = SoSeparator::OFF;
  return separator;
}

SoSeparator* withMaterial(RoomMaterial material, std::initializer_list<SoNode*> nodes) {
  SoSeparator* separator = uncachedSeparator();
  separator->addChild(makeMaterial(material));
  for (SoNode* node : nodes) separator->addChild(node);
  return separator;
}

}  // namespace resect
