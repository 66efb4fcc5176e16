#include "io/cells/cells_file.h"

#include <doctest/doctest.h>
#include <bit>

#include "base/crc32.h"
#include "base/error.h"
#include "base/random.h"
#include "geometry/primitives.h"
#include "io/cells/byte_runs.h"
#include "organ/cell_labels.h"
#include "organ/discretize.h"
#include "organ/fit_surface.h"
#include "support/block_organ.h"
#include "support/malformed/replaced.h"
#include "support/sentence.h"
#include "support/temporary_folder.h"

using namespace resect;
using test::replaced;

namespace {

KeptCells smallOrgan() {
  const TriangleMesh mesh = sphereMesh({0.1, 0.2, -0.3}, 0.05, 16);
  KeptCells kept;
  kept.cells = discretize(mesh, latticeForSpacing(bounds(mesh), 1.0 / 130));
  fitSurface(mesh, kept.cells);
  Region region;
  region.box = {{0.1, -1, -1}, {1, 1, 1}};
  markCells(kept.cells, 200, region);
  labelSkin(kept.cells);
  kept.cells.nameLabel(200, "a \"tumour\"\n\\ of the liver, \xc3\xa4");
  kept.cells.nameLabel(3, "not there");
  kept.cells.landmarks = {{"dome", {0.1, 0.2, 1.0 / 3}}, {"\x7f---\n", {-0.0, 5, 1e-9}}};
  kept.origin = {"resect 1.2.3", "ball.stl", 0.001};
  return kept;
}

bool sameBits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool sameBits(const Vec3& a, const Vec3& b) {
  return sameBits(a.x(), b.x()) && sameBits(a.y(), b.y()) && sameBits(a.z(), b.z());
}

void checkSameCells(const KeptCells& a, const KeptCells& b) {
  CHECK(sameBits(a.cells.lattice.origin, b.cells.lattice.origin));
  CHECK(sameBits(a.cells.lattice.spacing, b.cells.lattice.spacing));
  CHECK(a.cells.lattice.dims == b.cells.lattice.dims);
  CHECK(a.cells.value.areLevels() == b.cells.value.areLevels());
  CHECK(a.cells.value == b.cells.value);
  CHECK(a.cells.inside == b.cells.inside);
  CHECK(sameBits(a.cells.skinScale, b.cells.skinScale));
  CHECK(a.cells.label == b.cells.label);
  CHECK(a.cells.labelNames == b.cells.labelNames);
  REQUIRE(a.cells.landmarks.size() == b.cells.landmarks.size());
  for (std::size_t i = 0; i < a.cells.landmarks.size(); ++i) {
    CHECK(a.cells.landmarks[i].name == b.cells.landmarks[i].name);
    CHECK(sameBits(a.cells.landmarks[i].place, b.cells.landmarks[i].place));
  }
  CHECK(a.origin.program == b.origin.program);
  CHECK(a.origin.source == b.origin.source);
  CHECK(sameBits(a.origin.unit, b.origin.unit));
}

std::string complaintOfCells(const std::string& bytes) {
  return test::sentenceOf([&] { parseCells(bytes, "organ.resect-cells"); });
}

// The same with a checksum that fits, so that what lies behind it is reached.
std::string summed(std::string bytes) {
  bytes.resize(bytes.size() - 16);
  return bytes + fmt::format("\ncrc32 {:08x}\n", crc32(bytes));
}

}  // namespace

TEST_CASE("cells come back from their file bit for bit, with labels, names, landmarks and origin") {
  const KeptCells kept = smallOrgan();
  const std::string bytes = formatCells(kept);
  const KeptCells again = parseCells(bytes, "again");
  checkSameCells(kept, again);
  CHECK(formatCells(again) == bytes);
  const test::TemporaryFolder folder;
  writeCells(folder / "organ.resect-cells", kept);
  CHECK(test::bytesOf(folder / "organ.resect-cells") == bytes);
  checkSameCells(kept, readCells(folder / "organ.resect-cells"));
  CHECK_THROWS_AS(readCells(folder / "another.resect-cells"), Error);
  CHECK_THROWS_AS(readCells(folder.path()), Error);
}

