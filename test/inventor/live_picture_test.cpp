#include "inventor/picture/live_picture.h"

#include <Inventor/nodes/SoGroup.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <doctest/doctest.h>

#include "geometry/primitives.h"
#include "inventor/gl/SoOrganShape.h"
#include "inventor/scene/model_nodes.h"
#include "inventor/scene/operating_room.h"

using namespace resect;

namespace {

constexpr int kLiveWidth = 480, kLiveHeight = 270;
using Pixels = std::vector<std::uint32_t>;  // rows from above

// A ball on a table and a tool beside it, drawn by the processor.
struct LiveScene {
  OperatingRoom room;
  Aabb box{{-0.15, 0, -0.15}, {0.15, 0.14, 0.15}};
  int tool;

  LiveScene() {
    room.setTable(makeModel(boxMesh({{-0.6, -0.02, -0.6}, {0.6, 0, 0.6}})));
    room.setOrgan(sphereMesh({0, 0.07, 0}, 0.07, 24));
    tool = room.addTool(makeModel(boxMesh({{-0.01, -0.01, 0}, {0.01, 0.01, 0.1}})));
    place({-0.12, 0.1, 0});
    room.lightUp(box);
    room.look(RoomView::Surgeon, box, double(kLiveWidth) / kLiveHeight);
  }
  void place(const Vec3& p) { room.setToolPose(tool, {p, Eigen::Quaterniond::Identity()}); }
  Pixels draw(LivePicture& picture, const Damage& damage, double longest = 1e9) {
    picture.setProcessorDraws(true);
    picture.setLongestPicture(longest);
    picture.draw(room.root(), *room.camera(), damage, {kLiveWidth, kLiveHeight});
    return read(picture);
  }
  static Pixels read(LivePicture& picture) {
    Pixels pixels(std::size_t(kLiveWidth) * kLiveHeight);
    picture.read({0, 0, kLiveWidth, kLiveHeight}, pixels.data(), kLiveWidth);
    return pixels;
  }
};

}  // namespace

TEST_CASE("what is drawn again in part is what a picture drawn whole shows, the rest stays") {
  LiveScene scene;
  LivePicture picture, anew;
  const Damage all{true, {}, {}};
  const Pixels before = scene.draw(picture, all);
  CHECK(picture.drawnPixels() == kLiveWidth * kLiveHeight);
  Damage damage{false, {scene.room.toolBounds(scene.tool)}, {}};
  scene.place({0.03, 0.16, -0.02});
  damage.boxes.push_back(scene.room.toolBounds(scene.tool));
  const Pixels after = scene.draw(picture, damage);
  const Pixels whole = scene.draw(anew, all);
  const auto parts = pixelsOf(damage, *scene.room.camera(),
                              SbViewportRegion(short(kLiveWidth), short(kLiveHeight)));
  CHECK(parts.size() > 1);
  CHECK(picture.drawnPixels() == area(parts));
  CHECK(picture.drawnPixels() < kLiveWidth * kLiveHeight / 3);
  int wrong = 0;
  for (int y = 0; y < kLiveHeight; ++y)
    for (int x = 0; x < kLiveWidth; ++x) {
      const bool drawn = std::any_of(parts.begin(), parts.end(), [&](const PixelRect& part) {
        const int up = kLiveHeight - 1 - y;
        return x >= part.left && x < part.right && up >= part.bottom && up < part.top;
      });
      const std::size_t at = std::size_t(y) * kLiveWidth + x;
      wrong += after[at] != (drawn ? whole : before)[at];
    }
  CHECK(wrong == 0);
  CHECK(after != before);
}

TEST_CASE("shadows come at latest with the third picture, at once when nothing else has changed") {
  LiveScene scene;
  LivePicture picture;
  scene.draw(picture, {true, {}, {}});
  const Aabb some{{0, 0, 0}, {0.02, 0.02, 0.02}}, shadow{{-0.1, 0, 0.05}, {0.1, 0, 0.15}};
  scene.draw(picture, {false, {}, {shadow}});
  const std::int64_t shadowPixels = picture.drawnPixels();
  CHECK(shadowPixels > 0);
  std::vector<std::int64_t> drawn;
  for (int i = 0; i < 3; ++i) {
    scene.draw(picture, {false, {some}, {shadow}});
    drawn.push_back(picture.drawnPixels());
  }
  CHECK(*std::max_element(drawn.begin(), drawn.end()) > shadowPixels);
  CHECK(std::count_if(drawn.begin(), drawn.end(),
                      [&](std::int64_t n) { return n < shadowPixels; }) == 2);
  scene.draw(picture, {});  // shadows that are late
  scene.draw(picture, {});
  CHECK(picture.drawnPixels() == 0);
}

