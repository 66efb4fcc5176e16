#include "io/scenario/toml_limits.h"

#include <doctest/doctest.h>

#include "io/scenario/toml_table.h"
#include "support/sentence.h"

using namespace resect;

namespace {

std::string times(int count, std::string_view text) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

// With 40000 more parts.
std::string deepKey(std::string_view part) { return fmt::format("a{} = 1", times(40000, part)); }

std::string refusalOfToml(const std::string& text) {
  return test::sentenceOf([&] { TomlTable::parse(text, "a.toml"); });
}

}  // namespace

TEST_CASE("keys of many parts and brackets in brackets are refused with their line") {
  const std::string many = times(40000, ".a"), after = deepKey(".a");
  for (const std::string& deep : {
           deepKey(".a"),
           deepKey(" . \"a\""),
           fmt::format("[a{}]", many),
           fmt::format("[[a{}]]", many),
           fmt::format("b = {{ {} }}", deepKey(".a")),
           fmt::format("a = {}", times(40000, "[")),
           fmt::format("a = {}", times(40000, "{ a = ")),
           // What looks like the end of a text or a comment to a careless reader.
           fmt::format("b = \"\"\"x\\\"\"\"\"\n{}", after),
           fmt::format("b = '''x'''''\n{}", after),
           fmt::format("b = \"\"\n{}", after),
           fmt::format("b = '\\'\n{}", after),
           fmt::format("b = 1 # \"\"\"\r\n{}", after),
       }) {
    const std::string text = "x = 1\n" + deep;
    CAPTURE(deep.substr(0, 40));
    const std::string sentence = refusalOfToml(text);
    const int line = deep.find('\n') == deep.npos ? 2 : 3;
    CHECK_MESSAGE(
        test::isRefusalOf(fmt::format("a.toml:{}: ", line), "that is no settings file", sentence),
        sentence);
  }
}

TEST_CASE("too long keys, texts and files and too many values are refused with their line") {
  CHECK(test::tells(refusalOfToml(fmt::format("x = 1\n\n{}", times(201, "k"))),
                    "a.toml:3: a key or a number"));
  CHECK(test::tells(refusalOfToml(fmt::format("x = '''\n\n{}'''", times(10001, "k"))),
                    "a.toml:1: a text"));
  CHECK(test::tells(refusalOfToml(fmt::format("x = [{}", times(600'000, "1,1,"))),
                    "a.toml:1: there are more than"));
  CHECK(test::tells(refusalOfToml(times(17 << 20, " ")), "a.toml is larger than 16 MB"));
}

TEST_CASE("texts and comments may hold brackets, dots and quotes") {
  const std::string dots = times(200, ".[{");
  for (const std::string& text :
       {fmt::format("a = \"{0}\\\"{0}\"", dots), fmt::format("a = '{}'", dots),
        fmt::format("a = \"\"\"\n{0}\n\"{0}\"\"\"\"\"", dots),
        fmt::format("a = '''{}\n'''''", dots),
        fmt::format("a = 'x' # {} \" ''' \"\"\" \n# {}", dots, times(30000, "x"))})
    CHECK(TomlTable::parse(text, "a.toml").text("a").size() > 0);
  CHECK(TomlTable::parse(fmt::format("a{} = 1", times(28, ".a")), "a.toml").has("a"));
}

TEST_CASE("outside quotes and comments there is only ASCII") {
  CHECK(test::tells(refusalOfToml("a = 1\n\xc3\xa4 = 2\n"),
                    "a.toml:2: a character that is not ASCII"));
  // What a quote within a word opens is no text for the parser.
  CHECK(test::tells(refusalOfToml("a = [5, 50.1.)\"45~r\xcb\x8d\"]\n"),
                    "a.toml:1: a quote stands within"));
  CHECK(test::tells(refusalOfToml("a = 5'\xcb\x8d'\n"), "a.toml:1: a quote stands within"));
  CHECK(test::tells(refusalOfToml("a = \"\"\"x \\\n \xc3\xa4\"\"\""),
                    "a.toml:1: a line that begins"));
  CHECK(TomlTable::parse("\xef\xbb\xbf"
                         "a = \"\xc3\xa4\" # \xc3\xb6",
                         "a.toml")
            .text("a") == "\xc3\xa4");
}

TEST_CASE("a key that the parser cannot take is refused with its line") {
  CHECK(test::tells(refusalOfToml("a = 1\nb = 2\n\n= 3\nc = 4\n"), "a.toml:4: "));
  CHECK(test::tells(refusalOfToml("a = 1\nb = 2\n\n\x01k = 3\nc = 4\n"), "a.toml:4: "));
}