TEST_CASE("vessels come back from a file of cells, and the files that it was made from") {
  KeptCells kept = smallOrgan();
  kept.vessels = makeAnatomy(
      {{VesselKind::PortalVein, -1, Vec3(0.001, 0.002, 0.003), Vec3(0.01, 0, 0.02), 0.003, false},
       {VesselKind::PortalVein, 0, Vec3(0.01, 0, 0.02), Vec3(0.02, 0.01, 0.02), 0.002, true},
       {VesselKind::BileDuct, -1, Vec3(0, 0, 0), Vec3(0.01, 0.01, 0), 0.001, true}});
  kept.origin.inputs = {{"a \"b\".nii.gz", "organ", "NIfTI-1 label image", "0123abcd"},
                        {"t.stl", "tumour", "", ""}};
  const std::string bytes = formatCells(kept);
  const KeptCells again = parseCells(bytes, "again");
  checkSameCells(kept, again);
  CHECK(again.origin.inputs == kept.origin.inputs);
  REQUIRE(again.vessels.segments.size() == 3);
  CHECK(again.vessels.range(VesselKind::PortalVein).count == 2);
  CHECK((again.vessels.segments[1].end - Vec3(0.02, 0.01, 0.02)).norm() < 1e-12);
  CHECK(again.vessels.segments[1].leaf);
  CHECK(formatCells(again) == bytes);
  CHECK(complaintOfCells(summed(replaced(bytes, "portal-vein 2", "portal-vein 7"))) != "");
  CHECK(complaintOfCells(summed(replaced(bytes, "vessel_bytes = ", "vessel_bytes = 9"))) != "");
}

TEST_CASE("cells with values that are no levels, without labels and particles come back too") {
  KeptCells kept;
  kept.cells = test::noise({7, 5, 3}, 4);
  kept.cells.skinScale = 1.0 / 3;
  CHECK_FALSE(kept.cells.value.areLevels());
  checkSameCells(kept, parseCells(formatCells(kept), "x"));
  kept.cells = test::fill({300, 200, 1}, 0.001, [](const Vec3i&) { return 0.0; });
  kept.cells.lattice.spacing = {1e-5, 0.1, 1.0 / 3};
  CHECK(formatCells(kept).size() < 400);
  checkSameCells(kept, parseCells(formatCells(kept), "x"));
}

TEST_CASE("runs of any length come back, and what is no whole run is refused") {
  Random random(3);
  for (int n = 0; n < 200; ++n) {
    std::vector<std::uint8_t> values;
    while (int(values.size()) < n * n)
      values.insert(values.end(), std::size_t(1 + random.below(n < 100 ? 4 : 40000)),
                    std::uint8_t(random.below(256)));
    const std::string bytes = toRuns(values);
    CHECK(countInRuns(bytes, 1) == std::int64_t(values.size()));
    std::vector<std::uint8_t> again(values.size());
    CHECK(fromRuns(bytes, again));
    CHECK(again == values);
    if (values.empty()) continue;
    CHECK_FALSE(fromRuns(std::string_view(bytes).substr(0, bytes.size() - 1), again));
    std::string more = bytes;
    more.push_back('\x01');
    CHECK_FALSE(fromRuns(more, again));
  }
  CHECK(countInRuns(std::string("\0\0", 2), 1) == -1);
  CHECK(countInRuns("\xff\xff\xff\xff\xff\x01", 1) == -1);
  CHECK(countInRuns("\x01\x01\x01", 4) == -1);
}

TEST_CASE("a file cut off at any byte is refused in one sentence that names it") {
  const std::string bytes = formatCells(smallOrgan());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::string text = complaintOfCells(bytes.substr(0, size));
    if (text.find("organ.resect-cells: ") != 0 || text.find('\n') != text.npos)
      FAIL("cut off at ", size, ": ", text);
  }
  CHECK(complaintOfCells(bytes) == "");
}

TEST_CASE("a file with any bit changed is refused") {
  const std::string bytes = formatCells(smallOrgan());
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string changed = bytes;
    changed[at] = char(changed[at] ^ (1 << at % 8));
    const std::string text = complaintOfCells(changed);
    if (text.find("organ.resect-cells: ") != 0 || text.find('\n') != text.npos)
      FAIL("changed at ", at, ": ", text);
  }
}

