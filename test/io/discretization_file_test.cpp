#include "io/cells/discretization_file.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "base/error.h"
#include "base/random.h"
#include "geometry/primitives.h"
#include "organ/discretize.h"
#include "sph/lattice_extent.h"
#include "support/malformed/replaced.h"
#include "support/sentence.h"

using namespace resect;
using test::replaced;

namespace {

// The thesis's example, cut to its three rows.
const std::string kThesis =
    "Discretization:\n"
    "number of particles: 3\n"
    "number of particles inside the object: 3\n"
    "boundingbox dimensions: 10 10 10\n"
    "boundingbox: -510.936 100 -1.38614 -100 378.826 281.311\n"
    "particle: x: y: z: LevelSet:\n"
    "0 -264.374 223.281 39.7075 100\n"
    "1 -223.281 223.281 39.7075 100\n"
    "2 -182.187 223.281 39.7075 100\n";

// The sentence of the Error that parsing throws; empty if it throws none.
std::string refusalOfDiscretization(const std::string& text) {
  return test::sentenceOf([&] { parseDiscretization(text, "organ.dis"); });
}

bool sameDiscretization(const Discretization& a, const Discretization& b) {
  return a.lattice.origin == b.lattice.origin && a.lattice.spacing == b.lattice.spacing &&
         a.lattice.dims == b.lattice.dims && a.value == b.value && a.inside == b.inside;
}

TriangleMesh tiltedTorus() {
  return transformed(torusMesh({0, 0, 0}, 0.05, 0.02),
                     {{-0.13, 0.35, 0.02}, Eigen::Quaterniond(0.8, 0.3, 0.1, -0.4).normalized()});
}

}  // namespace

TEST_CASE("the thesis's example lies on the cubic grid of its longest side") {
  const Discretization d = parseDiscretization(kThesis, "thesis", 0.001);
  CHECK(d.lattice.cubic());
  CHECK(d.lattice.spacing.x() == doctest::Approx(0.0410936));
  CHECK(d.lattice.dims == Vec3i(10, 10, 10));
  CHECK(d.particleCount() == 3);
  for (const int x : {6, 7, 8}) {
    const std::int64_t cell = d.lattice.index({x, 3, 1});
    CHECK(d.inside[cell] == 1);
    CHECK(d.value[cell] == 100);
  }
  CHECK((d.lattice.centre({6, 3, 1}) - Vec3(-0.264374, 0.223281, 0.0397075)).norm() < 1e-6);
  CHECK(parseDiscretization(kThesis, "thesis").lattice.spacing.x() == doctest::Approx(41.0936));
}

TEST_CASE("a grid with its own spacing per axis is read as the thesis's text says") {
  const Discretization d = parseDiscretization(
      "Discretization:\nnumber of particles: 2\nnumber of particles inside the object: 1\n"
      "boundingbox dimensions: 10 5 4\nboundingbox: 0 0 0 1 2 3\nparticle: x: y: z: LevelSet:\n"
      "0 0.3 0.8 1.5 100\n1 0.4 0.8 1.5 0\n",
      "own");
  CHECK((d.lattice.spacing - Vec3(0.1, 0.4, 0.75)).norm() < 1e-15);
  CHECK(d.particleCount() == 1);
  CHECK(d.inside[d.lattice.index({3, 2, 2})] == 1);
  CHECK(d.value[d.lattice.index({4, 2, 2})] == 0);
}

TEST_CASE("what is written is read back bit for bit, skin cells included") {
  const TriangleMesh mesh = tiltedTorus();
  for (const Lattice& lattice :
       {latticeForSpacing(bounds(mesh), 0.005), latticeForSpacing(bounds(mesh), 0.0037123),
        latticeForSpacing(bounds(mesh), 1.0 / 130), latticeForDims(bounds(mesh), {20, 17, 9}),
        cubicLatticeForDims(bounds(mesh), 20)}) {
    const Discretization d = discretize(mesh, lattice);
    std::int64_t skin = 0;
    for (std::size_t c = 0; c < d.value.size(); ++c) skin += d.value[c] > 0 && !d.inside[c];
    CHECK(skin > 0);
    const std::string text = formatDiscretization(d);
    const Discretization again = parseDiscretization(text, "again");
    CHECK(sameDiscretization(d, again));
    CHECK(text == formatDiscretization(again));
  }
}

