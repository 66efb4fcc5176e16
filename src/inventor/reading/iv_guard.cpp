#include "inventor/reading/iv_guard.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "base/error.h"

namespace resect {
namespace {

constexpr std::size_t kDeepest = 500;
constexpr std::size_t kLongestWord = 200;

enum CharKind : std::uint8_t { kOfWord, kDigit, kSpace, kBracket, kQuote, kComment };

constexpr std::array<CharKind, 256> kKinds = [] {
  std::array<CharKind, 256> kinds{};
  const auto set = [&](std::string_view chars, CharKind kind) {
    for (const char c : chars) kinds[static_cast<unsigned char>(c)] = kind;
  };
  set("0123456789", kDigit);
  set(" ,\t\n\v\f\r", kSpace);
  set("{}[]", kBracket);
  set("\"", kQuote);
  set("#", kComment);
  return kinds;
}();

CharKind kindOf(char c) { return kKinds[static_cast<unsigned char>(c)]; }

// Nearly all words of a large model are numbers, which are harmless: they determine the guard's
// cost, some 20 cycles each and one for every byte.
bool isNumber(std::string_view word) {
  return kindOf(word[0]) == kDigit ||
         (word.size() > 1 && (word[0] == '-' || word[0] == '+' || word[0] == '.') &&
          (kindOf(word[1]) == kDigit || word[1] == '.'));
}

class TextGuard {
 public:
  TextGuard(const std::string& path, std::string_view bytes) : path_(path), bytes_(bytes) {}

  void check() {
    for (std::string_view word = next(); !word.empty(); word = next()) {
      if (word == "{" || word == "[")
        open(word);
      else if (word == "}" || word == "]")
        close(word);
      else
        take(word);
      before_ = keywordOf(word);
    }
    if (!open_.empty())
      throw error(
          "{}:{}: the file ends inside a '{}' opened on line {}; it is cut off, export it "
          "again",
          path_, line_, open_.back().bracket, open_.back().line);
  }

 private:
  struct Bracket {
    char bracket;
    int line;
    std::string_view defined;  // name of the DEF or PROTO with this body
    bool proto = false;
  };
  enum class Keyword : std::uint8_t { None, Def, Use, Proto };

  static Keyword keywordOf(std::string_view word) {
    if (word == "DEF") return Keyword::Def;
    if (word == "USE") return Keyword::Use;
    return word == "PROTO" ? Keyword::Proto : Keyword::None;
  }

  // The next word, bracket or whole string; empty at the end.
  std::string_view next() {
    skipSpace();
    const std::size_t begin = at_;
    if (at_ == bytes_.size()) return {};
    const CharKind kind = kindOf(bytes_[at_]);
    if (kind == kBracket) return bytes_.substr(at_++, 1);
    if (kind == kQuote) {
      skipString();
      return bytes_.substr(begin, at_ - begin);
    }
    while (at_ < bytes_.size() && kindOf(bytes_[at_]) <= kDigit) ++at_;
    if (at_ - begin > kLongestWord)
      throw error("{}:{}: a word of {} characters; export the model again", path_, line_,
                  at_ - begin);
    return bytes_.substr(begin, at_ - begin);
  }

  void skipSpace() {
    for (; at_ < bytes_.size(); ++at_) {
      const char c = bytes_[at_];
      // Lines end with \n, \r\n or \r.
      line_ += c == '\n' || (c == '\r' && !bytes_.substr(at_ + 1).starts_with('\n'));
      if (kindOf(c) == kSpace) continue;
      if (kindOf(c) != kComment) return;
      // Skips to the end of the line, which the next iteration counts.
      at_ = std::min(bytes_.find_first_of("\r\n", at_), bytes_.size()) - 1;
    }
  }

  void skipString() {
    const int firstLine = line_;
    for (++at_; at_ < bytes_.size() && bytes_[at_] != '"'; ++at_) {
      line_ += bytes_[at_] == '\n';
      if (bytes_[at_] == '\\') ++at_;
    }
    if (at_ >= bytes_.size())
      throw error("{}:{}: the string that begins here never ends; export the model again", path_,
                  firstLine);
    ++at_;
  }

  void open(std::string_view word) {
    if (open_.size() >= kDeepest)
      throw error("{}:{}: nested more than {} deep; flatten the model", path_, line_, kDeepest);
    Bracket bracket{word[0], line_, {}};
    if (word == "{") {
      bracket.defined = pending_;
      bracket.proto = pendingIsProto_;
      pending_ = {};
      pendingIsProto_ = false;
    }
    open_.push_back(bracket);
  }

  void close(std::string_view word) {
    const char partner = word == "}" ? '{' : '[';
    if (open_.empty() || open_.back().bracket != partner)
      throw error("{}:{}: a '{}' without its '{}'; export the model again", path_, line_, word,
                  partner);
    open_.pop_back();
  }

  void take(std::string_view word) {
    if (before_ == Keyword::Def) {
      pending_ = word;
    } else if (before_ == Keyword::Proto) {
      pending_ = word;
      pendingIsProto_ = true;
    } else if (before_ == Keyword::Use) {
      for (const Bracket& b : open_)
        if (!b.proto && b.defined == word)
          throw error("{}:{}: '{}' is used inside itself; export the model again", path_, line_,
                      word);
    } else if (isNumber(word)) {
      return;  // not a valid name of a node or PROTO: Coin rejects it
    } else {
      for (const Bracket& b : open_)
        if (b.proto && b.defined == word)
          throw error("{}:{}: the PROTO '{}' holds itself; export the model again", path_, line_,
                      word);
    }
  }

  const std::string& path_;
  std::string_view bytes_;
  std::size_t at_ = 0;
  int line_ = 1;
  Keyword before_ = Keyword::None;
  std::string_view pending_;
  bool pendingIsProto_ = false;
  std::vector<Bracket> open_;
};

std::string_view headerLine(std::string_view bytes) {
  return bytes.substr(0, std::min(bytes.find_first_of("\r\n"), std::size_t(80)));
}

}  // namespace

bool isInventorFile(std::string_view bytes) {
  return bytes.starts_with("#Inventor V") || bytes.starts_with("#VRML V");
}

std::string inventorFormat(std::string_view bytes) {
  std::string_view line = headerLine(bytes);
  if (!line.starts_with('#')) return "Inventor";
  line.remove_prefix(1);
  // Name, version and encoding; the rest of the line is arbitrary.
  std::size_t end = 0;
  for (int words = 0; words < 3 && end < line.size(); ++words)
    end = std::min(line.find(' ', end + 1), line.size());
  std::string name;
  for (const char c : line.substr(0, end)) name += c >= ' ' && c <= '~' ? c : '?';
  return name;
}

void guardInventorFile(const std::string& path, std::string_view bytes) {
  if (headerLine(bytes).find("binary") == std::string_view::npos) TextGuard(path, bytes).check();
}

}  // namespace resect