TEST_CASE(
    "changed bytes under a checksum that fits are refused in a sentence or give valid cells") {
  const std::string bytes = formatCells(smallOrgan());
  Random random(9);
  int refused = 0, read = 0;
  for (int i = 0; i < 4000; ++i) {
    std::string changed = bytes;
    for (int n = 1 + random.below(3); n > 0; --n) {
      // The header more often than it is long.
      const int reach = random.below(2) ? 600 : int(bytes.size());
      const auto at = std::size_t(random.below(std::min(reach, int(changed.size()) - 16)));
      switch (random.below(4)) {
        case 0:
          changed[at] = char(random.below(256));
          break;
        case 1:
          changed.erase(at, 1 + std::size_t(random.below(9)));
          break;
        case 2:
          changed.insert(changed.begin() + std::ptrdiff_t(at), random.below(2) ? '9' : '-');
          break;
        default:
          changed[at] = char(changed[at] ^ (1 << random.below(8)));
      }
    }
    try {
      const Discretization d = parseCells(summed(changed), "organ.resect-cells").cells;
      const auto cells = std::size_t(d.lattice.cellCount());
      REQUIRE(d.inside.size() == cells);
      REQUIRE(d.value.size() == cells);
      REQUIRE((d.label.empty() || d.label.size() == cells));
      for (std::size_t c = 0; c < cells; ++c) REQUIRE((d.value[c] >= 0 && d.value[c] <= 100));
      ++read;
    } catch (const Error& e) {
      const std::string text = e.what();
      CHECK_MESSAGE(text.find("organ.resect-cells") == 0, text);
      CHECK_MESSAGE(text.find('\n') == std::string::npos, text);
      ++refused;
    }
  }
  CHECK(refused > 1000);
  CHECK(read > 100);
}

TEST_CASE("every lie of a header is told") {
  const std::string bytes = formatCells(smallOrgan());
  const auto lie = [&](const std::string& from, const std::string& to) {
    return complaintOfCells(summed(replaced(bytes, from, to)));
  };
  CHECK(lie("resect-cells 1", "resect-cells 2").find("later version") != std::string::npos);
  CHECK(lie("resect-cells 1", "resect-calls 1").find("holds no cells") != std::string::npos);
  CHECK(lie("dims = [", "dims = [1").find("its particle flags are") != std::string::npos);
  CHECK(lie("dims = [", "dims = [0.5, 3, 3] # ").find("dims is not three whole numbers") !=
        std::string::npos);
  CHECK(lie("dims = [13, 13", "dims = [20000, 20000").find("dims are more than") !=
        std::string::npos);
  CHECK(lie("dims = [", "dims = [-").find("dims is not") != std::string::npos);
  CHECK(lie("spacing = [", "spacing = [-").find("is not above 0") != std::string::npos);
  CHECK(lie("origin = [", "origin = [nan, ").find("three finite numbers") != std::string::npos);
  CHECK(lie("particles = ", "particles = 1").find("its header says") != std::string::npos);
  CHECK(lie("\"levels\"", "\"lovels\"").find("neither") != std::string::npos);
  CHECK(lie("\"levels\"", "\"numbers\"").find("its values are") != std::string::npos);
  CHECK(lie("inside_bytes = ", "inside_bytes = 99999").find("bytes are left") != std::string::npos);
  CHECK(lie("label_bytes = ", "label_bytes = 0 #").find("bytes more than") != std::string::npos);
  CHECK(lie("skin_scale = ", "skin_scale = -").find("is no number") != std::string::npos);
  CHECK(lie("[[label]]", "[[lobel]]").find("is not known here") != std::string::npos);
  CHECK(lie("number = 200", "number = 3").find("has a name already") != std::string::npos);
  CHECK(lie("\n---\n", "\n-- \n").find("does not end in a line") != std::string::npos);
}

TEST_CASE("cells that no file can hold are refused before one is written") {
  KeptCells kept = smallOrgan();
  kept.cells.nameLabel(4, "\xff\xfe");
  CHECK_THROWS_AS(formatCells(kept), Error);
  kept = smallOrgan();
  kept.cells.lattice.origin.x() = 1e9;
  CHECK_THROWS_AS(formatCells(kept), Error);
  CHECK_THROWS_AS(formatCells({}), Error);
}
