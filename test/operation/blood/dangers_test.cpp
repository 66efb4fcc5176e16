#include "operation/blood/dangers.h"

#include <doctest/doctest.h>

using namespace resect;

TEST_CASE("nothing is dangerous after a small loss; the end's bleeding, the loss and air are") {
  BloodSummary blood;
  blood.ledger.bled = toPicolitres(700e-6);
  blood.rate = 40e-6 / 60;
  blood.air = 40e-6;
  CHECK(dangersOf(blood).empty());
  blood.rate = 60e-6 / 60;
  CutVesselSummary vein;
  vein.name = "left hepatic vein", vein.diameter = 0.0042, vein.flow = 50e-6 / 60;
  blood.vessels.push_back(vein);
  blood.ledger.bled = toPicolitres(1600e-6);
  blood.air = 250e-6;
  const std::vector<std::string> told = dangersOf(blood);
  REQUIRE(told.size() == 3);
  CHECK(
      told[0] ==
      "at the end 60 ml/min bleed, grade 4 of 4, most of it from the left hepatic vein of 4.2 mm");
  CHECK(told[1] == "1600 ml of blood are lost, 32.0 % of all: haemorrhage of class III");
  CHECK(haemorrhageClass(740e-6) == 1);
  CHECK(haemorrhageClass(760e-6) == 2);
  CHECK(haemorrhageClass(2100e-6) == 4);
  CHECK(told[2] == "open hepatic veins drew in 250 ml of air; 200 to 300 ml kill");
}
