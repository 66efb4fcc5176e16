#include "io/vessels_file.h"

#include <doctest/doctest.h>

#include <fstream>

#include "anatomy/measure_anatomy.h"
#include "anatomy/small_vessels.h"
#include "io/data_folder.h"
#include "io/plain_mesh.h"
#include "support/sentence.h"
#include "support/temporary_folder.h"

using namespace resect;

TEST_CASE("vessels that are written are read again to a micrometre") {
  const test::TemporaryFolder folder;
  const Anatomy written = test::threeForks();
  writeVessels(folder / "a.vessels", written);
  const Anatomy read = readVessels(folder / "a.vessels");
  REQUIRE(read.segments.size() == written.segments.size());
  for (std::size_t i = 0; i < read.segments.size(); ++i) {
    const VesselSegment &a = read.segments[i], &b = written.segments[i];
    CHECK(a.kind == b.kind);
    CHECK(a.parent == b.parent);
    CHECK(a.leaf == b.leaf);
    CHECK((a.start - b.start).norm() < 1e-6);
    CHECK((a.end - b.end).norm() < 1e-6);
    CHECK(std::abs(a.radius - b.radius) < 1e-7);
  }
}

TEST_CASE("files of vessels that are torn or wrong are refused with file and line") {
  const test::TemporaryFolder folder;
  const auto path = folder / "v.vessels";
  const auto refused = [&](const std::string& text, const std::string& what) {
    std::ofstream(path) << text;
    CHECK(test::refuses([&] { readVessels(path); }, what));
  };
  const std::string head = "resect vessels 1\n";
  refused("ply\n", "not a file of vessels");
  refused("", "not a file of vessels");
  refused(head + "lymph 1\n-1 0 0 0 1 0 0 1 1\n", "v.vessels:2");
  refused(head + "portal-vein 2\n-1 0 0 0 1 0 0 1 1\n", "segments early");
  refused(head + "portal-vein 1\n0 1 0 0 1 1\n", "parent");
  refused(head + "portal-vein 1\n-1 0 0 0 1 0 nought 1 1\n", "v.vessels:3");
  refused(head + "portal-vein 1\n-1 0 0 0 1 0 0 0 1\n", "radius above 0");
  refused(head + "portal-vein -4\n", "too many");
}

TEST_CASE("the built-in liver's vessels lie inside it and none crosses one of another kind") {
  const TriangleMesh liver = merged(readPlainMesh(dataFolder() / "organs" / "liver.ply"));
  const AnatomyMeasures m = measure(readVessels(dataFolder() / "organs" / "liver.vessels"), liver);
  CHECK(m.kinds[0].terminals == 1000);
  CHECK(m.kinds[1].terminals == 1000);
  CHECK(m.kinds[2].terminals > 950);
  CHECK(m.kinds[3].terminals > 850);
  for (int a = 0; a < kVesselKinds; ++a) {
    CHECK(m.kinds[std::size_t(a)].outside == 0);
    for (int b = 0; b < a; ++b) CHECK(m.crossings[std::size_t(a)][std::size_t(b)] == 0);
  }
}
