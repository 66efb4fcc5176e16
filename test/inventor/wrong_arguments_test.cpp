// Is an argument that cannot be right refused in one sentence, and nothing done?
#include <doctest/doctest.h>

#include <limits>

#include "geometry/primitives.h"
#include "inventor/gl/materials.h"
#include "inventor/hand/tool_handling.h"
#include "inventor/init.h"
#include "inventor/scene/model_nodes.h"
#include "inventor/scene/operating_room.h"
#include "support/sentence.h"

using namespace resect;
using test::refuses;

TEST_CASE("tools, organs, views and materials that the room does not have are refused") {
  initInventor();
  OperatingRoom room;
  CHECK(refuses([&] { room.addTool(nullptr); }, "without a model"));
  ToolModel broken;
  broken.mesh = {{Vec3::Zero()}, {{0, 1, 2}}};
  CHECK(refuses([&] { room.addTool(broken); }, "a point beyond"));
  broken.drawn = {{{{Vec3::Zero()}, {{0, 0, 0}}}, {Vec3f::UnitX(), Vec3f::UnitX()}}};
  CHECK(refuses([&] { room.addTool(broken); }, "2 normals for 1 points"));
  ToolHandling hand(room, {});
  for (const int wrong : {-2, -1, 0, 7}) {
    CHECK(refuses([&] { room.toolTransform(wrong); }, "no tool"));
    CHECK(refuses([&] { room.toolModel(wrong); }, "no tool"));
    CHECK(refuses([&] { room.toolBounds(wrong); }, "no tool"));
    CHECK(refuses([&] { room.setToolPose(wrong, {}); }, "no tool"));
    CHECK(refuses([&] { room.setToolSqueeze(wrong, 0.5); }, "no tool"));
    CHECK(refuses([&] { hand.pose(wrong); }, "no tool"));
    CHECK(refuses([&] { hand.take(wrong); }, "no tool"));
  }
  for (const int wrong : {-1, 1}) CHECK(refuses([&] { room.organ(wrong); }, "no organ"));
  CHECK(refuses([&] { hand.hold(3, ToolHandling::Hold::Direct); }, "no tool 3"));
  CHECK(refuses([&] { hand.putBack(3); }, "no tool 3"));
  CHECK(hand.held() == -1);
  const Aabb box{Vec3::Zero(), Vec3::Ones()};
  for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(refuses([&] { room.look(RoomView::Top, box, wrong); }, "width"));
    CHECK(refuses([&] { room.frame(RoomView::Top, box, wrong); }, "width"));
    CHECK(refuses([&] { room.viewAll(box, wrong); }, "width"));
  }
  CHECK(refuses([&] { room.look(RoomView(99), box, 1); }, "no view 99"));
  CHECK(refuses([] { makeMaterial(RoomMaterial(99)); }, "no material 99"));
}
