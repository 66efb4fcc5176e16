// Is an argument that cannot be right refused in one sentence, and nothing done?
#include <doctest/doctest.h>

#include <limits>

#include "support/sentence.h"
#include "wound/severed_edges.h"

using namespace resect;
using test::refuses;

TEST_CASE("edges and faces that the grid does not have are not severed") {
  SeveredEdges severed({2, 2, 2}, 2);
  for (const Vec3i& node : {Vec3i(-1, 0, 0), Vec3i(8, 0, 0), Vec3i(0, 0, 1 << 30)}) {
    CHECK(refuses([&] { severed.sever(node, 0, 0.5, Vec3::UnitX()); }, "no edge or face"));
    CHECK(refuses([&] { severed.trace(node, 0, {}); }, "no edge or face"));
  }
  for (const int axis : {-1, 3}) {
    CHECK(refuses([&] { severed.sever({1, 1, 1}, axis, 0.5, Vec3::UnitX()); }, "no edge or face"));
    CHECK(refuses([&] { severed.trace({1, 1, 1}, axis, {}); }, "no edge or face"));
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK(refuses([&] { severed.sever({1, 1, 1}, 0, none, Vec3::UnitX()); }, "no share"));
  CHECK(severed.empty());
  CHECK(severed.update().empty());
}
