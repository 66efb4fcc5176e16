#include "formats/meshes/word_reader.h"

#include <doctest/doctest.h>

#include <cmath>

#include "support/sentence.h"

using namespace resect;

TEST_CASE("numbers are read as programs print them") {
  const std::pair<const char*, double> forms[] = {
      {"0.5", 0.5},
      {".5", 0.5},
      {"-.5", -0.5},
      {"+.5", 0.5},
      {"5.", 5},
      {"+5", 5},
      {"-0", 0},
      {"5e-1", 0.5},
      {"5E-1", 0.5},
      {"5.E+1", 50},
      {"5d-1", 0.5},
      {"-1.5D+01", -15},
      {"1e-400", 0},
      {"-1e-400", 0},
      {"0.1000000000000000055511151231257827", 0.1},
      {"4.9e-324", 4.9e-324},
      {"0000.5", 0.5},
      {"1.7976931348623157e308", 1.7976931348623157e308}};
  for (const auto& [text, value] : forms) {
    CAPTURE(text);
    REQUIRE(numberOf(text));
    CHECK(*numberOf(text) == value);
  }
  CHECK(*numberOf("0." + std::string(400, '0') + "1") == 0);
  CHECK(std::isinf(*numberOf("1e400")));
  CHECK(std::isinf(*numberOf(std::string(400, '9'))));
  CHECK(std::isinf(*numberOf("-inf")));
}

TEST_CASE("what programs print for no number is read as such") {
  for (const char* text : {"nan", "NaN", "-nan", "-nan(ind)", "1.#QNAN", "-1.#IND", "1.#INF"}) {
    CAPTURE(text);
    REQUIRE(numberOf(text));
    CHECK(!std::isfinite(*numberOf(text)));
  }
}

TEST_CASE("words that are no numbers are none") {
  for (const char* text : {"", ".", "+", "-", "+-5", "++5", "x", "5x", "0x10", "1,5", "5e", "5d",
                           "1d1d1", "5..", "1 2"}) {
    CAPTURE(text);
    CHECK(!numberOf(text));
    CHECK(!wholeNumberOf(text));
  }
  CHECK(!wholeNumberOf("2.5"));
  CHECK(!wholeNumberOf("nan"));
  CHECK(!wholeNumberOf("1e300"));
}

TEST_CASE("whole numbers may be printed as real ones") {
  CHECK(*wholeNumberOf("1e+06") == 1'000'000);
  CHECK(*wholeNumberOf("3.0000") == 3);
  CHECK(*wholeNumberOf("-3.") == -3);
  CHECK(*wholeNumberOf("+7") == 7);
  CHECK(*wholeNumberOf("9223372036854775807") == 9223372036854775807);
}

TEST_CASE("lines are counted whatever ends them") {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const std::string path = "a.txt", text = std::string("one") + end + "two" + end + end + "four";
    WordReader words(path, text);
    CHECK(words.line() == "one");
    CHECK(words.where() == "a.txt:1");
    CHECK(words.word() == "two");
    CHECK(words.where() == "a.txt:2");
    CHECK(words.word() == "four");
    CHECK(words.where() == "a.txt:4");
    CHECK(words.word().empty());
    CHECK(words.atEnd());
  }
}

TEST_CASE("a byte order mark is skipped, and UTF-16 is named") {
  const std::string path = "a.obj";
  CHECK(WordReader(path, "\xef\xbb\xbfv 1").word() == "v");
  CHECK(plainText(path, std::string_view("\xef\xbb\xbf\r\n a b\n\0\x1a", 12)) == "a b");
  CHECK(plainText(path, "").empty());
  CHECK(plainText(path, " \n").empty());
  CHECK(test::refuses([&] { plainText(path, std::string_view("\xff\xfev\0", 4)); }, "UTF-16"));
  CHECK(test::refuses([&] { plainText(path, std::string_view("\xfe\xff\0v", 4)); }, "UTF-16"));
}

TEST_CASE("a number with a comma is named as such") {
  const std::string path = "a.stl";
  CHECK(
      test::refuses([&] { WordReader(path, "1 2,5 3").point(); }, "with points, not with commas"));
  CHECK(test::refuses([&] { WordReader(path, "1 x 3").point(); }, "has 'x' where a coordinate"));
  CHECK(test::refuses([&] { WordReader(path, "1 2").point(); }, "the file ends early"));
}
