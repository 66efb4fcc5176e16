#include "inventor/gl/SoShadowMaps.h"

#include <doctest/doctest.h>

#include "geometry/primitives.h"
#include "inventor/gl/SoOrganShape.h"
#include "inventor/picture/offscreen_view.h"
#include "inventor/scene/model_nodes.h"
#include "inventor/scene/operating_room.h"

using namespace resect;

namespace {

// A ball on a table, a tool over it.
struct ShadowScene {
  OperatingRoom room;
  Aabb box{{-0.15, 0, -0.15}, {0.15, 0.14, 0.15}};
  std::vector<Vec3f> points, normals;
  TriangleMesh ball = sphereMesh({0, 0.07, 0}, 0.07, 24);
  int tool;

  ShadowScene() {
    room.setTable(makeModel(boxMesh({{-0.6, -0.02, -0.6}, {0.6, 0, 0.6}})));
    room.setOrgan(ball);
    for (const Vec3& p : ball.points) {
      points.push_back(p.cast<float>());
      normals.push_back((p - Vec3(0, 0.07, 0)).normalized().cast<float>());
    }
    tool = room.addTool(makeModel(boxMesh({{-0.01, -0.01, 0}, {0.01, 0.01, 0.1}})));
    room.setToolPose(tool, {Vec3(-0.12, 0.15, 0), Eigen::Quaterniond::Identity()});
    room.lightUp(box);
    room.look(RoomView::Surgeon, box, 16.0 / 9);
    room.organ()->takeChanged();
  }
  void moveTool() {
    room.setToolPose(tool, {Vec3(0.02, 0.17, -0.06), Eigen::Quaterniond::Identity()});
  }
  // A dent, and the triangles of its middle gone.
  void dent() {
    const IndexRange dented{60, 80}, gone{20, 40};
    std::vector<Vec3f> now = points;
    for (int v = dented.first; v < dented.first + dented.count; ++v)
      now[std::size_t(v)] -= Vec3f(0, 0.03f, 0);
    SurfaceUpdate update;
    addNewVertices(update, dented, now, std::vector<float>(now.size(), 1.0f));
    addMovedVertices(update, dented, now, normals);
    addNewTriangles(update, gone, std::vector<Triangle>(ball.triangles.size(), Triangle{0, 0, 0}));
    room.organ()->update(update);
  }
};

}  // namespace

TEST_CASE("shadows drawn anew where a tool was and is are those drawn anew everywhere") {
  OffscreenView view(480, 270, 1);
  ShadowScene told, untold;
  const RgbImage before = view.render(told.room.root());
  CHECK(view.render(untold.room.root()).pixels == before.pixels);
  told.room.changedIn(told.room.toolBounds(told.tool));
  told.moveTool();
  told.room.changedIn(told.room.toolBounds(told.tool));
  untold.moveTool();
  const RgbImage after = view.render(told.room.root());
  CHECK(after.pixels != before.pixels);
  CHECK(view.render(untold.room.root()).pixels == after.pixels);
  CHECK(told.room.shadows().redraws() == 2);
  CHECK(told.room.shadows().wholeRedraws() == 1);
  CHECK(untold.room.shadows().wholeRedraws() == 2);
}

TEST_CASE("shadows drawn anew where the organ has changed are those drawn anew everywhere") {
  OffscreenView view(480, 270, 1);
  ShadowScene told, untold;
  const RgbImage before = view.render(told.room.root());
  view.render(untold.room.root());
  told.dent();
  Aabb changed;
  for (const Aabb& part : told.room.organ()->takeChanged()) changed.grow(part);
  CHECK(changed.max.y() - changed.min.y() > 0.03);
  CHECK(changed.max.x() - changed.min.x() < 0.14);
  told.room.changedIn(changed);
  untold.dent();
  const RgbImage after = view.render(told.room.root());
  CHECK(after.pixels != before.pixels);
  CHECK(view.render(untold.room.root()).pixels == after.pixels);
  CHECK(told.room.shadows().wholeRedraws() == 1);
  CHECK(told.room.organ()->takeChanged().empty());
}