TEST_CASE("a file on disk keeps its bits") {
  const auto path = std::filesystem::temp_directory_path() / "resect_discretization_test.dis";
  const TriangleMesh mesh = tiltedTorus();
  const Discretization d = discretize(mesh, latticeForSpacing(bounds(mesh), 0.006));
  writeDiscretization(path, d);
  CHECK(sameDiscretization(d, readDiscretization(path)));
  std::filesystem::remove(path);
  CHECK_THROWS_AS(readDiscretization(path), Error);
  CHECK_THROWS_AS(readDiscretization(path.parent_path()), Error);
}

TEST_CASE("inside rows are those above 0 if their number fits, else the first ones") {
  // Outside points listed with 0 in between.
  auto text = replaced(kThesis, "inside the object: 3", "inside the object: 2");
  text = replaced(text, "1 -223.281 223.281 39.7075 100", "1 -223.281 223.281 39.7075 0");
  Discretization d = parseDiscretization(text, "between");
  CHECK(d.particleCount() == 2);
  CHECK(d.inside[d.lattice.index({7, 3, 1})] == 0);
  CHECK(d.inside[d.lattice.index({8, 3, 1})] == 1);
  // Three above 0, two inside: the first two.
  text = replaced(kThesis, "inside the object: 3", "inside the object: 2");
  d = parseDiscretization(text, "first");
  CHECK(d.particleCount() == 2);
  CHECK(d.inside[d.lattice.index({8, 3, 1})] == 0);
  CHECK(d.value[d.lattice.index({8, 3, 1})] == 100);
}

TEST_CASE("an organ without particles is a file without rows") {
  Discretization d;
  d.lattice = settled({{0.1, 0.2, 0.3}, {0.1, 0.1, 0.1}, {2, 2, 2}});
  d.value = ColourValues(8);
  d.inside.assign(8, 0);
  CHECK(sameDiscretization(d, parseDiscretization(formatDiscretization(d), "empty")));
}

TEST_CASE("blank lines at the end and line ends of other systems do no harm") {
  CHECK(refusalOfDiscretization(kThesis + "\n  \n") == "");
  std::string dos;
  for (const char c : kThesis) dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
  CHECK(refusalOfDiscretization(dos) == "");
  CHECK(refusalOfDiscretization(kThesis.substr(0, kThesis.size() - 1)) == "");
}

TEST_CASE("lines that end in \\r alone are lines, in messages too") {
  std::string old = kThesis;
  std::ranges::replace(old, '\n', '\r');
  CHECK(parseDiscretization(old, "a.dis").particleCount() == 3);
  CHECK(refusalOfDiscretization(replaced(old, "39.7075 100\r2", "39.7075 x\r2"))
            .starts_with("organ.dis:8: \"x\""));
}

TEST_CASE("cells that would lie nowhere are neither read nor written") {
  CHECK(test::refuses([] { parseDiscretization(kThesis, "a.dis", 1e300); },
                      "a.dis:5: the box reaches"));
  Discretization cells = parseDiscretization(kThesis, "a.dis");
  cells.lattice.origin.x() = std::numeric_limits<double>::infinity();
  CHECK(test::refuses([&] { formatDiscretization(cells); }, "cells cannot be written"));
}

