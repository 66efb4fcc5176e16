// G: an Inventor file of half a million triangles to the first picture of it as an organ, beside
// reading the file's bytes and Coin's own parse, which are part of that.

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/nodes/SoSeparator.h>
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

#include "base/parallel.h"
#include "inventor/init.h"
#include "inventor/picture/offscreen_view.h"
#include "inventor/reading/model_file.h"
#include "inventor/scene/operation_view.h"
#include "io/mesh_file.h"
#include "io/operation_setup.h"
#include "organ/builtin/builtin_liver.h"
#include "peers/one_processor.h"
#include "peers/rows.h"
#include "peers/timing.h"

namespace resect::bench {
namespace {

void parseWithCoin(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string bytes(std::filesystem::file_size(path), '\0');
  in.read(bytes.data(), std::streamsize(bytes.size()));
  SoInput input;
  input.setBuffer(bytes.data(), bytes.size());
  SoSeparator* scene = SoDB::readAll(&input);
  scene->ref();
  scene->unref();
}

// What loading was for, run by run: s, and the last organ's particles.
struct Parts {
  std::vector<double> reading, organ, picture;
  std::int64_t particles = 0;
};

void loadAndDraw(const std::filesystem::path& path, Parts& parts) {
  Scenario scenario;
  scenario.organs[0].source.file = path;
  scenario.organs[0].source.spacing = 0.005;
  std::optional<Simulation> simulation;
  double reading = 0;
  const double both = secondsOf([&] {
    simulation = makeSimulation(scenario, [&](const auto& p, const std::string& parts) {
      Model model;
      reading += secondsOf([&] { model = readModel(p, parts); });
      return model;
    });
  });
  parts.particles = simulation->organ().particles;
  parts.reading.push_back(reading);
  parts.organ.push_back(both - reading);
  parts.picture.push_back(secondsOf([&] {
    // One sample per pixel, as in a window's first picture; smooth edges come after it.
    OffscreenView picture(1280, 720, 1);
    OperationView(scenario, *simulation, 16.0 / 9).draw(picture);
  }));
}

}  // namespace

Findings loadingAgainstCoin(const Effort& effort) {
  initInventor();
  const TriangleMesh liver = builtinLiver(effort.quick ? 0.0025 : 0.00086);
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() /
      fmt::format("resect_peers_{}.iv", std::hash<std::size_t>{}(liver.points.size()));
  writeMeshFile(file, liver);
  Findings findings;
  for (const int threads : threadCounts()) {
    // The child that reads and the renderer's threads, too.
    std::optional<OneProcessor> alone;
    if (threads == 1) alone.emplace();
    const ThreadLimit limit(threads);
    Comparison line;
    line.row = "G";
    line.work = ".iv to the first picture";
    line.peer = "reading the bytes + Coin 4 parsing them";
    line.size = double(liver.triangles.size());
    line.sizeUnit = "triangles";
    line.threads = threads;
    line.goal = 1 / 3.0;
    Parts parts;
    timeBoth([&] { loadAndDraw(file, parts); }, [&] { parseWithCoin(file); }, effort, line);
    line.agreement = fmt::format("{} particles at 5 mm; file of {:.0f} MB", parts.particles,
                                 1e-6 * double(std::filesystem::file_size(file)));
    findings.comparisons.push_back(std::move(line));
    findings.figures.push_back(
        {"G", fmt::format("what it is for, {} thread{}", threads, threads > 1 ? "s" : ""),
         fmt::format("read in a child {:.0f} ms; checked, laid down, made particles {:.0f} ms; "
                     "first picture {:.0f} ms",
                     1e3 * median(parts.reading), 1e3 * median(parts.organ),
                     1e3 * median(parts.picture)),
         ""});
  }
  std::filesystem::remove(file);
  return findings;
}

}  // namespace resect::bench
