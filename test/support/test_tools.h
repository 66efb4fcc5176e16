// Instruments for tests, made without files.
#pragma once

#include <memory>

#include "geometry/primitives.h"
#include "tools/registry.h"

namespace resect::test {

// A box-shaped tool that, as it stands, takes out what it touches: tip at the origin, handle along
// +Z.
inline std::unique_ptr<Tool> boxTool(const Aabb& box, const char* kind = "scalpel",
                                     const char* response = "remove") {
  ToolModel model;
  model.name = model.kind = kind;
  model.mesh = boxMesh(box);
  model.response = response;
  return makeTool(std::move(model));
}

inline std::unique_ptr<Tool> ballTool(double radius) {
  ToolModel model;
  model.name = model.kind = "baton";
  model.mesh = sphereMesh({0, 0, 0}, radius, 16);
  model.response = "remove";
  return makeTool(std::move(model));
}

}  // namespace resect::test
