// Deferred shading parts the organ's pixels in plain and rich tissue; nobody may see the parting.
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>

#include "geometry/primitives.h"
#include "inventor/gl/SoOrganShape.h"
#include "inventor/picture/live_picture.h"
#include "inventor/scene/operating_room.h"
#include "io/data_folder.h"
#include "support/temporary_folder.h"

using namespace resect;

namespace {

constexpr int kShadeWidth = 480, kShadeHeight = 270;
const Vec3 kCentre(0, 0.07, 0);

// A map of texels of 1 cm, that are {255, 0} where the place's x is within [from, to], else 0.
std::shared_ptr<const TissueMap> band(float from, float to) {
  auto map = std::make_shared<TissueMap>();
  map->low = Vec3f(-0.1f, -0.02f, -0.1f);
  map->spacing = Vec3f::Constant(0.01f);
  map->dims = Vec3i(20, 20, 20);
  for (int i = 0; i < map->dims.prod(); ++i) {
    const float x = map->low.x() + map->spacing.x() * float(i % map->dims.x());
    map->texels.insert(map->texels.end(), {std::uint8_t(from <= x && x <= to ? 255 : 0), 0});
  }
  map->box.grow(Vec3(-0.1, 0, -0.1));
  map->box.grow(Vec3(0.1, 0.14, 0.1));
  return map;
}

// A ball that is cut at its near right, bloody at its left, burnt right of the middle, and has a
// tumour at its right end. The rest is plain.
SurfaceUpdate richBall() {
  const TriangleMesh ball = sphereMesh(kCentre, 0.07, 48);
  std::vector<Vec3f> points, normals;
  std::vector<float> cut;
  for (const Vec3& p : ball.points) {
    points.push_back(p.cast<float>());
    normals.push_back((p - kCentre).normalized().cast<float>());
    cut.push_back(p.z() > 0.05 && p.x() > 0 ? 1.0f : 0.0f);
  }
  SurfaceUpdate update = wholeSurface(points, normals, cut, ball.triangles);
  update.blood = band(-0.06f, -0.03f);
  update.heat = band(0.01f, 0.02f);
  update.structures = band(0.05f, 0.07f);
  return update;
}

std::vector<std::uint32_t> drawnPixels(OperatingRoom& room) {
  LivePicture picture;
  picture.setProcessorDraws(true);
  picture.setSharp(true);
  picture.draw(room.root(), *room.camera(), {true, {}, {}}, {kShadeWidth, kShadeHeight});
  std::vector<std::uint32_t> pixels(std::size_t(kShadeWidth) * kShadeHeight);
  picture.read({0, 0, kShadeWidth, kShadeHeight}, pixels.data(), kShadeWidth);
  return pixels;
}

// The data folder with another body of deferred/mark_rich.frag.
class OtherMarks {
 public:
  explicit OtherMarks(const char* body) {
    const std::filesystem::path data = dataFolder();
    std::filesystem::create_directory(folder_ / "scenarios");  // which tells a data folder
    if (const char* named = std::getenv("RESECT_DATA")) before_ = named;
    std::filesystem::copy(data / "shaders", folder_ / "shaders",
                          std::filesystem::copy_options::recursive);
    std::ofstream(folder_ / "shaders" / "deferred" / "mark_rich.frag")
        << "void main() { " << body << " }\n";
    setenv("RESECT_DATA", folder_.path().c_str(), 1);
  }
  ~OtherMarks() {
    before_.empty() ? unsetenv("RESECT_DATA") : setenv("RESECT_DATA", before_.c_str(), 1);
  }

 private:
  test::TemporaryFolder folder_;
  std::string before_;
};

std::int64_t different(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  std::int64_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i];
  return count;
}

}  // namespace

TEST_CASE("tissue that is shaded as plain looks as it would if all of it were shaded as rich") {
  OperatingRoom room;
  room.setOrgan(sphereMesh(kCentre, 0.07, 8));
  room.organ(0)->update(richBall());
  const Aabb box{{-0.1, 0, -0.1}, {0.1, 0.14, 0.1}};
  room.lightUp(box);
  room.look(RoomView::Surgeon, box, double(kShadeWidth) / kShadeHeight);
  const auto parted = drawnPixels(room);
  std::vector<std::uint32_t> allRich, allPlain;
  {
    const OtherMarks marks("gl_FragColor = vec4(1.0);");
    allRich = drawnPixels(room);
  }
  {
    const OtherMarks marks("discard;");
    allPlain = drawnPixels(room);
  }
  CHECK(different(parted, allRich) == 0);
  CHECK(different(parted, allPlain) > 2000);  // cut, blood, heat and tumour
}
