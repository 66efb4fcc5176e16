// A rod that takes away what it touches: 10 mm across, 0.2 m long, its middle at its pose.
#pragma once

#include <memory>
#include <vector>

#include "geometry/primitives.h"
#include "tools/registry.h"

namespace resect::bench {

inline std::vector<std::unique_ptr<Tool>> rod() {
  ToolModel model;
  model.name = model.kind = "baton";
  model.response = "remove";
  model.mesh = sphereMesh({0, 0, 0}, 1, 12);
  for (Vec3& p : model.mesh.points) p = p.cwiseProduct(Vec3(0.005, 0.005, 0.1));
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(makeTool(std::move(model)));
  return tools;
}

}  // namespace resect::bench
