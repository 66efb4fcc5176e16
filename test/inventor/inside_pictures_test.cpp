// Pictures of what is inside an organ: vessels on cut faces, and tissue that heat has changed.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "geometry/primitives.h"
#include "inventor/gl/SoOrganShape.h"
#include "inventor/picture/offscreen_view.h"
#include "inventor/scene/operating_room.h"
#include "organ/cell_labels.h"
#include "organ/discretize.h"
#include "organ/picture/picture_structures.h"
#include "organ/picture/picture_vessels.h"

using namespace resect;

namespace {

constexpr int kInsideWidth = 320, kInsideHeight = 180;

// A ball of 7 cm whose surface is cut tissue, seen from above.
struct CutBall {
  OperatingRoom room;
  OffscreenView view{kInsideWidth, kInsideHeight};
  TriangleMesh ball = sphereMesh({0, 0.07, 0}, 0.07, 32);
  std::shared_ptr<const TissueMap> structures;

  CutBall() {
    const Aabb box{{-0.15, 0, -0.15}, {0.15, 0.14, 0.15}};
    room.setOrgan(ball);
    room.lightUp(box);
    room.look(RoomView::Top, box, double(kInsideWidth) / kInsideHeight);
  }
  RgbImage draw(std::shared_ptr<const VesselPicture> vessels, std::shared_ptr<const TissueMap> heat,
                float share = 1) {
    std::vector<Vec3f> points, normals;
    for (const Vec3& p : ball.points) {
      points.push_back(p.cast<float>());
      normals.push_back((p - Vec3(0, 0.07, 0)).normalized().cast<float>());
    }
    SurfaceUpdate update =
        wholeSurface(points, normals, std::vector<float>(points.size(), share), ball.triangles);
    update.vessels = std::move(vessels);
    update.heat = std::move(heat);
    update.structures = structures;
    room.organ()->update(update);
    return view.render(room.root());
  }
};

struct Spot {
  double x = 0, y = 0;  // pixels: middle of what differs
  int pixels = 0;
};

Spot changedSpot(const RgbImage& a, const RgbImage& b) {
  Spot spot;
  for (int y = 0; y < kInsideHeight; ++y)
    for (int x = 0; x < kInsideWidth; ++x) {
      int off = 0;
      for (int c = 0; c < 3; ++c) off += std::abs(int(a.at(x, y)[c]) - int(b.at(x, y)[c]));
      if (off < 30) continue;
      spot.x += x, spot.y += y, ++spot.pixels;
    }
  spot.x /= std::max(1, spot.pixels), spot.y /= std::max(1, spot.pixels);
  return spot;
}

// A vein that comes up through the ball's top at (x, z).
std::shared_ptr<const VesselPicture> vein(double x, double z, double radius) {
  return pictureVessels(
      makeAnatomy({{VesselKind::PortalVein, -1, Vec3(x, 0.05, z), Vec3(x, 0.2, z), radius, true}}));
}

std::array<double, 3> meanOf(const RgbImage& image, int x, int y, int half) {
  std::array<double, 3> sum{};
  for (int j = y - half; j <= y + half; ++j)
    for (int i = x - half; i <= x + half; ++i)
      for (int c = 0; c < 3; ++c) sum[std::size_t(c)] += image.at(i, j)[c];
  for (double& s : sum) s /= (2 * half + 1) * (2 * half + 1);
  return sum;
}

std::shared_ptr<const TissueMap> heated(std::uint8_t coagulated, std::uint8_t charred) {
  auto map = std::make_shared<TissueMap>();
  map->low = Vec3f(-0.1f, -0.02f, -0.1f);
  map->spacing = Vec3f::Constant(0.02f);
  map->dims = Vec3i(12, 12, 12);
  for (int i = 0; i < map->dims.prod(); ++i)
    map->texels.insert(map->texels.end(), {coagulated, charred});
  map->box.grow(Vec3(-0.1, 0, -0.1));
  map->box.grow(Vec3(0.1, 0.14, 0.1));
  return map;
}

}  // namespace

