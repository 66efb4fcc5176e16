#include "blood/film/blood_film.h"

#include <doctest/doctest.h>

#include "support/block_organ.h"
#include "tissue/still_tissue.h"

using namespace resect;

namespace {

constexpr double kSide = 0.005;  // m

OperatedOrgan organOf(Discretization cells) {
  return operatedOrgan("organ", makeOrgan(std::move(cells), {}));
}

// A basin: a block with a hollow of `inner` x `inner` cells, one cell deep, in its top.
OperatedOrgan basin(int outer, int inner) {
  const int rim = (outer - inner) / 2;
  return organOf(test::fill({outer, 3, outer}, kSide, [&](const Vec3i& c) {
    const bool hollow =
        c.y() == 2 && c.x() >= rim && c.x() < outer - rim && c.z() >= rim && c.z() < outer - rim;
    return hollow ? 0.0 : 100.0;
  }));
}

struct Film {
  OperatedOrgan organ;
  BloodFilm film;
  std::vector<BloodDrop> drops;

  explicit Film(OperatedOrgan o) : organ(std::move(o)) { film.setUp(organ); }
  void run(int frames) {
    for (int i = 0; i < frames; ++i) {
      film.place(organ);
      film.step(1.0 / 60, false, drops);
      film.collect();
    }
  }
  Picolitres all() const {
    Picolitres sum = film.volumes().liquid + film.volumes().clotted;
    for (const BloodDrop& d : drops) sum += d.volume;
    return sum;
  }
  std::int64_t cell(int x, int y, int z) const { return organ.organ.rest.lattice.index({x, y, z}); }
  double thickness(std::int64_t c) const {
    const std::int32_t number = film.skin().numberOf(c);
    return toCubicMetres(film.liquidAt(number) + film.clottedAt(number)) / film.skin()[number].area;
  }
};

}  // namespace

TEST_CASE("no picolitre is lost or made, however blood runs") {
  Film f(organOf(test::ball(14)));
  const Picolitres poured = 1234567891;  // 1.2 ml
  f.film.add(f.cell(7, 12, 7), poured);
  for (int i = 0; i < 200; ++i) {
    f.run(1);
    REQUIRE(f.all() == poured);
  }
}

TEST_CASE("blood runs down a ball and not up, and hangs or drips below") {
  Film f(organOf(test::ball(14)));
  f.film.add(f.cell(7, 12, 7), toPicolitres(3e-6));
  f.run(600);
  double above = 0, below = 0;
  for (const BloodDrop& d : f.drops) below += toCubicMetres(d.volume);
  for (const WetCell& w : f.film.wet())
    (f.organ.organ.rest.lattice.cell(w.cell).y() > 6 ? above : below) += toCubicMetres(w.liquid);
  CHECK(below > 2 * above);  // above, a stain of a tenth of a millimetre stays
  CHECK_FALSE(f.drops.empty());
}

TEST_CASE("a pond in a basin gets level") {
  Film f(basin(12, 6));
  for (int i = 0; i < 60; ++i) {
    f.film.add(f.cell(4, 1, 4), toPicolitres(0.03e-6));
    f.run(1);
  }
  f.run(1200);
  double least = 1, most = 0;
  for (int x = 3; x < 9; ++x)
    for (int z = 3; z < 9; ++z) {
      // On the floor; its rows beside the wall carry what stands in the corner.
      if (x == 3 || x == 8 || z == 3 || z == 8) continue;
      const double t = f.thickness(f.cell(x, 1, z));
      least = std::min(least, t), most = std::max(most, t);
    }
  CHECK(most > 0.5e-3);
  CHECK(most - least < 0.25 * most);
}

TEST_CASE("dry skin is wetted by a thick film only: a little blood stays where it is") {
  Film f(organOf(test::fullBlock({9, 3, 9}, kSide)));
  f.film.add(f.cell(4, 2, 4), toPicolitres(0.3e-3 * kSide * kSide));  // a film of 0.3 mm
  f.run(300);
  CHECK(f.film.wet().size() == 1);
  f.film.add(f.cell(4, 2, 4), toPicolitres(5e-3 * kSide * kSide));
  f.run(300);
  CHECK(f.film.wet().size() > 4);
}

TEST_CASE("blood of a removed cell goes to the skin beside it") {
  Film f(organOf(test::fullBlock({9, 3, 9}, kSide)));
  const std::int64_t cell = f.cell(4, 2, 4);
  const Picolitres poured = toPicolitres(0.3e-3 * kSide * kSide);
  f.film.add(cell, poured);
  f.run(1);
  removeParticle(f.organ.organ, cell);
  f.organ.tissue->remove(cell);
  std::vector<OpenedFaces> opened;
  f.film.renew(f.organ, {&cell, 1}, f.drops, opened);
  CHECK(f.all() == poured);
  int faces = 0;
  for (const OpenedFaces& o : opened) faces += o.faces;
  CHECK(faces == 5);  // of its five neighbours
  f.run(10);
  CHECK(f.all() == poured);
}

TEST_CASE(
    "a severed bond makes a slit: both its cells have skin there, and blood does not cross it") {
  Film f(organOf(test::fullBlock({9, 5, 9}, kSide)));
  const Vec3i inside(4, 2, 4);
  const std::int64_t cell = f.organ.organ.rest.lattice.index(inside);
  CHECK_FALSE(f.film.skin().isSkin(f.film.skin().numberOf(cell)));
  f.organ.tissue->sever(cell, directionTo({1, 0, 0}));
  std::vector<OpenedFaces> opened;
  f.film.renew(f.organ, {&cell, 1}, f.drops, opened);
  const SkinCell& lip = f.film.skin()[f.film.skin().numberOf(cell)];
  CHECK(lip.skin);
  CHECK(lip.slit);
  CHECK((lip.ways >> directionTo({1, 0, 0}) & 1) == 0);
  CHECK(opened.size() == 2);
}

TEST_CASE("clotting takes blood out of the flow, in minutes") {
  Film f(basin(12, 6));
  f.film.add(f.cell(5, 1, 5), toPicolitres(0.5e-6));
  f.run(60 * 60);  // a minute
  const FilmVolumes v = f.film.volumes();
  const double share = double(v.clotted) / double(v.clotted + v.liquid);
  CHECK(share == doctest::Approx(1 - std::exp(-60.0 / 480)).epsilon(0.02));
}
