#include "inventor/reading/iv_guard.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "support/malformed/malformed.h"
#include "support/sentence.h"

using namespace resect;
using test::kInventorHead;

namespace {

std::string sentenceOfGuard(const std::string& body) {
  return test::sentenceOf([&] { guardInventorFile("a.iv", kInventorHead + body); });
}

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

}  // namespace

TEST_CASE("headers are told apart and named") {
  CHECK(isInventorFile("#Inventor V1.0 binary   \n"));
  CHECK(isInventorFile("#VRML V2.0 utf8\n"));
  CHECK_FALSE(isInventorFile("# Inventor"));
  CHECK_FALSE(isInventorFile(""));
  CHECK(inventorFormat("#Inventor V2.1 binary  \nxxx") == "Inventor V2.1 binary");
  CHECK(inventorFormat("#VRML V2.0 utf8 made by hand\n") == "VRML V2.0 utf8");
  CHECK(inventorFormat("nothing") == "Inventor");
}

TEST_CASE("ordinary scenes pass") {
  CHECK(sentenceOfGuard("").empty());
  CHECK(sentenceOfGuard("Separator { DEF a Cube { width 2 } USE a } # { [ not counted\n").empty());
  CHECK(sentenceOfGuard("Info { string \"a { brace, a \\\" quote and a # too\" }").empty());
  CHECK(sentenceOfGuard(repeated("Separator {", 400) + repeated("}", 400)).empty());
  CHECK(sentenceOfGuard("PROTO Ball [ ] { Sphere { } } Ball { }").empty());
  // The same name may be defined again inside.
  CHECK(sentenceOfGuard("DEF a Separator { DEF a Cube { } } USE a").empty());
}

TEST_CASE("what kills Coin is refused with its line") {
  const auto refuses = [](const std::string& body, const std::string& expected) {
    const std::string text = sentenceOfGuard(body);
    CHECK_MESSAGE(text.find(expected) != std::string::npos, text);
    CHECK(text.find('\n') == std::string::npos);
  };
  refuses(repeated("Separator {\n", 501), "a.iv:502: nested more than 500 deep");
  refuses("\n" + std::string(201, 'x'), "a.iv:3: a word of 201 characters");
  refuses("Separator {\n Cube { }", "a.iv:3: the file ends inside a '{' opened on line 2");
  refuses("Info { string \"open", "a.iv:2: the string that begins here never ends");
  refuses("Separator { ] }", "a.iv:2: a ']' without its '['");
  refuses("}", "a.iv:2: a '}' without its '{'");
  refuses("DEF a Separator {\n USE a }", "a.iv:3: 'a' is used inside itself");
  refuses("DEF a Separator { Group { USE a } }", "'a' is used inside itself");
  refuses("PROTO P [ ] { Group { children P { } } }", "PROTO 'P' holds itself");
  // Lines of older Macintosh files end with \r.
  CHECK(test::tells(test::sentenceOf([&] {
                      guardInventorFile("a.iv",
                                        "#Inventor V2.1 ascii\r# note\rDEF a Group {\rUSE a }");
                    }),
                    "a.iv:4: 'a' is used inside itself"));
}
