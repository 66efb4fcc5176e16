#include "io/scenario/toml_limits.h"

#include <algorithm>

#include "base/error.h"

namespace resect {
namespace {

class Scanner {
 public:
  Scanner(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  void scan() {
    if (text_.size() > kMostTomlBytes)
      throw error("{} is larger than {} MB, no settings file is; check the name", name_,
                  kMostTomlBytes >> 20);
    if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;  // byte order mark
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"' || c == '\'') {
        // The parser would read it as part of the word, and what follows as no text.
        limit(word_ == 0, "a quote stands within a word");
        skipText(c);
      } else if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else {
        note(c);
        ++at_;
      }
    }
  }

 private:
  static bool isAscii(char c) { return static_cast<unsigned char>(c) < 0x80; }

  template <typename... Args>
  void limit(bool within, fmt::format_string<Args...> what, Args&&... args) const {
    if (!within)
      throw error("{}:{}: {}; that is no settings file", name_, line_,
                  fmt::format(what, std::forward<Args>(args)...));
  }

  // A character outside texts and comments. TOML has only ASCII there.
  void note(char c) {
    limit(isAscii(c), "a character that is not ASCII stands outside quotes and comments");
    const bool opens = c == '[' || c == '{', closes = c == ']' || c == '}';
    depth_ += opens ? 1 : closes ? -1 : 0;
    limit(depth_ <= kDeepestToml, "brackets are nested more than {} deep", kDeepestToml);
    const bool separates = opens || closes || c == ',' || c == '=' || c == '\n';
    dots_ = separates ? 0 : dots_ + (c == '.');
    limit(dots_ < kDeepestToml, "a key has more than {} parts", kDeepestToml);
    word_ = separates || c == '.' || c == ' ' || c == '\t' || c == '\r' ? 0 : word_ + 1;
    limit(word_ <= kLongestTomlWord, "a key or a number has more than {} characters",
          kLongestTomlWord);
    values_ += c == ',' || c == '=' || opens;
    limit(values_ <= kMostTomlValues, "there are more than {} values", kMostTomlValues);
    line_ += c == '\n';
  }

  // A text from its first quote to behind its last, or to where the parser will refuse it.
  void skipText(char quote) {
    const std::string three(3, quote);
    const bool lines = text_.substr(at_).starts_with(three);
    const std::size_t begin = at_ += lines ? 3 : 1;
    int ends = 0;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (lines ? text_.substr(at_).starts_with(three) : c == quote || c == '\n') break;
      if (c == '\\' && quote == '"' && at_ + 1 < text_.size()) {
        const std::size_t after = text_.find_first_not_of(" \t\r\n", at_ + 1);
        limit(after == text_.npos || after == at_ + 1 || isAscii(text_[after]),
              "a line that begins with a character that is not ASCII follows a '\\'");
        ++at_;
      }
      ends += text_[at_] == '\n';
      ++at_;
    }
    limit(at_ <= begin + kLongestTomlText, "a text has more than {} characters", kLongestTomlText);
    line_ += ends;
    if (at_ < text_.size() && text_[at_] == quote) at_ += lines ? 3 : 1;
    // Up to two quotes can stand before the three that end a text of lines.
    for (int i = 0; lines && i < 2 && at_ < text_.size() && text_[at_] == quote; ++i) ++at_;
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0, values_ = 0, word_ = 0;
  int line_ = 1, depth_ = 0, dots_ = 0;
};

}  // namespace

void requireParsable(std::string_view text, const std::string& name) { Scanner(text, name).scan(); }

}  // namespace resect
