#include "sph/colour_field.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/parallel.h"
#include "base/random.h"
#include "sph/kernel.h"
#include "sph/particle_sums.h"
#include "support/block_organ.h"

using namespace resect;

namespace {

// The same field by the general SPH sums over all cells.
struct Reference {
  explicit Reference(const Discretization& d)
      : sums(positions(d), std::vector<double>(d.value.size(), d.lattice.cellVolume()),
             kSmoothingPerSpacing * d.lattice.spacing.x()),
        attribute(d.value.size()) {
    for (std::size_t i = 0; i < attribute.size(); ++i) attribute[i] = d.value[i];
  }
  static std::vector<Vec3> positions(const Discretization& d) {
    std::vector<Vec3> p;
    for (std::int64_t i = 0; i < d.lattice.cellCount(); ++i)
      p.push_back(d.lattice.centre(d.lattice.cell(i)));
    return p;
  }
  double operator()(const Vec3& r) const { return sums.interpolate(attribute, r); }
  ParticleSums sums;
  std::vector<double> attribute;
};

Vec3i nodeAt(const ColourField& f, std::int64_t i) {
  const Vec3i n = f.nodeDims();
  return {int(i % n.x()), int(i / n.x() % n.y()), int(i / n.x() / n.y())};
}

bool sameField(const ColourField& a, const ColourField& b) {
  for (std::int64_t i = 0; i < a.brickCount(); ++i) {
    if ((a.slot(i) >= 0) != (b.slot(i) >= 0)) return false;
    if (a.slot(i) < 0 && a.slot(i) != b.slot(i)) return false;
    if (a.slot(i) >= 0 && !std::ranges::equal(a.values(a.slot(i)), b.values(b.slot(i))))
      return false;
  }
  return true;
}

}  // namespace

TEST_CASE("the colour field equals the general SPH sum at every node, at every refinement") {
  for (int refine : {1, 2, 3, 4})
    for (const Discretization& d : {test::noise({5, 7, 4}, 11), test::ball(12),
                                    test::fullBlock({9, 8, 7}), test::fullBlock({1, 1, 1})}) {
      const ColourField field(d, refine);
      const Reference reference(d);
      const Vec3i n = field.nodeDims();
      double worst = 0;
      for (std::int64_t i = 0; i < std::int64_t(n.x()) * n.y() * n.z(); ++i) {
        const Vec3i node = nodeAt(field, i);
        worst = std::max(
            worst, std::abs(field.node(node) - reference(field.nodePosition(node.cast<double>()))));
      }
      // 36 float products of up to 100: rounding below 36 * 100 * 2^-24.
      CHECK(worst < 2.2e-4);
    }
}

TEST_CASE(
    "solid tissue has the colour value 100 within one per cent and a surface never runs through "
    "it") {
  const ColourField field(test::fullBlock({20, 20, 20}), 2);
  for (int x = 12; x < 30; ++x) {
    const float c = field.node({x, 20, 21});
    CHECK(c > kMaxIso);
    CHECK(c < 101);
  }
  // The inner bricks are known without being stored.
  std::int64_t full = 0;
  for (std::int64_t b = 0; b < field.brickCount(); ++b) full += field.slot(b) == ColourField::kFull;
  CHECK(full > 100);
}

TEST_CASE("bricks are stored where their nodes reach tissue and less than tissue, cell by cell") {
  const auto kindOf = [](const Discretization& cells, const ColourField& field,
                         const Vec3i& brick) {
    // The nodes and the plane after them; the kernel ends two cells away.
    const Vec3 below =
        (field.nodePosition((kBrickNodes * brick).cast<double>()) - cells.lattice.origin)
            .cwiseQuotient(cells.lattice.spacing);
    const Vec3 above = below + Vec3::Constant(double(kBrickNodes) / field.refine());
    bool any = false, lacking = false;
    for (int z = int(std::floor(below.z() - 2)); z <= above.z() + 2; ++z)
      for (int y = int(std::floor(below.y() - 2)); y <= above.y() + 2; ++y)
        for (int x = int(std::floor(below.x() - 2)); x <= above.x() + 2; ++x) {
          const Vec3i cell(x, y, z);
          const Vec3 at = cell.cast<double>();
          if (((at - below).array() <= -2 + 1e-9).any() || ((at - above).array() >= 2 - 1e-9).any())
            continue;
          const float value = cells.lattice.contains(cell)
                                  ? cells.value[std::size_t(cells.lattice.index(cell))]
                                  : 0.f;
          any = any || value > 0;
          lacking = lacking || value < 100;
        }
    return !any ? ColourField::kEmpty : !lacking ? ColourField::kFull : 0;
  };
  for (const int refine : {1, 2, 3, 4})
    for (const Discretization& cells :
         {test::fullBlock({70, 14, 13}), test::ball(22), test::noise({9, 12, 7}, 5)}) {
      const ColourField field(cells, refine);
      int wrong = 0, full = 0;
      for (std::int64_t b = 0; b < field.brickCount(); ++b) {
        const int expected = kindOf(cells, field, field.brick(b));
        wrong += std::min(field.slot(b), 0) != expected;
        full += expected == ColourField::kFull;
      }
      CHECK(wrong == 0);
      CHECK((full > 0 || cells.lattice.dims.x() == 9));
    }
}

