#include "support/malformed/malformed.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/random.h"

namespace resect::test {
namespace {

// One random edit of the kind a bad disk, a bad transfer or a bad editor makes.
void damage(std::string& bytes, Random& random) {
  if (bytes.empty()) return;
  const auto at = std::size_t(random.below(int(bytes.size())));
  const std::size_t lineStart = at == 0 ? 0 : bytes.rfind('\n', at - 1) + 1;
  const std::size_t lineEnd = std::min(bytes.find('\n', at), bytes.size() - 1) + 1;
  const std::string line =
      lineEnd > lineStart ? bytes.substr(lineStart, lineEnd - lineStart) : std::string();
  switch (random.below(8)) {
    case 0:  // one bit
      bytes[at] = char(bytes[at] ^ (1 << random.below(8)));
      break;
    case 1:  // any byte
      bytes[at] = char(random.below(256));
      break;
    case 2:  // cut off
      bytes.resize(at);
      break;
    case 3:  // a line lost
      bytes.erase(lineStart, line.size());
      break;
    case 4:  // a line twice
      bytes.insert(lineStart, line);
      break;
    case 5:  // an absurd number
      bytes.insert(at, random.below(2) ? "-99999999999999999999" : "nan");
      break;
    case 6:  // a block lost
      bytes.erase(at, 1 + std::size_t(random.below(64)));
      break;
    default:  // noise at the end
      for (int i = 0; i < 32; ++i) bytes += char(random.below(256));
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  if (const std::size_t at = text.find(from); at != std::string::npos)
    text.replace(at, from.size(), to);
  return text;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

// Edits that every line-oriented text should be tried with, then random ones up to `count`.
std::vector<BadFile> damagedText(const std::string& valid, const std::string& extension, int count,
                                 unsigned seed) {
  std::vector<BadFile> files;
  const auto add = [&](const std::string& name, const std::string& bytes, bool mayBeFine = false) {
    files.push_back({name + extension, bytes, mayBeFine});
  };
  const std::vector<std::string> lines = linesOf(valid);
  add("empty", "");
  add("only_newlines", "\n\n\n\n");
  add("binary_noise", [] {
    Random random(11);
    std::string bytes;
    for (int i = 0; i < 4000; ++i) bytes += char(random.below(256));
    return bytes;
  }());
  add("zeros", std::string(1000, '\0'));
  add("endless_line", std::string(1'000'000, '7'));
  add("endless_brackets", std::string(200'000, '['));
  add("other_format", "#Inventor V2.1 ascii\nSeparator { }\n");
  add("trailing_garbage", valid + "\n%%% garbage 1 2 3\n");
  add("first_line_lost", joined({lines.begin() + 1, lines.end()}), true);
  add("last_line_lost", joined({lines.begin(), lines.end() - 1}), true);
  add("cut_in_the_middle", valid.substr(0, valid.size() / 2), true);
  add("windows_line_ends", replaced(valid, "\n", "\r\n"), true);
  const std::size_t digit = valid.find_first_of("0123456789");
  if (digit != std::string::npos)
    for (const char* number :
         {"nan", "-1", "1e999", "99999999999999999999", "0x", "1,5", "--", "\"\""}) {
      std::string bytes = valid;
      std::size_t end = bytes.find_first_not_of("0123456789.eE+-", digit);
      bytes.replace(digit, std::min(end, bytes.size()) - digit, number);
      add(fmt::format("first_number_{}", files.size()), bytes, true);
    }
  for (BadFile& file : mutated(valid, extension, count - int(files.size()), seed))
    files.push_back(std::move(file));
  return files;
}

}  // namespace

std::vector<BadFile> mutated(std::string_view valid, const std::string& extension, int count,
                             unsigned seed) {
  std::vector<BadFile> files;
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    std::string bytes(valid);
    for (int edits = 1 + random.below(4); edits > 0; --edits) damage(bytes, random);
    files.push_back({fmt::format("mutated_{:02}{}", i, extension), std::move(bytes), true});
  }
  return files;
}

std::vector<BadFile> malformedDiscretizations(const std::string& valid) {
  return damagedText(valid, ".dis", 40, 21);
}

std::vector<BadFile> malformedScenarios(const std::string& valid) {
  return damagedText(valid, ".toml", 40, 22);
}

}  // namespace resect::test
