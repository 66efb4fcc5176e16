#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoFragmentShader.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShaderProgram.h>
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "geometry/primitives.h"
#include "inventor/gl/SoOrganShape.h"
#include "inventor/gl/SoShadowMaps.h"
#include "inventor/gl/materials.h"
#include "inventor/picture/offscreen_view.h"
#include "inventor/scene/model_nodes.h"
#include "inventor/scene/operating_room.h"

using namespace resect;

namespace {

constexpr int kPictureWidth = 320, kPictureHeight = 180;

using Colour = std::array<double, 3>;

// Mean over a square of 2 * half + 1 pixels.
Colour mean(const RgbImage& image, int x, int y, int half = 3) {
  Colour sum{};
  for (int j = y - half; j <= y + half; ++j)
    for (int i = x - half; i <= x + half; ++i)
      for (int c = 0; c < 3; ++c) sum[c] += image.at(i, j)[c];
  for (double& s : sum) s /= (2 * half + 1) * (2 * half + 1);
  return sum;
}

double distance(const Colour& a, const Colour& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double brightness(const Colour& c) { return (c[0] + c[1] + c[2]) / 3; }

// A ball of 7 cm on the table, seen from above: the picture's middle is its top.
struct BallOnTable {
  OperatingRoom room;
  Aabb box{{-0.15, 0, -0.15}, {0.15, 0.14, 0.15}};
  TriangleMesh ball = sphereMesh({0, 0.07, 0}, 0.07, 24);

  BallOnTable() {
    room.setTable(makeModel(boxMesh({{-0.6, -0.02, -0.6}, {0.6, 0, 0.6}})));
    room.setOrgan(ball);
    room.lightUp(box);
    room.look(RoomView::Top, box, double(kPictureWidth) / kPictureHeight);
  }
  void setCut(float share) {
    setCut([&](const Vec3&) { return share; });
  }
  template <typename Share>
  void setCut(const Share& shareAt) {
    std::vector<float> cut;
    for (const Vec3& p : ball.points) cut.push_back(shareAt(p));
    std::vector<Vec3f> points, normals;
    for (const Vec3& p : ball.points) {
      points.push_back(p.cast<float>());
      normals.push_back((p - Vec3(0, 0.07, 0)).normalized().cast<float>());
    }
    room.organ()->update(wholeSurface(points, normals, cut, ball.triangles));
  }
};

}  // namespace

TEST_CASE("the organ is reddish, the table is not, and the corners are not empty") {
  BallOnTable scene;
  OffscreenView view(kPictureWidth, kPictureHeight);
  const RgbImage image = view.render(scene.room.root());
  REQUIRE(image.width == kPictureWidth);
  REQUIRE(image.height == kPictureHeight);
  const Colour organ = mean(image, kPictureWidth / 2, kPictureHeight / 2 + 12);
  CHECK(organ[0] > 60);
  CHECK(organ[0] > 1.8 * organ[1]);
  CHECK(organ[0] > 1.8 * organ[2]);
  const Colour table = mean(image, 20, 20);
  CHECK(brightness(table) > 10);
  CHECK(table[0] < 1.3 * table[1]);
}

TEST_CASE("the more careful a picture is drawn, the nearer it is to one of very many samples") {
  BallOnTable scene;
  const auto drawn = [&](PictureQuality quality) {
    quality.shadowTexels = 1024;  // the shadow is not what is compared
    OffscreenView view(kPictureWidth, kPictureHeight, quality);
    CHECK(view.width() == kPictureWidth);
    return view.render(scene.room.root());
  };
  const RgbImage best = drawn({.samples = 4, .enlarged = 4});
  const auto error = [&](const char* quality) {
    const RgbImage image = drawn(pictureQuality(quality).value());
    REQUIRE(image.pixels.size() == best.pixels.size());
    double sum = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      sum += std::pow(double(image.pixels[i]) - double(best.pixels[i]), 2);
    return std::sqrt(sum / double(image.pixels.size()));
  };
  const double draft = error("draft"), window = error("window"), film = error("film");
  INFO(fmt::format("draft {:.2f}, window {:.2f}, film {:.2f} of 255", draft, window, film));
  CHECK(window < 0.8 * draft);
  CHECK(film < 0.7 * window);
  CHECK_FALSE(pictureQuality("best"));
  CHECK_THROWS_WITH_AS(OffscreenView(5000, 100, pictureQuality("film").value()),
                       doctest::Contains("choose 16 to 4096 each way"), Error);
}

TEST_CASE("cut tissue differs from the capsule at one glance") {
  BallOnTable scene;
  OffscreenView view(kPictureWidth, kPictureHeight);
  scene.setCut(0.0f);
  const Colour capsule =
      mean(view.render(scene.room.root()), kPictureWidth / 2, kPictureHeight / 2 + 12, 6);
  scene.setCut(1.0f);
  const Colour cut =
      mean(view.render(scene.room.root()), kPictureWidth / 2, kPictureHeight / 2 + 12, 6);
  INFO(fmt::format("capsule {} {} {}, cut {} {} {}", capsule[0], capsule[1], capsule[2], cut[0],
                   cut[1], cut[2]));
  // A just noticeable difference is about 3 of 255; ten times that is seen without looking for it.
  CHECK(distance(capsule, cut) > 30);
  // Its structure is seen: it is neither black nor does it glow.
  CHECK(brightness(cut) > 0.75 * brightness(capsule));
  CHECK(brightness(cut) < 1.6 * brightness(capsule));
}

TEST_CASE("the rim of a cut whose lips touch is a thin dark line") {
  BallOnTable scene;
  OffscreenView view(kPictureWidth, kPictureHeight);
  scene.setCut(0.0f);
  const RgbImage whole = view.render(scene.room.root());
  // Along the meridian of the ball in the plane x = 0.
  scene.setCut([](const Vec3& p) { return std::abs(p.x()) < 1e-6 ? -1.0f : 0.0f; });
  const RgbImage line = view.render(scene.room.root());
  int dark = 0, widest = 0;
  for (int y = kPictureHeight / 2 + 10; y < kPictureHeight / 2 + 30; ++y) {
    int here = 0;
    for (int x = kPictureWidth / 2 - 20; x <= kPictureWidth / 2 + 20; ++x)
      here += line.at(x, y)[0] + 12 < whole.at(x, y)[0];
    dark += here > 0;
    widest = std::max(widest, here);
  }
  CHECK(dark >= 15);  // it goes through highlights, too
  CHECK(widest <= 3);
}

TEST_CASE("the organ casts a shadow on the table, away from the lamp") {
  BallOnTable scene;
  OffscreenView view(kPictureWidth, kPictureHeight);
  const RgbImage with = view.render(scene.room.root());
  scene.room.setOrgan({});
  const RgbImage without = view.render(scene.room.root());
  // The lamp hangs at -X: the shadow falls to the right of the ball, whose outline is 27 pixels
  // from the middle.
  const int y = kPictureHeight / 2, shadow = kPictureWidth / 2 + 33,
            light = kPictureWidth / 2 - 100;
  CHECK(brightness(mean(with, shadow, y)) < 0.8 * brightness(mean(without, shadow, y)));
  CHECK(brightness(mean(with, light, y)) ==
        doctest::Approx(brightness(mean(without, light, y))).epsilon(0.08));
}

TEST_CASE("the shadow moves with the lamp") {
  BallOnTable scene;
  OffscreenView view(kPictureWidth, kPictureHeight);
  const RgbImage first = view.render(scene.room.root());
  const int y = kPictureHeight / 2, left = kPictureWidth / 2 - 33, right = kPictureWidth / 2 + 33;
  CHECK(brightness(mean(first, right, y)) < 0.8 * brightness(mean(first, left, y)));
  scene.room.moveLamp(LampPlace::PatientsLeft);
  const RgbImage moved = view.render(scene.room.root());
  CHECK(brightness(mean(moved, left, y)) < 0.8 * brightness(mean(moved, right, y)));
  for (const LampPlace place : {LampPlace::Surgeon, LampPlace::Above}) {
    scene.room.moveLamp(place);
    CHECK(view.render(scene.room.root()).pixels != moved.pixels);
  }
  scene.room.moveLamp(LampPlace::PatientsRight);
  const RgbImage back = view.render(scene.room.root());
  int widest = 0;
  for (std::size_t i = 0; i < first.pixels.size(); ++i)
    widest = std::max(widest, std::abs(int(back.pixels[i]) - int(first.pixels[i])));
  CHECK(widest <= 4);
}

TEST_CASE("the same scene gives the same bytes, again and in a new view") {
  BallOnTable scene;
  OffscreenView view(kPictureWidth, kPictureHeight);
  const RgbImage first = view.render(scene.room.root());
  CHECK(view.render(scene.room.root()).pixels == first.pixels);
  OffscreenView other(kPictureWidth, kPictureHeight);
  CHECK(other.render(scene.room.root()).pixels == first.pixels);
  BallOnTable again;
  CHECK(other.render(again.room.root()).pixels == first.pixels);
}

TEST_CASE("a shader that does not compile is an error, not a flat colour") {
  BallOnTable scene;
  OffscreenView view(64, 64);
  auto* root = new SoSeparator;
  root->ref();
  auto* camera = new SoPerspectiveCamera;
  camera->position.setValue(0, 0, 5);
  root->addChild(camera);
  auto* shader = new SoFragmentShader;
  shader->sourceType = SoShaderObject::GLSL_PROGRAM;
  shader->sourceProgram = "void main() { gl_FragColor = not_a_name; }";
  auto* program = new SoShaderProgram;
  program->shaderObject.set1Value(0, shader);
  root->addChild(program);
  root->addChild(new SoCube);
  CHECK_THROWS_AS(view.render(root), Error);
  root->unref();
  CHECK_NOTHROW(view.render(scene.room.root()));
}

TEST_CASE("every material of the room compiles and differs from the others") {
  OperatingRoom room;
  const Aabb box{{-0.1, 0, -0.1}, {0.1, 0.1, 0.1}};
  room.setTable(makeModel(boxMesh({{-0.5, -0.02, -0.5}, {0.5, 0, 0.5}})));
  room.setToolbox(makeModel(boxMesh({{0.06, 0, -0.05}, {0.12, 0.02, 0.05}})));
  const int tool = room.addTool(makeModel(boxMesh({{-0.01, -0.01, 0}, {0.01, 0.01, 0.1}})));
  room.setToolPose(tool, {Vec3(-0.1, 0.02, -0.05), Eigen::Quaterniond::Identity()});
  room.setOrgan(sphereMesh({0, 0.04, 0}, 0.04));
  room.addTissue(sphereMesh({0, 0.02, 0.08}, 0.02), {0.3f, 0.4f, 0.2f});
  room.lightUp(box);
  OffscreenView view(kPictureWidth, kPictureHeight);
  for (const char* name : {"surgeon", "assistant", "top", "laparoscope"}) {
    const auto named = roomView(name);
    REQUIRE(named);
    room.look(*named, box, double(kPictureWidth) / kPictureHeight);
    CHECK_NOTHROW(view.render(room.root()));
  }
  CHECK(!roomView("ceiling"));
}

TEST_CASE("a tool moves in the picture when its pose does, and back again") {
  BallOnTable scene;
  const int tool = scene.room.addTool(makeModel(boxMesh({{-0.01, -0.01, 0}, {0.01, 0.01, 0.1}})));
  const Pose rest{Vec3(-0.15, 0.02, 0), Eigen::Quaterniond::Identity()};
  const Pose moved{Vec3(-0.12, 0.05, 0), Eigen::Quaterniond::Identity()};
  OffscreenView view(kPictureWidth, kPictureHeight);
  scene.room.setToolPose(tool, rest);
  const RgbImage first = view.render(scene.room.root());
  scene.room.setToolPose(tool, moved);
  CHECK(view.render(scene.room.root()).pixels != first.pixels);
  scene.room.setToolPose(tool, rest);
  CHECK(view.render(scene.room.root()).pixels == first.pixels);
}

TEST_CASE("the camera stands so that the organ fills wide and tall pictures") {
  BallOnTable scene;
  for (const auto& [width, height] : {std::pair(320, 180), std::pair(180, 320)}) {
    scene.room.look(RoomView::Surgeon, bounds(scene.ball), double(width) / height);
    OffscreenView view(width, height);
    const RgbImage image = view.render(scene.room.root());
    int reddish = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) reddish += image.at(x, y)[0] > image.at(x, y)[1] + 20;
    // The sphere round the box is as wide as the picture's narrower side, 180 pixels, and the ball
    // fills a quarter of that square.
    CHECK(reddish > 180 * 180 / 10);
    CHECK(reddish < 180 * 180 / 2);
  }
}

TEST_CASE("pictures of impossible sizes are refused") {
  CHECK_THROWS_AS(OffscreenView(8, 720), Error);
  CHECK_THROWS_AS(OffscreenView(1280, 100000), Error);
}

TEST_CASE("a source file of a shader that is missing is said") {
  CHECK_THROWS_AS(shaderSource({"no_such_file.glsl"}), Error);
  CHECK(shaderSource({"noise.glsl"}).starts_with("#version 120"));
}
