#include "io/scenario/length.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include "base/error.h"
#include "support/sentence.h"

using namespace resect;

TEST_CASE("the same length in any unit is the same number") {
  for (const char* text : {"5mm", "0.5cm", "0.005m", "0.005", " 5 mm ", "5000um"})
    CHECK(parseLength(text, "--spacing") == 0.005);
  CHECK(parseLength("2in", "--spacing") == doctest::Approx(0.0508));
  CHECK(parseLength("-1mm", "x") == -0.001);
}

TEST_CASE("what is no length is refused in one sentence that names the argument") {
  for (const char* text :
       {"", "mm", "5 parsec", "5mm5", "nan", "inf", "1e400mm", "0x5mm", "five"}) {
    try {
      parseLength(text, "--spacing");
      FAIL("accepted " << text);
    } catch (const Error& e) {
      CHECK(std::string(e.what()).find("--spacing") == 0);
      CHECK(int(e.status()) == 2);
    }
  }
  for (const char* text : {"", "0", "-1", "nan", "mile"})
    CHECK_THROWS_AS(parseUnit(text, "--unit"), Error);
  for (const char* text : {"1e308", "inf", "1001", "1e-10"})
    CHECK(test::refuses([&] { parseUnit(text, "--unit"); }, "from 1e-09 to 1000"));
  CHECK(parseUnit("mm", "--unit") == 1e-3);
  CHECK(parseUnit("0.25", "--unit") == 0.25);
}

TEST_CASE("lengths are shown in the unit that people use") {
  CHECK(lengthText(0.005) == "5 mm");
  CHECK(lengthText(0.25) == "0.25 m");
}
