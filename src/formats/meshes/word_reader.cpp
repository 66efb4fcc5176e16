#include "formats/meshes/word_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/text/shown_text.h"

namespace resect {
namespace {

bool isSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r') || c == '\0' || c == 0x1a; }

// Whether a number that no double can hold is too small rather than too large.
bool isTiny(std::string_view word) {
  const std::size_t exponent = word.find_first_of("eE");
  if (exponent != word.npos) return word.substr(exponent + 1).starts_with('-');
  return word.find_first_of("123456789") > word.find('.');
}

std::string_view withoutPlus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+') word.remove_prefix(1);
  return word;
}

}  // namespace

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return lower;
}

std::optional<double> numberOf(std::string_view word) {
  word = withoutPlus(word);
  const char* const last = word.data() + word.size();
  double value = 0;
  const auto [end, status] = std::from_chars(word.data(), last, value);
  if (status == std::errc::result_out_of_range && end == last)
    return isTiny(word) ? 0 : std::numeric_limits<double>::infinity();
  if (status != std::errc()) return std::nullopt;
  if (end == last) return value;
  if (word.substr(std::size_t(end - word.data())).starts_with("#"))  // Microsoft's "1.#QNAN"
    return std::numeric_limits<double>::quiet_NaN();
  if (*end != 'd' && *end != 'D') return std::nullopt;
  std::string plain(word);
  plain[std::size_t(end - word.data())] = 'e';
  return plain.find_first_of("dD") == plain.npos ? numberOf(plain) : std::nullopt;
}

std::optional<std::int64_t> wholeNumberOf(std::string_view word) {
  word = withoutPlus(word);
  const char* const last = word.data() + word.size();
  std::int64_t value = 0;
  const auto [end, status] = std::from_chars(word.data(), last, value);
  if (status == std::errc() && end == last) return value;
  constexpr double kMost = 9007199254740992;  // beyond it not every whole number is a double
  const std::optional<double> real = numberOf(word);
  if (!real || !(std::abs(*real) <= kMost) || *real != std::floor(*real)) return std::nullopt;
  return std::int64_t(*real);
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isSpace(text.front())) text.remove_prefix(1);
  while (!text.empty() && isSpace(text.back())) text.remove_suffix(1);
  return text;
}

std::uint32_t littleEndian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i > 0; --i)
    value = value << 8 | static_cast<unsigned char>(bytes[at + i - 1]);
  return value;
}

std::string_view plainText(const std::string& path, std::string_view bytes) {
  if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff"))
    throw error("{}: is UTF-16 text; save it as plain text (ASCII or UTF-8)", path);
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  return trimmed(bytes);
}

WordReader::WordReader(const std::string& path, std::string_view bytes)
    : path_(path), bytes_(bytes) {
  if (bytes.starts_with(kByteOrderMark)) goTo(kByteOrderMark.size());
}

std::string_view WordReader::word() {
  while (at_ < bytes_.size() && isSpace(bytes_[at_])) ++at_;
  const std::size_t begin = read_ = at_;
  while (at_ < bytes_.size() && !isSpace(bytes_[at_])) ++at_;
  return bytes_.substr(begin, at_ - begin);
}

std::string_view WordReader::line() {
  const std::size_t begin = read_ = at_;
  const std::size_t end = std::min(bytes_.find_first_of("\r\n", at_), bytes_.size());
  at_ = end + (bytes_.substr(end).starts_with("\r\n") ? 2 : 1);
  at_ = std::min(at_, bytes_.size());
  return bytes_.substr(begin, end - begin);
}

double WordReader::number(const char* what) {
  const std::string_view text = word();
  const std::optional<double> value = numberOf(text);
  if (!value) throw unexpected(text, what);
  return *value;
}

std::int64_t WordReader::wholeNumber(const char* what) {
  const std::string_view text = word();
  const std::optional<std::int64_t> value = wholeNumberOf(text);
  if (!value) throw unexpected(text, what);
  return *value;
}

Vec3 WordReader::point() {
  Vec3 p;
  for (int k = 0; k < 3; ++k) p[k] = number("a coordinate");
  return p;
}

std::string WordReader::where() const {
  const std::string_view before = bytes_.substr(0, read_);
  std::int64_t lines = 1;
  for (std::size_t i = 0; i < before.size(); ++i)
    lines += before[i] == '\n' || (before[i] == '\r' && !bytes_.substr(i).starts_with("\r\n"));
  return fmt::format("{}:{}", path_, lines);
}

Error WordReader::unexpected(std::string_view word, std::string_view what) const {
  if (word.empty()) return fail("the file ends early, where {} should be", what);
  const std::string shown = shownText(word, 30);
  if (word.find(',') != word.npos && word.find_first_of("0123456789") != word.npos)
    return error("{}: has '{}' where {} should be; write numbers with points, not with commas",
                 where(), shown, what);
  return fail("has '{}' where {} should be", shown, what);
}

}  // namespace resect