TEST_CASE("whatever is wrong is refused with its line") {
  const struct {
    std::string what, with, where;
  } cases[] = {
      {"Discretization:", "Discretisation:", "organ.dis:1:"},
      {"number of particles: 3", "number of particles:", "organ.dis:2:"},
      {"number of particles: 3", "number of particles: 4", "organ.dis:10:"},
      {"number of particles: 3", "number of particles: -3", "organ.dis:2:"},
      {"number of particles: 3", "number of particles: 3.5", "organ.dis:2:"},
      {"number of particles: 3", "number of particles: 99999999999999999999", "organ.dis:2:"},
      {"number of particles: 3", "number of particles: 150000000", "organ.dis:4:"},
      {"number of particles: 3\nnumber of particles inside the object: 3",
       "number of particles: 2\nnumber of particles inside the object: 2", "organ.dis:9:"},
      {"inside the object: 3", "inside the object: 4", "organ.dis:3:"},
      {"inside the object: 3", "inside the object: 3 3", "organ.dis:3:"},
      {"10 10 10", "10 10", "organ.dis:4:"},
      {"10 10 10", "10 -10 10", "organ.dis:4:"},
      {"10 10 10", "10 0 10", "organ.dis:4:"},
      {"10 10 10", "100000 100000 100000", "organ.dis:4:"},
      {"10 10 10", "2147483647 2147483647 2147483647", "organ.dis:4:"},
      {"10 10 10", "10 1e1 10", "organ.dis:4:"},
      {"-100 378.826", "-600 378.826", "organ.dis:5:"},
      {"-100 378.826", "nan 378.826", "organ.dis:5:"},
      {"-100 378.826", "inf 378.826", "organ.dis:5:"},
      {"-510.936 100 -1.38614 -100", "-1e308 100 -1.38614 1e308", "organ.dis:5:"},
      {"boundingbox: ", "boundingbox ", "organ.dis:5:"},
      {"LevelSet:", "", "organ.dis:6:"},
      {"1 -223.281 223.281 39.7075 100", "1 -223.281 223.281 39.7075", "organ.dis:8:"},
      {"1 -223.281 223.281 39.7075 100", "1 -223.281 223.281 39.7075 100 7", "organ.dis:8:"},
      {"1 -223.281 223.281 39.7075 100", "1 -223.281 nan 39.7075 100", "organ.dis:8:"},
      {"1 -223.281 223.281 39.7075 100", "1 -223.281 223.281 inf 100", "organ.dis:8:"},
      {"1 -223.281 223.281 39.7075 100", "1 -223.281 223.281 39.7x75 100", "organ.dis:8:"},
      {"1 -223.281 223.281 39.7075 100", "1 -223.281 223.281 39.7075 100.5", "organ.dis:8:"},
      {"1 -223.281 223.281 39.7075 100", "1 -223.281 223.281 39.7075 -1", "organ.dis:8:"},
      {"1 -223.281 223.281 39.7075 100", "1 -223.281 223.281 39.7075 nan", "organ.dis:8:"},
      {"1 -223.281 223.281 39.7075 100", "1 -223.281 223.281 39.7075 1e99", "organ.dis:8:"},
      {"1 -223.281 223.281 39.7075 100", "2 -223.281 223.281 39.7075 100", "organ.dis:8:"},
      {"1 -223.281 223.281 39.7075 100", "1 -215.281 223.281 39.7075 100", "organ.dis:8:"},
      {"1 -223.281 223.281 39.7075 100", "1 -223.281 -1e300 39.7075 100", "organ.dis:8:"},
      {"1 -223.281 223.281 39.7075 100", "1 -264.374 223.281 39.7075 100", "organ.dis:8:"},
      {"1 -223.281 223.281 39.7075 100", "", "organ.dis:8:"},
      {"1 -223.281 223.281 39.7075 100", "1 -223.281 223.281 39.7075 0", "organ.dis:8:"},
  };
  for (const auto& c : cases) {
    const std::string sentence = refusalOfDiscretization(replaced(kThesis, c.what, c.with));
    CHECK_MESSAGE(sentence.starts_with(c.where), c.with << " -> " << sentence);
    CHECK(sentence.size() < 300);
    CHECK(sentence.find('\n') == std::string::npos);
  }
  CHECK(refusalOfDiscretization(kThesis + "more\n").starts_with("organ.dis:10:"));
  CHECK(refusalOfDiscretization(kThesis + "3 -141.094 223.281 39.7075 100\n")
            .starts_with("organ.dis:10:"));
  CHECK(refusalOfDiscretization("").starts_with("organ.dis:1:"));
  CHECK_THROWS_AS(parseDiscretization(kThesis, "unit", 0), Error);
  CHECK_THROWS_AS(parseDiscretization(kThesis, "unit", -0.001), Error);
}

TEST_CASE("5000 files with random damage are read or refused, never worse") {
  const TriangleMesh mesh = sphereMesh({0, 0, 0}, 0.05, 8);
  const std::string whole =
      formatDiscretization(discretize(mesh, latticeForSpacing(bounds(mesh), 0.025)));
  Random random(17);
  int refused = 0;
  for (int round = 0; round < 5000; ++round) {
    std::string text = round % 2 ? whole : kThesis;
    for (int blow = 1 + random.below(3); blow > 0; --blow) {
      const int at = random.below(int(text.size()));
      switch (random.below(5)) {
        case 0:
          text[at] = char(random.below(256));
          break;
        case 1:
          text.erase(at, 1 + random.below(20));
          break;
        case 2:
          text.insert(at,
                      std::string(1 + random.below(4), "0123456789.-+e naif"[random.below(19)]));
          break;
        case 3:
          text.resize(at);
          break;
        default:
          text.insert(at, text.substr(random.below(int(text.size())), random.below(60)));
      }
      if (text.empty()) text = "x";
    }
    try {
      const Discretization d = parseDiscretization(text, "fuzz");
      CHECK(d.value.size() == std::size_t(d.lattice.cellCount()));
      CHECK(d.inside.size() == d.value.size());
    } catch (const Error& e) {
      ++refused;
      CHECK(std::string(e.what()).starts_with("fuzz:"));
    }
  }
  CHECK(refused > 2500);
}