TEST_CASE("the outermost nodes are zero so that every surface is closed") {
  for (int refine : {1, 2, 3, 4}) {
    const ColourField field(test::fullBlock({3, 4, 5}), refine);
    const Vec3i n = field.nodeDims();
    for (int a = 0; a < 3; ++a)
      for (int i = 0; i < 40; ++i)
        for (int j = 0; j < 40; ++j)
          for (int end : {0, n[a] - 1}) {
            Vec3i node;
            node[a] = end;
            node[(a + 1) % 3] = i;
            node[(a + 2) % 3] = j;
            REQUIRE(field.node(node) == 0);
          }
  }
}

TEST_CASE("after any edits the field is bit for bit the one built from the edited cells") {
  for (int refine : {1, 2, 3, 4}) {
    Discretization d = test::ball(16);
    ColourField field(d, refine);
    Random random(refine);
    for (int round = 0; round < 30; ++round) {
      for (int i = 0; i < 20; ++i) {
        const int cell = random.below(int(d.value.size()));
        const float v = random.below(4) == 0 ? 100.f : 0.f;
        d.value.set(cell, v);
        field.setCellValue(cell, v);
      }
      field.update();
      REQUIRE(sameField(field, ColourField(d, refine)));
    }
  }
}

TEST_CASE(
    "a field built at once is the one whose cells were set one by one, in rows of any length") {
  for (int refine : {1, 2, 3, 4})
    for (const Vec3i& dims : {Vec3i(3, 4, 5), Vec3i(54, 9, 7), Vec3i(64, 6, 5), Vec3i(131, 8, 9)}) {
      Discretization d = test::fullBlock(dims);
      Random random(dims.x());
      for (int hole = 0; hole < 6; ++hole) {  // some empty, some partly filled
        const std::int64_t middle = random.below(int(d.value.size()));
        for (std::int64_t i = 0; i < std::int64_t(d.value.size()); ++i)
          if ((d.lattice.cell(i) - d.lattice.cell(middle)).cwiseAbs().maxCoeff() < 3)
            d.value.set(std::size_t(i), hole < 4 ? 0.f : 30.f);
      }
      Discretization nothing = d;
      nothing.value = ColourValues(d.value.size());
      ColourField field(nothing, refine);
      for (std::int64_t i = 0; i < std::int64_t(d.value.size()); ++i)
        field.setCellValue(i, d.value[std::size_t(i)]);
      field.update();
      CHECK(sameField(field, ColourField(d, refine)));
    }
}

TEST_CASE("cells held as levels give the bits that they give as numbers") {
  Random random(41);
  for (int refine : {1, 2, 3, 4})
    for (const int across : {3, 16, 21, 70, 131}) {
      Discretization d = test::noise({across, 6, 5}, std::uint64_t(across));
      ColourValues levels(d.value.size());
      for (std::size_t i = 0; i < levels.size(); ++i)
        levels.set(i, kLevel * std::floor(d.value[i] / kLevel));
      d.value = levels;
      ColourField bytes(d, refine), edited(d, refine);
      const auto cell = std::int64_t(random.below(int(d.value.size())));
      Discretization other = d;
      other.value.set(std::size_t(cell), 33.3f);
      ColourField numbers(other, refine);
      edited.setCellValue(cell, 33.3f);
      edited.update();
      CHECK(sameField(edited, numbers));
      for (int k = 0; k < 40; ++k) {
        const auto at = k == 0 ? cell : std::int64_t(random.below(int(d.value.size())));
        const float value = kLevel * float(random.below(129));
        for (ColourField* field : {&bytes, &numbers, &edited}) field->setCellValue(at, value);
        if (k % 8 != 0) continue;
        for (ColourField* field : {&bytes, &numbers, &edited}) field->update();
        CHECK(sameField(bytes, numbers));
        CHECK(sameField(bytes, edited));
        CHECK(bytes.cellValue(at) == value);
        CHECK(numbers.cellValue(at) == value);
      }
      // A byte a cell and four: they were held in two ways.
      CHECK(bytes.bytes() + 2 * d.value.size() < numbers.bytes());
    }
}

TEST_CASE("a brick of levels is the plain one bit for bit, and reads 16 cells along x") {
  Random random(8);
  for (int refine : {1, 2, 3, 4}) {
    const FieldStencil& stencil = fieldStencil(refine);
    for (int k = 0; k < 200; ++k) {
      const int alongY = 8 + random.below(9), rows = refine == 1 ? 6 : 5;
      const int alongZ = alongY * (rows + random.below(3));
      std::vector<std::uint8_t> cells(std::size_t((rows - 1) * alongZ + (rows - 1) * alongY + 16));
      for (std::uint8_t& cell : cells)
        cell = std::uint8_t(k % 2 == 0 ? random.below(129) : 128 * random.below(2));
      const auto at = [&] { return stencil.phases == 1 ? 0 : random.below(refine); };
      const Vec3i phase(at(), at(), at());
      const unsigned planes = unsigned(random.below(16));
      std::vector<float> wide(kBrickSize, -1.f), plain(kBrickSize, -1.f);
      sumBrick(stencil, phase, cells.data(), alongY, alongZ, planes, wide.data());
      sumBrickPlainly(stencil, phase, cells.data(), alongY, alongZ, planes, plain.data());
      REQUIRE(wide == plain);
    }
  }
}

