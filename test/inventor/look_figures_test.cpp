// The look of the liver in figures, on rendered pictures of whole scenarios, beside those of a
// photograph of a real one (docs/look.md).
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/rotation.h"
#include "inventor/gl/SoOrganShape.h"
#include "inventor/gl/camera_moves.h"
#include "inventor/picture/offscreen_view.h"
#include "inventor/reading/model_file.h"
#include "inventor/scene/operation_view.h"
#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/scenario/scenario_file.h"

using namespace resect;

namespace {

constexpr int kFigureWidth = 960, kFigureHeight = 540;

double luminance(const std::uint8_t* rgb) {
  return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

// Which pixels show an organ: every second one of every second row is asked for, or one by one.
class OrganPixels {
 public:
  explicit OrganPixels(OperatingRoom& room)
      : room_(room),
        volume_(viewVolumeOf(*room.camera(), SbViewportRegion(kFigureWidth, kFigureHeight))) {}

  bool shows(int x, int y) const {
    SbVec3f from, towards;
    volume_.projectPointToLine(SbVec2f((x + 0.5f) / kFigureWidth, 1 - (y + 0.5f) / kFigureHeight),
                               from, towards);
    const Vec3 origin(from[0], from[1], from[2]);
    const Ray ray{origin, (Vec3(towards[0], towards[1], towards[2]) - origin).normalized()};
    for (int o = 0; o < room_.organCount(); ++o)
      if (room_.organ(o)->firstPointOn(ray)) return true;
    return false;
  }

 private:
  OperatingRoom& room_;
  SbViewVolume volume_;
};

struct Figures {
  double redGreen = 0, greenBlue = 0;
  double bright = 0;      // share of the organ's pixels with a luminance above 180
  double shade = 0;       // luminance that 5 % stay below, by that which 50 % stay below
  double smallSpots = 1;  // share of the connected bright spots that are smaller than 40 mm^2
};

// Pixels of each group of neighbours.
std::vector<int> spotsOf(std::vector<char> bright) {
  std::vector<int> sizes;
  for (int start = 0; start < kFigureWidth * kFigureHeight; ++start) {
    if (!bright[std::size_t(start)]) continue;
    std::vector<int> open{start};
    bright[std::size_t(start)] = 0;
    int size = 0;
    while (!open.empty()) {
      const int at = open.back(), x = at % kFigureWidth, y = at / kFigureWidth;
      open.pop_back();
      ++size;
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, kFigureHeight - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, kFigureWidth - 1); ++i)
          if (char& next = bright[std::size_t(j * kFigureWidth + i)]; next) {
            next = 0;
            open.push_back(j * kFigureWidth + i);
          }
    }
    sizes.push_back(size);
  }
  return sizes;
}

Figures figuresOf(const RgbImage& image, OperatingRoom& room) {
  const OrganPixels organ(room);
  double sum[3] = {};
  std::vector<double> lights;
  std::vector<char> bright(std::size_t(kFigureWidth * kFigureHeight), 0);
  std::size_t brightPixels = 0;
  for (int y = 0; y < kFigureHeight; ++y)
    for (int x = 0; x < kFigureWidth; ++x) {
      const std::uint8_t* rgb = image.at(x, y);
      const double light = luminance(rgb);
      const bool sampled = x % 3 == 1 && y % 3 == 1;
      if ((!sampled && light <= 180) || !organ.shows(x, y)) continue;
      if (light > 180) ++brightPixels, bright[std::size_t(y * kFigureWidth + x)] = 1;
      if (!sampled) continue;
      lights.push_back(light);
      for (int c = 0; c < 3; ++c) sum[c] += rgb[c];
    }
  REQUIRE(lights.size() > 2000);
  std::ranges::sort(lights);
  const SoPerspectiveCamera& camera = *room.camera();
  const double pixel = 2000 * camera.focalDistance.getValue() *
                       std::tan(0.5 * camera.heightAngle.getValue()) / kFigureHeight;  // mm
  const std::vector<int> spots = spotsOf(bright);
  Figures found;
  found.redGreen = sum[0] / sum[1];
  found.greenBlue = sum[1] / sum[2];
  found.bright = double(brightPixels) / (9.0 * double(lights.size()));
  found.shade = lights[lights.size() / 20] / lights[lights.size() / 2];
  if (!spots.empty())
    found.smallSpots =
        double(std::ranges::count_if(spots, [&](int n) { return n * pixel * pixel < 40; })) /
        double(spots.size());
  return found;
}

// At `share` of the scenario, with the instruments out of the picture.
Figures figuresAt(const std::string& name, double share, const std::string& setting,
                  double turned = 0) {
  Scenario scenario = readScenario(findDataFile(name, "scenarios", ".toml"));
  scenario.setting = setting;
  scenario.toolBox = false;
  scenario.organs[0].source.vessels.clear();  // the figures are those of tissue, not of blood
  if (turned != 0) {
    OrganSource& source = scenario.organs[0].source;
    source.pose.rotation = rotationAbout(Vec3::UnitY(), turned) * source.pose.rotation;
    scenario.closeUp.reset();
  }
  Simulation simulation = makeSimulation(scenario, &readModel);
  OperationView view(scenario, simulation, double(kFigureWidth) / kFigureHeight);
  const auto last = std::int64_t(share * scenario.duration * scenario.frameRate);
  StepReport report;
  while (simulation.frame() < last)
    simulation.step(frameInput(scenario, simulation.frame()), report);
  view.follow(simulation);
  for (int t = 0; t < view.room().toolCount(); ++t)
    view.room().setToolPose(t, {Vec3(0, 5, 0), Eigen::Quaterniond::Identity()});
  view.room().changedIn({});
  OffscreenView screen(kFigureWidth, kFigureHeight);
  const RgbImage image = view.draw(screen);
  return figuresOf(image, view.room());
}

}  // namespace

// Goals: red / green and green / blue as on the photograph (2.20 to 2.34, 1.16 to 1.28), few and
// small highlights (there 0.24 %), and shade that tells the shape.
TEST_CASE("the liver has the colours, the highlights and the shade of a real one") {
  struct Row {
    const char* name;
    double share;  // of the scenario's duration
    const char* setting;
    double turned;  // rad about the vertical
  };
  for (const Row& row : {Row{"incise", 0.1, "field", 0}, Row{"incise", 0.1, "table", 0},
                         Row{"incise", 0.1, "field", 0.7}, Row{"lift", 0.6, "field", 0},
                         Row{"incise-under-traction", 1, "field", 0},
                         Row{"resect-segment-elastic", 1, "field", 0}}) {
    const Figures f = figuresAt(row.name, row.share, row.setting, row.turned);
    const std::string told = fmt::format(
        "{} in {}, turned {}: red/green {:.2f}, green/blue {:.2f}, bright {:.2f} %, 5 %/50 % "
        "{:.2f}, "
        "small spots {:.2f}",
        row.name, row.setting, row.turned, f.redGreen, f.greenBlue, 100 * f.bright, f.shade,
        f.smallSpots);
    MESSAGE(told);
    CHECK(f.redGreen > 2.15);
    CHECK(f.redGreen < 2.40);
    CHECK(f.greenBlue > 1.10);
    CHECK(f.greenBlue < 1.30);
    CHECK(f.bright > 0.001);
    CHECK(f.bright < 0.008);
    CHECK(f.shade < 0.50);
    CHECK(f.smallSpots > 0.9);
  }
}