TEST_CASE(
    "where pictures take too long shadows come more seldom, but every eighth picture has them") {
  LiveScene scene;
  LivePicture picture;
  scene.draw(picture, {true, {}, {}});
  const Aabb some{{0, 0, 0}, {0.02, 0.02, 0.02}}, shadow{{-0.5, 0, -0.5}, {0.5, 0, 0.5}};
  int since = 0, longest = 0;
  for (int i = 0; i < 40; ++i) {
    const Damage damage{false, {some}, {shadow}};
    since = picture.shadowsAreDue(damage) ? 0 : since + 1;
    longest = std::max(longest, since);
    scene.draw(picture, damage, 1e-6);
  }
  CHECK(longest == 7);
}

TEST_CASE("a smooth picture comes in strips, and each can be read by itself") {
  LiveScene scene;
  LivePicture strips, once;
  const Pixels rough = scene.draw(strips, {true, {}, {}});
  scene.draw(once, {true, {}, {}});
  once.drawSmooth(scene.room.root(), 0, 1);
  const Pixels smooth = LiveScene::read(once);
  CHECK(smooth != rough);
  Pixels shown = rough;
  constexpr int kStrips = 7;
  for (int strip = 0; strip < kStrips; ++strip) {
    const PixelRect part = strips.drawSmooth(scene.room.root(), strip, kStrips);
    CHECK(part.area() == strips.drawnPixels());
    strips.read(part, &shown[std::size_t(kLiveHeight - part.top) * kLiveWidth + part.left],
                kLiveWidth);
  }
  CHECK(shown == smooth);
  CHECK(LiveScene::read(strips) == smooth);
}

TEST_CASE("a second organ is drawn in its own light when something before it was seen through") {
  LiveScene scene;
  scene.room.addOrgan({0.30f, 0.45f, 0.16f});
  const Vec3 centre(0.05, 0.14, 0.03);
  const TriangleMesh ball = sphereMesh(centre, 0.04, 24);
  std::vector<Vec3f> points, normals;
  for (const Vec3& p : ball.points) {
    points.push_back(p.cast<float>());
    normals.push_back((p - centre).normalized().cast<float>());
  }
  scene.room.organ(1)->update(
      wholeSurface(points, normals, std::vector<float>(points.size(), 0.0f), ball.triangles));
  // Drawn last, as the marker of a tip is: what it leaves behind meets the next picture.
  auto* glass = new SoMaterial;
  glass->transparency = 0.5f;
  auto* room = dynamic_cast<SoGroup*>(scene.room.root());
  REQUIRE(room);
  room->addChild(glass);
  room->addChild(makeModel(boxMesh({{-0.3, 0, -0.02}, {-0.26, 0.04, 0.02}})));

  const auto front =
      pixelsOf({false, {{{0.04, 0.13, 0.05}, {0.06, 0.15, 0.07}}}, {}}, *scene.room.camera(),
               SbViewportRegion(short(kLiveWidth), short(kLiveHeight)));
  REQUIRE(front.size() == 1);
  const auto green = [&](const Pixels& pixels) {
    double sum = 0;
    for (int y = front[0].bottom; y < front[0].top; ++y)
      for (int x = front[0].left; x < front[0].right; ++x)
        sum += double(pixels[std::size_t(kLiveHeight - 1 - y) * kLiveWidth + std::size_t(x)] >> 8 &
                      255);
    return sum / double(front[0].area());
  };
  LivePicture picture;
  scene.draw(picture, {true, {}, {}});
  picture.drawSmooth(scene.room.root(), 0, 1);
  const double smooth = green(LiveScene::read(picture));
  CHECK(smooth > 60);
  for (int i = 0; i < 3; ++i)
    CHECK(green(scene.draw(picture, {true, {}, {}})) == doctest::Approx(smooth).epsilon(0.02));
}
