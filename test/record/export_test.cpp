// What is exported is what the replay shows: surfaces, instruments, samples.
#include <doctest/doctest.h>

#include <assimp/scene.h>
#include <assimp/Importer.hpp>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/error.h"
#include "base/text/printed_time.h"
#include "formats/export/glb_file.h"
#include "formats/meshes/gltf_file.h"
#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"
#include "io/whole_file.h"
#include "record/export/glb_export.h"
#include "record/export/tables.h"
#include "record/export/vtp_export.h"
#include "support/temporary_folder.h"

using namespace resect;
using Json = nlohmann::json;

namespace {

constexpr double kRate = 10;

// Records some seconds of a scenario with coarse cells.
std::filesystem::path recorded(const test::TemporaryFolder& folder, const std::string& name,
                               double seconds) {
  Scenario scenario = readScenario(findDataFile(name, "scenarios", ".toml"));
  if (scenario.organs[0].source.spacing)
    setSpacing(scenario, *scenario.organs[0].source.spacing, 0.012);
  Simulation simulation = makeSimulation(scenario, readPlainMesh);
  const std::filesystem::path path = folder / (name + ".resect");
  Recorder recorder(path, scenario, simulation);
  StepReport report;
  for (int i = 0; i < int(seconds * scenario.frameRate); ++i) {
    const FrameInput input = frameInput(scenario, i);
    simulation.step(input, report);
    recorder.record(input, report, simulation);
  }
  recorder.finish();
  REQUIRE(recorder.failure() == "");
  return path;
}

ExportedPart wholeOf(Replay& replay, double rate) { return {courseOf(replay.file(), 0), rate}; }

// A .glb taken apart.
struct Glb {
  Json json;
  std::string data;

  explicit Glb(const std::string& bytes) {
    const auto number = [&](std::size_t at) {
      std::uint32_t value = 0;
      std::memcpy(&value, bytes.data() + at, 4);
      return std::size_t(value);
    };
    REQUIRE(bytes.substr(0, 4) == "glTF");
    REQUIRE(number(8) == bytes.size());
    const std::size_t length = number(12);
    REQUIRE(bytes.substr(16, 4) == "JSON");
    json = Json::parse(bytes.substr(20, length));
    REQUIRE(bytes.substr(24 + length, 3) == "BIN");
    data = bytes.substr(28 + length);
    REQUIRE(data.size() == number(20 + length));
    REQUIRE(data.size() == json["buffers"][0]["byteLength"]);
  }