TEST_CASE("a vessel is seen on a cut face where it runs, as wide as it is") {
  CutBall scene;
  // Not the noise of unknown vessels: one far below the surface.
  const auto none = pictureVessels(
      makeAnatomy({{VesselKind::PortalVein, -1, Vec3(0, 0.06, 0), Vec3(0, 0.07, 0), 0.002, true}}));
  const RgbImage plain = scene.draw(none, nullptr);
  const auto spotOf = [&](double x, double z, double radius) {
    return changedSpot(scene.draw(vein(x, z, radius), nullptr), plain);
  };
  const Spot middle = spotOf(0, 0, 0.006), right = spotOf(0.02, 0, 0.006),
             back = spotOf(0, 0.02, 0.006), wide = spotOf(0, 0, 0.012);
  REQUIRE(middle.pixels > 20);
  const double perMetre = (right.x - middle.x) / 0.02;
  CHECK(perMetre > 200);
  CHECK(std::abs(right.y - middle.y) < 1.5);
  CHECK(std::abs(back.x - middle.x) < 1.5);
  CHECK(std::abs(back.y - middle.y) == doctest::Approx(right.x - middle.x).epsilon(0.1));
  const double radius = 0.006 + wallOf(VesselKind::PortalVein, 0.006);
  CHECK(middle.pixels ==
        doctest::Approx(std::numbers::pi * std::pow(radius * perMetre, 2)).epsilon(0.25));
  CHECK(wide.pixels == doctest::Approx(4 * middle.pixels).epsilon(0.25));
  // The lumen is darker than the tissue round it.
  const RgbImage image = scene.draw(vein(0, 0, 0.006), nullptr);
  const auto lumen = meanOf(image, int(middle.x), int(middle.y), 1),
             tissue = meanOf(plain, int(middle.x), int(middle.y), 1);
  CHECK(lumen[0] < 0.7 * tissue[0]);
}

TEST_CASE("a vessel is not seen through the capsule") {
  CutBall scene;
  const RgbImage plain = scene.draw(nullptr, nullptr, 0);
  CHECK(changedSpot(scene.draw(vein(0, 0, 0.006), nullptr, 0), plain).pixels == 0);
}

TEST_CASE("tissue is no longer pale after its coagulation was taken back") {
  CutBall scene;
  const RgbImage live = scene.draw(nullptr, std::make_shared<TissueMap>());
  CHECK(changedSpot(scene.draw(nullptr, heated(255, 0)), live).pixels > 500);
  CHECK(changedSpot(scene.draw(nullptr, std::make_shared<TissueMap>()), live).pixels == 0);
}

TEST_CASE("coagulated tissue is pale and less red, charred tissue is black") {
  CutBall scene;
  for (const float share : {0.0f, 1.0f}) {
    const int x = kInsideWidth / 2, y = kInsideHeight / 2 + 12;
    const auto live = meanOf(scene.draw(nullptr, heated(0, 0), share), x, y, 5),
               pale = meanOf(scene.draw(nullptr, heated(255, 0), share), x, y, 5),
               black = meanOf(scene.draw(nullptr, heated(255, 255), share), x, y, 5);
    CHECK(live[0] / live[1] > 1.7);
    CHECK(pale[0] / pale[1] < 1.5);
    CHECK(pale[1] > 1.2 * live[1]);
    CHECK(black[0] < 0.5 * live[0]);
  }
}

TEST_CASE("a tumour is seen on a cut face where it lies, and shines through the capsule") {
  // The ball as cells of 5 mm; at its top, 2 cm to the right, there is a tumour of 12 mm.
  Discretization cells =
      discretize(sphereMesh({0, 0.07, 0}, 0.07, 32),
                 latticeForSpacing({{-0.07, 0, -0.07}, {0.07, 0.14, 0.07}}, 0.005));
  Region tumour;
  tumour.shape = Region::Shape::Ball;
  tumour.centre = Vec3(0.02, 0.135, 0);
  tumour.radius = 0.012;
  REQUIRE(markCells(cells, 3, tumour) > 20);
  cells.nameLabel(3, "tumour");
  labelSkin(cells);
  CutBall scene;
  const RgbImage cut = scene.draw(nullptr, nullptr), whole = scene.draw(nullptr, nullptr, 0);
  scene.structures = pictureStructures(makeOrgan(std::move(cells), {}));
  const RgbImage cutThrough = scene.draw(nullptr, nullptr);
  const Spot onCut = changedSpot(cutThrough, cut),
             onCapsule = changedSpot(scene.draw(nullptr, nullptr, 0), whole);
  const double middle = kInsideWidth / 2.0;
  REQUIRE(onCut.pixels > 30);
  CHECK(onCut.x > middle + 5);
  CHECK(std::abs(onCut.y - kInsideHeight / 2.0) < 12);
  CHECK(onCapsule.pixels > 10);
  CHECK(onCapsule.x > middle + 5);
  const auto pale = meanOf(cutThrough, int(onCut.x), int(onCut.y), 3),
             tissue = meanOf(cut, int(onCut.x), int(onCut.y), 3);
  CHECK(pale[1] > 1.5 * tissue[1]);
}
