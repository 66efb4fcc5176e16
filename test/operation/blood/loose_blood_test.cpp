#include "operation/blood/loose_blood.h"

#include <doctest/doctest.h>

#include <numeric>

#include "operation/blood/bleeding_block.h"

using namespace resect;
using test::kCut;

TEST_CASE("puddles are shown with all of their blood, and slope to their borders") {
  Simulation simulation = test::bleedingBlock();
  CHECK(!looseBlood(simulation.blood()));
  test::step(simulation, {{0, -1, Incision{test::acrossX(kCut.x(), 0.01, 0.05)}}});
  for (int i = 0; i < 200; ++i) test::step(simulation);
  const auto blood = looseBlood(simulation.blood());
  REQUIRE(blood);
  REQUIRE(blood->pool.size() == std::size_t(kTableCells) * kTableCells);
  const double pools = toCubicMetres(simulation.blood().ledger().pools);
  REQUIRE(pools > 1e-6);
  const double shown = std::accumulate(blood->pool.begin(), blood->pool.end(), 0.0) / 255 *
                       LooseBlood::kDeepest * kTableCell * kTableCell;
  CHECK(shown == doctest::Approx(pools).epsilon(0.03));
  // Steps from a patch to the next are at most half of the deepest patch.
  int deepest = 0, steepest = 0;
  for (int z = 0; z < kTableCells; ++z)
    for (int x = 1; x < kTableCells; ++x) {
      const std::size_t at = std::size_t(z * kTableCells + x);
      deepest = std::max<int>(deepest, blood->pool[at]);
      steepest = std::max(steepest, std::abs(int(blood->pool[at]) - int(blood->pool[at - 1])));
    }
  REQUIRE(deepest > 10);
  CHECK(steepest <= deepest / 2 + 1);
}