TEST_CASE("the original field is remembered through edits") {
  const Discretization d = test::ball(12);
  const ColourField before(d, 2);
  ColourField field(d, 2);
  for (std::int64_t i = 0; i < d.lattice.cellCount(); i += 3) field.setCellValue(i, 0);
  field.update();
  const Vec3i n = field.nodeDims();
  for (int i = 0; i < 2000; ++i) {
    const Vec3i node = nodeAt(field, i * 7 % (n.x() * n.y() * n.z()));
    REQUIRE(field.originalNode(node) == doctest::Approx(before.node(node)).epsilon(1e-6));
  }
}

TEST_CASE("a lattice that needs more bricks than can be numbered is known beforehand") {
  const auto canHold = [](const Vec3i& dims, int refine) {
    return ColourField::canHold({Vec3::Zero(), Vec3::Ones(), dims}, refine);
  };
  CHECK(canHold({500, 500, 500}, 4));
  CHECK(canHold({200'000'000, 1, 1}, 2));
  CHECK_FALSE(canHold({200'000'000, 1, 1}, 4));
  CHECK_FALSE(canHold({2000, 2000, 2000}, 4));
}

TEST_CASE("setting a cell to its own value touches nothing") {
  Discretization d = test::ball(10);
  ColourField field(d, 2);
  field.setCellValue(5, d.value[5]);
  CHECK(field.update().empty());
}

TEST_CASE("the field has the same bits at 1, 2 and 3 threads") {
  const Discretization d = test::noise({20, 21, 22}, 5);
  const ColourField one = [&] {
    const ThreadLimit limit(1);
    return ColourField(d, 2);
  }();
  for (int threads : {2, 3}) {
    const ThreadLimit limit(threads);
    CHECK(sameField(one, ColourField(d, 2)));
  }
}

TEST_CASE("the bricks that a box meets are those whose cells it meets") {
  const ColourField field(test::fullBlock({9, 6, 12}), 2);
  const auto cellsOf = [&](const Vec3i& brick) {
    return Aabb{field.nodePosition((kBrickNodes * brick).cast<double>()),
                field.nodePosition((kBrickNodes * (brick + Vec3i::Ones())).cast<double>())};
  };
  const Aabb all{field.nodePosition(Vec3::Zero()),
                 field.nodePosition(field.nodeDims().cast<double>())};
  CHECK(field.bricksIn(all.padded(1)).count() == std::size_t(field.brickCount()));
  const Vec3 endless = Vec3::Constant(std::numeric_limits<double>::infinity());
  CHECK(field.bricksIn({-endless, endless}).count() == std::size_t(field.brickCount()));
  CHECK(field.bricksIn({all.max + Vec3::Ones(), endless}).count() == 0);
  CHECK(field.bricksIn({-endless, all.min - Vec3::Ones()}).count() == 0);
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    Aabb box;
    for (int k = 0; k < 2; ++k)
      box.grow(Vec3(all.min + 1.5 * Vec3(random.uniform(-0.2, 1), random.uniform(-0.2, 1),
                                         random.uniform(-0.2, 1))
                                        .cwiseProduct(all.size())));
    const IndexBox found = field.bricksIn(box);
    for (std::int64_t b = 0; b < field.brickCount(); ++b)
      CHECK(found.contains(field.brick(b)) == !intersection(cellsOf(field.brick(b)), box).empty());
  }
}

TEST_CASE("the general sums give density, unity and zero where they should") {
  const Discretization d = test::fullBlock({14, 14, 14}, 0.01);
  const auto positions = Reference::positions(d);
  const std::vector<double> volume(positions.size(), 1e-6), mass(positions.size(), 1060e-6);
  const ParticleSums sums(positions, volume, 0.01);
  const Vec3 middle = d.lattice.box().centre();
  CHECK(std::abs(sums.partitionOfUnity(middle) - 1) < 6e-4);
  CHECK(std::abs(sums.density(mass, middle) / 1060 - 1) < 6e-4);
  CHECK(sums.colour(middle) == sums.partitionOfUnity(middle));
  CHECK(sums.partitionOfUnity(middle + Vec3(1, 0, 0)) == 0);
  CHECK(ParticleSums({}, {}, 0.01).colour(middle) == 0);
  // Against the plain sum over all particles.
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const Vec3 r(random.uniform(-0.02, 0.18), random.uniform(-0.04, 0.14), random.uniform(0, 0.2));
    double plain = 0;
    for (const Vec3& p : positions) plain += 1e-6 * kernel((r - p).norm(), 0.01);
    CHECK(sums.partitionOfUnity(r) == doctest::Approx(plain).epsilon(1e-12));
  }
}
