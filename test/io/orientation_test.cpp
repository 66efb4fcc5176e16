#include "io/scenario/orientation.h"

#include <doctest/doctest.h>

#include "support/sentence.h"

using namespace resect;

namespace {

bool turns(const Eigen::Quaterniond& turn, const Vec3& from, const Vec3& to) {
  return (turn * from - to).norm() < 1e-12;
}

}  // namespace

TEST_CASE("letters of an orientation say where a model's axes point to in the room") {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  const Eigen::Quaterniond lps = orientationOf("LPS");
  CHECK(turns(lps, x, x));   // to the patient's left
  CHECK(turns(lps, y, -y));  // to the back: down
  CHECK(turns(lps, z, -z));  // to the head: away from the surgeon
  const Eigen::Quaterniond ras = orientationOf("ras");
  CHECK(turns(ras, x, -x));
  CHECK(turns(ras, y, y));
  CHECK(turns(ras, z, -z));
  CHECK(turns(orientationOf("LAF"), x + 2 * y + 3 * z, x + 2 * y + 3 * z));
  CHECK(turns(orientationOf("PIR"), x, -y));
  CHECK(turns(orientationOf("PIR"), y, z));
  CHECK(turns(orientationOf("PIR"), z, -x));
}

TEST_CASE("of the letters that name three axes half are right-handed, and the others are refused") {
  const std::string letters = "LRAPSI";
  int good = 0, mirrored = 0, wrong = 0;
  for (const char a : letters)
    for (const char b : letters)
      for (const char c : letters) {
        const std::string three{a, b, c};
        const std::string sentence = test::sentenceOf([&] { orientationOf(three); });
        ++(sentence.empty() ? good : test::tells(sentence, "left-handed") ? mirrored : wrong);
      }
  CHECK(good == 24);
  CHECK(mirrored == 24);
  CHECK(wrong == 216 - 48);
  for (const char* text : {"", "LP", "LPSS", "XYZ"})
    CHECK(test::refuses([&] { orientationOf(text); }, "as LPS or RAS"));
}

TEST_CASE("a turn is about the room's X, then Y, then Z axis") {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  CHECK(turns(turnOf("90,0,0"), y, z));
  CHECK(turns(turnOf("0,90,0"), z, x));
  CHECK(turns(turnOf("0,0,90"), x, y));
  CHECK(turns(turnOf("90,90,0"), y, x));  // first to Z, then Z to X
  for (const char* text : {"", "90", "1,2", "1,2,3,", "1,2,3,4", "a,b,c", "1e9,0,0", "nan,0,0"})
    CHECK(test::refuses([&] { turnOf(text); }, "as 0,90,0"));
}
