#include <doctest/doctest.h>

#include "base/error.h"
#include "geometry/primitives.h"
#include "io/cells/discretization_file.h"
#include "io/scenario/scenario_file.h"
#include "organ/discretize.h"
#include "support/malformed/malformed.h"
#include "support/temporary_folder.h"

using namespace resect;

namespace {

// Each file is either refused in one sentence that names it, or read as something valid.
template <typename Read>
void readAll(const std::vector<test::BadFile>& files, Read read) {
  CHECK(files.size() == 40);
  int refused = 0;
  for (const test::BadFile& file : files) {
    CAPTURE(file.name);
    const test::TemporaryFolder folder;
    const auto path = folder.write(file.name, file.bytes);
    try {
      read(path);
      CHECK_MESSAGE(file.mayBeFine, "was read without complaint: " << file.name);
    } catch (const Error& e) {
      const std::string text = e.what();
      ++refused;
      CHECK_MESSAGE(text.find(file.name) != std::string::npos, text);
      CHECK_MESSAGE(text.find('\n') == std::string::npos, text);
      CHECK_MESSAGE(text.size() < 2000, text);
    }
  }
  CHECK(refused >= 20);
}

}  // namespace

TEST_CASE("malformed discretisation files end in a sentence or in a valid organ") {
  const TriangleMesh ball = sphereMesh({0, 0, 0}, 0.1, 8);
  const std::string valid =
      formatDiscretization(discretize(ball, latticeForSpacing(bounds(ball), 0.04)));
  const Discretization whole = parseDiscretization(valid, "valid.dis");
  CHECK(whole.particleCount() > 20);
  readAll(test::malformedDiscretizations(valid), [](const std::filesystem::path& path) {
    const Discretization cells = readDiscretization(path);
    const auto count = cells.lattice.dims.cast<std::int64_t>().prod();
    CHECK(std::int64_t(cells.value.size()) == count);
    for (std::size_t i = 0; i < cells.value.size(); ++i)
      CHECK((cells.value[i] >= 0 && cells.value[i] <= 100));
  });
}

TEST_CASE("malformed scenario files end in a sentence or in a valid scenario") {
  const std::string valid =
      test::bytesOf(std::filesystem::path(RESECT_SOURCE_DIR) / "data/scenarios/cut.toml");
  CHECK_NOTHROW(parseScenario(valid, "valid.toml"));
  readAll(test::malformedScenarios(valid), [](const std::filesystem::path& path) {
    const Scenario scenario = readScenario(path);
    CHECK(scenario.duration > 0);
    CHECK(scenario.frameRate > 0);
  });
}
