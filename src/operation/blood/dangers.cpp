#include "operation/blood/dangers.h"

#include <fmt/format.h>

#include <array>

namespace resect {
namespace {

constexpr int kGravest = 4;  // VIBe
// Shares of the blood above which haemorrhage of class III and of class IV begins.
constexpr double kClassThree = 0.3, kClassFour = 0.4;

}  // namespace

int haemorrhageClass(double lost) {
  const double share = lost / Circulation{}.volume;
  return share > kClassFour ? 4 : share > kClassThree ? 3 : share > kBorneLoss ? 2 : 1;
}

std::vector<std::string> dangersOf(const BloodSummary& blood) {
  std::vector<std::string> sentences;
  if (bleedingGrade(blood.rate) >= kGravest) {
    const CutVesselSummary* most = nullptr;
    for (const CutVesselSummary& v : blood.vessels)
      if (v.flow > 0 && (!most || v.flow > most->flow)) most = &v;
    sentences.push_back(fmt::format(
        "at the end {:.0f} ml/min bleed, grade 4 of 4{}", 60e6 * blood.rate,
        most
            ? fmt::format(", most of it from the {} of {:.1f} mm", most->name, 1e3 * most->diameter)
            : ""));
  }
  const double bled = toCubicMetres(blood.ledger.bled);
  constexpr std::array kRoman = {"I", "II", "III", "IV"};
  if (const int grade = haemorrhageClass(bled); grade > 1)
    sentences.push_back(
        fmt::format("{:.0f} ml of blood are lost, {:.1f} % of all: haemorrhage of class {}",
                    1e6 * bled, 100 * bled / Circulation{}.volume, kRoman.at(grade - 1)));
  if (blood.air > kBorneAir)
    sentences.push_back(fmt::format(
        "open hepatic veins drew in {:.0f} ml of air; 200 to 300 ml kill", 1e6 * blood.air));
  return sentences;
}

}  // namespace resect