  static std::size_t sizeOf(const Json& accessor) {
    const std::map<std::string, std::size_t> parts{{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
    const std::map<int, std::size_t> bytes{{5121, 1}, {5123, 2}, {5125, 4}, {5126, 4}};
    return parts.at(accessor["type"]) * bytes.at(accessor["componentType"]);
  }

  template <typename T>
  std::vector<T> values(const Json& number) const {
    const Json& accessor = json["accessors"].at(number.get<std::size_t>());
    const Json& view = json["bufferViews"].at(accessor["bufferView"].get<std::size_t>());
    const std::size_t count = accessor["count"];
    REQUIRE(sizeOf(accessor) == sizeof(T));
    std::vector<T> values(count);
    std::memcpy(static_cast<void*>(values.data()),
                data.data() + view["byteOffset"].get<std::size_t>(), count * sizeof(T));
    return values;
  }

  std::vector<Triangle> triangles(const Json& number) const {
    const Json& accessor = json["accessors"].at(number.get<std::size_t>());
    std::vector<Triangle> triangles;
    const auto take = [&](const auto& corners) {
      for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
        triangles.push_back(
            {std::int32_t(corners[i]), std::int32_t(corners[i + 1]), std::int32_t(corners[i + 2])});
    };
    if (accessor["componentType"] == 5123)
      take(values<std::uint16_t>(number));
    else
      take(values<std::uint32_t>(number));
    return triangles;
  }

  // The sampler of a node's motion, or null.
  const Json* sampler(std::size_t node, const std::string& path) const {
    for (const Json& animation : json["animations"])
      for (const Json& channel : animation["channels"])
        if (channel["target"]["node"] == node && channel["target"]["path"] == path)
          return &animation["samplers"].at(channel["sampler"].get<std::size_t>());
    return nullptr;
  }

  bool isShown(std::size_t node, float time) const {
    const Json* scale = sampler(node, "scale");
    if (!scale) return !json["nodes"][node].contains("scale");
    REQUIRE((*scale)["interpolation"] == "STEP");
    const auto times = values<float>((*scale)["input"]);
    const auto scales = values<Vec3f>((*scale)["output"]);
    std::size_t k = 0;
    while (k + 1 < times.size() && times[k + 1] <= time) ++k;
    return scales[k] == Vec3f::Ones();
  }

  std::size_t nodeNamed(const std::string& name) const {
    for (std::size_t n = 0; n < json["nodes"].size(); ++n)
      if (json["nodes"][n]["name"] == name) return n;
    FAIL("no node is called " << name);
    return 0;
  }
};

void checkStructure(const Glb& glb) {
  for (const Json& accessor : glb.json["accessors"]) {
    const Json& view = glb.json["bufferViews"].at(accessor["bufferView"].get<std::size_t>());
    const std::size_t offset = view["byteOffset"], length = view["byteLength"];
    CHECK(offset % 4 == 0);
    CHECK(offset + length <= glb.data.size());
    CHECK(accessor["count"].get<std::size_t>() * Glb::sizeOf(accessor) == length);
  }
  for (const Json& mesh : glb.json["meshes"]) {
    const Json& primitive = mesh["primitives"][0];
    const Json& points = primitive["attributes"]["POSITION"];
    const auto count = std::int32_t(glb.values<Vec3f>(points).size());
    const Json& accessor = glb.json["accessors"].at(points.get<std::size_t>());
    Vec3f low = Vec3f::Constant(1e9f), high = -low;
    for (const Vec3f& p : glb.values<Vec3f>(points)) low = low.cwiseMin(p), high = high.cwiseMax(p);
    for (std::size_t a = 0; a < 3; ++a) {
      CHECK(accessor["min"][a].get<float>() == low[int(a)]);
      CHECK(accessor["max"][a].get<float>() == high[int(a)]);
    }
    bool inRange = true;
    for (const Triangle& t : glb.triangles(primitive["indices"]))
      for (const std::int32_t corner : t) inRange = inRange && corner >= 0 && corner < count;
    CHECK(inRange);
    if (primitive["attributes"].contains("NORMAL"))
      for (const Vec3f& n : glb.values<Vec3f>(primitive["attributes"]["NORMAL"]))
        if (std::abs(n.norm() - 1) > 1e-3f) FAIL("a normal of length " << n.norm());
  }
  for (const Json& sampler : glb.json["animations"][0]["samplers"]) {
    const auto times = glb.values<float>(sampler["input"]);
    CHECK(times.front() == 0);
    for (std::size_t k = 1; k < times.size(); ++k) CHECK(times[k] > times[k - 1]);
    CHECK(glb.json["accessors"].at(sampler["output"].get<std::size_t>())["count"] == times.size());
  }
}

// Value of an attribute of XML, from `at` on.
std::string attribute(const std::string& xml, const std::string& name, std::size_t at = 0) {
  const std::size_t begin = xml.find(name + "=\"", at) + name.size() + 2;
  return xml.substr(begin, xml.find('"', begin) - begin);
}

// The appended array of that name in a .vtp.
template <typename T>
std::vector<T> vtpArray(const std::string& file, const std::string& name) {
  const std::size_t line = file.find("Name=\"" + name + "\"");
  REQUIRE(line != std::string::npos);
  const std::size_t at =
      file.find("encoding=\"raw\">\n_") + 17 + std::stoull(attribute(file, "offset", line));
  std::uint64_t size = 0;
  REQUIRE(at + 8 <= file.size());
  std::memcpy(&size, file.data() + at, 8);
  REQUIRE(at + 8 + size <= file.size());
  std::vector<T> values(size / sizeof(T));
  std::memcpy(static_cast<void*>(values.data()), file.data() + at + 8, size);
  return values;
}

}  // namespace

TEST_CASE("an exported .glb shows at each moment the surface and the instruments of the replay") {
  struct Case {
    const char* name;
    double seconds;
  };
  for (const Case& one : {Case{"press", 2}, Case{"resect-segment-elastic", 3}, Case{"snip", 3},
                          Case{"liver-and-gallbladder", 0.5}}) {
    CAPTURE(one.name);
    const test::TemporaryFolder folder;
    Replay replay(recorded(folder, one.name, one.seconds));
    const ExportedPart part = wholeOf(replay, kRate);
    const std::vector<OrganColours> colours(replay.simulation().organs().size());
    const std::filesystem::path path = folder / "run.glb";
    const GlbSummary summary = exportGlb(replay, part, colours, path);
    const std::string bytes = readWholeFile(path);
    CHECK(summary.bytes == bytes.size());
    const Glb glb(bytes);
    checkStructure(glb);

    Replay again(folder / (std::string(one.name) + ".resect"));
    Simulation& simulation = again.simulation();
    const Scenario& scenario = again.setup().scenario;
    std::int64_t moments = 0;
    playMoments(
        again, part, true,
        [&](const Simulation& now) {
          ++moments;
          const auto time = float(double(now.frame()) / scenario.frameRate);
          for (const OperatedOrgan& organ : now.organs()) {
            const auto expected = organ.organ.surface.compact(organ.points(), organ.normals());
            const Json* shown = nullptr;
            for (const Json& child : glb.json["nodes"][glb.nodeNamed(organ.name)]["children"]) {
              if (!glb.isShown(child, time)) continue;
              CHECK(!shown);
              shown = &glb.json["meshes"].at(
                  glb.json["nodes"][child.get<std::size_t>()]["mesh"].get<std::size_t>());
            }
            REQUIRE(shown);
            const Json& primitive = (*shown)["primitives"][0];
            const auto points = glb.values<Vec3f>(primitive["attributes"]["POSITION"]);
            CHECK(glb.triangles(primitive["indices"]) == expected.mesh.triangles);
            REQUIRE(points.size() == expected.mesh.points.size());
            bool same = true;
            for (std::size_t i = 0; i < points.size(); ++i)
              same = same && points[i] == expected.mesh.points[i].cast<float>();
            CHECK(same);
            CHECK(glb.values<Vec3f>(primitive["attributes"]["NORMAL"]) == expected.normals);
          }
          for (std::size_t t = 0; t < now.tools().size() && now.frame() > 0; ++t) {
            const std::size_t node = glb.nodeNamed(again.setup().tools[t].name);
            const Json* moves = glb.sampler(node, "translation");
            REQUIRE(moves);
            const auto times = glb.values<float>((*moves)["input"]);
            REQUIRE(std::size_t(moments) <= times.size());
            CHECK(times[std::size_t(moments - 1)] == time);
            CHECK(glb.values<Vec3f>((*moves)["output"])[std::size_t(moments - 1)] ==
                  now.tools()[t].pose().position.cast<float>());
          }
        },
        {});
    CHECK(moments == summary.moments);
    CHECK(simulation.frame() == part.course.back().last);

    // The libraries that others read it with.
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, "glb");
    REQUIRE_MESSAGE(scene, importer.GetErrorString());
    CHECK(scene->mNumMeshes == glb.json["meshes"].size());
    REQUIRE(scene->mNumAnimations == 1);
    const Model model = readGltfFile(path.string(), bytes);
    CHECK(model.parts.size() > 0);
  }
}

TEST_CASE("still tissue gets a new mesh only where it changed") {
  const test::TemporaryFolder folder;
  Replay replay(recorded(folder, "resect-segment", 4));
  const std::vector<OrganColours> colours(1);
  const GlbSummary all = exportGlb(replay, wholeOf(replay, kRate), colours, folder / "run.glb");
  CHECK(all.surfaces < all.moments);
  CHECK(all.surfaces > 1);
}

TEST_CASE("an exported .vtp has the numbers of the replay's surface") {
  const test::TemporaryFolder folder;
  Replay replay(recorded(folder, "resect-segment-elastic", 3));
  const VtpSeries series = seriesOf(folder / "out" / "a&b.vtp", "--output");
  const ExportedPart part = wholeOf(replay, kRate);
  const std::int64_t files = exportVtp(replay, part, series);
  CHECK(std::int64_t(numberedFiles(series.files).size()) == files);
  const std::string list = readWholeFile(series.list);
  CHECK(list.find("file=\"a&amp;b_0001.vtp\"") != std::string::npos);
  std::size_t entry = 0;
  bool cut = false;
  playMoments(
      replay, part, true,
      [&](const Simulation& now) {
        entry = list.find("<DataSet", entry + 1);
        REQUIRE(entry != std::string::npos);
        CHECK(std::stod(attribute(list, "timestep", entry)) == now.time());
        std::string name = attribute(list, "file", entry);
        name = "a&" + name.substr(std::string("a&amp;").size());
        const std::string file = readWholeFile(series.files.folder / name);
        const OperatedOrgan& organ = now.organs()[0];
        const auto expected = organ.organ.surface.compact(organ.points(), organ.normals());
        const auto points = vtpArray<Vec3f>(file, "Points");
        REQUIRE(points.size() == expected.mesh.points.size());
        bool same = true;
        for (std::size_t i = 0; i < points.size(); ++i)
          same = same && points[i] == expected.mesh.points[i].cast<float>();
        CHECK(same);
        CHECK(std::stoull(attribute(file, "NumberOfPoints")) == points.size());
        CHECK(std::stoull(attribute(file, "NumberOfPolys")) == expected.mesh.triangles.size());
        CHECK(vtpArray<Triangle>(file, "connectivity") == expected.mesh.triangles);
        CHECK(vtpArray<Vec3f>(file, "Normals") == expected.normals);
        CHECK(vtpArray<float>(file, "cut_share") == expected.cut);
        CHECK(vtpArray<std::int32_t>(file, "organ") == std::vector<std::int32_t>(points.size(), 0));
        CHECK(vtpArray<std::int64_t>(file, "offsets").back() ==
              std::int64_t(3 * expected.mesh.triangles.size()));
        for (const float share : expected.cut) cut = cut || share > 0.5f;
      },
      {});
  CHECK(list.find("<DataSet", entry + 1) == std::string::npos);
  CHECK(cut);
}

TEST_CASE("an exported table has the rows of the recording") {
  const test::TemporaryFolder folder;
  Replay replay(recorded(folder, "press", 4));
  const ExportedPart part = wholeOf(replay, 0);
  std::string expected =
      "time_s,frame,tool,tip_x_m,tip_y_m,tip_z_m,force_x_N,force_y_N,force_z_N\r\n";
  std::int64_t rows = 0;
  for (const RecordedSample& s : replay.file().samples(0)) {
    expected += fmt::format("{},{},{},{},{},{},{},{},{}\r\n",
                            printedTime(replay.file().frame(0, s.frame)->time), s.frame,
                            replay.setup().tools[std::size_t(s.tool)].name, s.tip[0], s.tip[1],
                            s.tip[2], s.force[0], s.force[1], s.force[2]);
    ++rows;
  }
  REQUIRE(rows > 60);
  for (const RecordingTable& table : recordingTables()) {
    const std::filesystem::path path = folder / (table.name + ".csv");
    const std::int64_t written = exportTable(replay, part, table, path);
    const std::string text = readWholeFile(path);
    CHECK(std::ranges::count(text, '\n') == written + 1);
    if (table.name == "samples") CHECK(text == expected);
    if (table.name == "frames") CHECK(written == replay.file().lastFrame(0));
    if (table.name == "ledger") {
      std::int64_t amounts = 0;
      for (const RecordedLedger& ledger : replay.file().ledgers(0))
        amounts += std::int64_t(ledger.amounts.size());
      CHECK(written == amounts);
      CHECK(written > 0);
    }
    if (table.name == "events") {
      CHECK(written == std::int64_t(replay.file().events(0).size()));
      CHECK(text.find(",touch,") != std::string::npos);
    }
  }
}

TEST_CASE("counts of frames add up however many rows there are") {
  const test::TemporaryFolder folder;
  Replay replay(recorded(folder, "resect-segment", 4));
  const auto removed = [&](double rate) {
    const auto& frames = recordingTables()[2];
    exportTable(replay, wholeOf(replay, rate), frames, folder / "a.csv");
    std::istringstream lines(readWholeFile(folder / "a.csv"));
    std::string line;
    std::getline(lines, line);
    std::int64_t sum = 0;
    while (std::getline(lines, line)) {
      std::istringstream cells(line);
      std::string cell;
      for (int i = 0; i < 4; ++i) std::getline(cells, cell, ',');
      sum += std::stoll(cell);
    }
    return sum;
  };
  CHECK(removed(0) > 0);
  CHECK(removed(0) == removed(3));
}

TEST_CASE("cells of a table are quoted, and are no formulas") {
  std::ostringstream out;
  CsvWriter csv(out);
  csv.row("plain", "a,b", "say \"x\"", "two\nlines", "=1+1", "-x", 0.1, -2, 1e-300);
  CHECK(out.str() == "plain,\"a,b\",\"say \"\"x\"\"\",\"two\nlines\",'=1+1,'-x,0.1,-2,1e-300\r\n");
}

TEST_CASE("a part of a course begins and ends where it is told") {
  const std::vector<CourseSpan> course{{0, 0, 50}, {2, 50, 120}};
  const auto text = [&](std::int64_t first, std::int64_t last) {
    std::string spans;
    for (const CourseSpan& s : partOf(course, first, last))
      spans += fmt::format("{}:{}-{} ", s.branch, s.first, s.last);
    return spans;
  };
  CHECK(text(0, 1000) == "0:0-50 2:50-120 ");
  CHECK(text(10, 20) == "0:10-20 ");
  CHECK(text(50, 60) == "2:50-60 ");
  CHECK(text(30, 70) == "0:30-50 2:50-70 ");
  CHECK(text(30, 30) == "0:30-30 ");
  CHECK(text(500, 600) == "2:120-120 ");
  CHECK(partOf({}, 0, 5).empty());
}
