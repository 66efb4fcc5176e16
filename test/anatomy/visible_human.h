// The Visible Human's liver, if present: 16 898 triangles, closed.
#pragma once

#include "support/references/mesh_reference.h"
#include "support/shared_data.h"

namespace resect::test {

// Nothing, and a line "skipped", without the optional data.
inline std::optional<TriangleMesh> visibleHumanLiver() {
  const auto path = sharedData("visible-human-male/VH_M_liver_closed.obj");
  if (!path) return std::nullopt;
  return readPlainObj(path->string());
}

}  // namespace resect::test
