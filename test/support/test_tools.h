// Instruments for tests, made without files.
#pragma once

#include <memory>
#include <utility>

#include "geometry/primitives.h"
#include "tools/registry.h"

namespace resect::test {

// How a tool stands that is not turned, and where it is far from everything.
inline const Eigen::Quaterniond kUnturned = Eigen::Quaterniond::Identity();
inline const Pose kAway{Vec3(0, 1, 0), kUnturned};

// A tool of that kind; `describe` sets the rest of its model.
template <typename Describe>
std::unique_ptr<Tool> describedTool(const char* kind, TriangleMesh mesh, const Describe& describe) {
  ToolModel model;
  model.name = model.kind = kind;
  model.mesh = std::move(mesh);
  describe(model);
  return makeTool(std::move(model));
}

// A scalpel 0.4 mm thick that cuts without removing, its handle along +Z.
inline std::unique_ptr<Tool> thinScalpel() {
  return describedTool("scalpel", boxMesh({{-0.0002, -0.008, 0}, {0.0002, 0.002, 0.06}}),
                       [](ToolModel& m) {
                         m.edge = {{0, -0.008, 0}, {0, -0.0082, 0.03}, {0, -0.008, 0.06}};
                       });
}

// A box-shaped tool that, as it stands, takes out what it touches: tip at the origin, handle along
// +Z.
inline std::unique_ptr<Tool> boxTool(const Aabb& box, const char* kind = "scalpel",
                                     const char* response = "remove") {
  return describedTool(kind, boxMesh(box), [&](ToolModel& m) { m.response = response; });
}

inline std::unique_ptr<Tool> ballTool(double radius) {
  return describedTool("baton", sphereMesh({0, 0, 0}, radius, 16),
                       [](ToolModel& m) { m.response = "remove"; });
}

}  // namespace resect::test
