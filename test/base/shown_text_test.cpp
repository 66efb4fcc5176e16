#include "base/text/shown_text.h"

#include <doctest/doctest.h>

using namespace resect;

TEST_CASE("plain text of any writing is shown as it is") {
  for (const char* text :
       {"", "liver", "a\\n \"b\" 'c'", "Leber, foie, \u809d\u81d3, \u05db\u05d1\u05d3, \U0001f52a"})
    CHECK(shownText(text) == text);
}

TEST_CASE("control characters and line ends are shown by their names") {
  CHECK(shownText("a\nb\r\nc\td") == "a\\nb\\r\\nc\\td");
  CHECK(shownText("\x1b[31mred\x07\x7f") == "\\x1b[31mred\\x07\\x7f");
  CHECK(shownText(std::string_view("a\0b", 3)) == "a\\x00b");
  CHECK(shownText("\u0085\u009b2J") == "\\u0085\\u009b2J");
}

TEST_CASE("marks that turn or hide writing are shown by their numbers") {
  CHECK(shownText("a\u202eb\u2066c\u2028d") == "a\\u202eb\\u2066c\\u2028d");
  CHECK(shownText("\u200b\ufeff\u00ad\u061c") == "\\u200b\\ufeff\\u00ad\\u061c");
  CHECK(shownText("\U000e0041") == "\\U000e0041");
}

TEST_CASE("bytes that are no UTF-8 are shown as bytes") {
  CHECK(shownText("a\xff\xc3") == "a\\xff\\xc3");
  CHECK(shownText("\xc0\x8a") == "\\xc0\\x8a");           // a newline in too many bytes
  CHECK(shownText("\xe0\x80\x8a") == "\\xe0\\x80\\x8a");  // the same
  CHECK(shownText("\xed\xa0\x80") == "\\xed\\xa0\\x80");  // a surrogate
  CHECK(shownText("\xf4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");
  CHECK(shownText("\xe2\x80") == "\\xe2\\x80");
  CHECK(shownText("\xe2\x80\nb") == "\\xe2\\x80\\nb");
}

TEST_CASE("of a long text the beginning and the end are shown") {
  const std::string most(kLongestShown, 'x');
  CHECK(shownText(most) == most);
  const std::string shortened = shownText("begin" + std::string(100'000, 'x') + "end");
  CHECK(shortened.size() == kLongestShown);
  CHECK(shortened.starts_with("begin"));
  CHECK(shortened.ends_with("end"));
  CHECK(shortened.find("x ... x") != shortened.npos);
  // No character and no escape is cut in two.
  std::string wide;
  for (int i = 0; i < 1000; ++i) wide += "\u00e9";
  CHECK(shownText(shownText(wide)) == shownText(wide));
  CHECK(shownText(std::string(1000, '\n')).starts_with("\\n\\n"));
}
