// Is an argument that cannot be right refused in one sentence, and nothing done?
#include <doctest/doctest.h>

#include "support/sentence.h"

using namespace resect;

TEST_CASE("what is required and does not hold is told in a sentence, as a wrong argument") {
  CHECK(test::sentenceOf([] { require(true, "{} is fine", 1); }).empty());
  CHECK(test::sentenceOf([] { require(2 < 1, "{} is not below {}; give less", 2, 1); }) ==
        "2 is not below 1; give less");
  try {
    require(false, "nothing is right");
  } catch (const Error& e) {
    CHECK(e.status() == Error::Status::Usage);
  }
}
