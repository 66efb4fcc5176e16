#include "base/state/run_length.h"

#include <algorithm>
#include <cstring>

#include "base/error.h"

namespace resect {
namespace {

enum Which : unsigned { kWords, kAgain, kZeros, kOnes };

constexpr std::size_t kLikelyGrowth = 64;  // initial guess: unpacked size over packed size
constexpr std::size_t kShortestRun = 3;    // words: shorter runs are cheaper as literals

template <typename Word>
void appendRunsOf(Bytes& to, std::span<const std::byte> data) {
  const std::size_t count = data.size() / sizeof(Word);
  const auto at = [&](std::size_t i) {
    Word word;
    std::memcpy(&word, data.data() + i * sizeof(Word), sizeof word);
    return word;
  };
  const auto append = [&](std::size_t begin, std::size_t words) {
    to.insert(to.end(), data.begin() + std::ptrdiff_t(begin * sizeof(Word)),
              data.begin() + std::ptrdiff_t((begin + words) * sizeof(Word)));
  };
  std::size_t written = 0;
  for (std::size_t i = 0; i < count;) {
    const Word word = at(i);
    std::size_t end = i + 1;
    while (end < count && at(end) == word) ++end;
    if (end - i >= kShortestRun) {
      if (written < i) {
        appendNumber(to, (i - written) << 2 | kWords);
        append(written, i - written);
      }
      const unsigned which = word == 0 ? kZeros : word == 1 ? kOnes : kAgain;
      appendNumber(to, (end - i) << 2 | which);
      if (which == kAgain) append(i, 1);
      written = end;
    }
    i = end;
  }
  if (written < count) {
    appendNumber(to, (count - written) << 2 | kWords);
    append(written, count - written);
  }
}

}  // namespace

void throwDamagedState() {
  throw error("the state is cut off or damaged; give one as it was saved");
}

void appendNumber(Bytes& to, std::uint64_t number) {
  for (; number >= 0x80; number >>= 7) to.push_back(std::byte(number | 0x80));
  to.push_back(std::byte(number));
}

void appendRuns(Bytes& to, std::span<const std::byte> data, std::size_t word) {
  if (word == 1) return appendRunsOf<std::uint8_t>(to, data);
  if (word == 2) return appendRunsOf<std::uint16_t>(to, data);
  if (word == 4) return appendRunsOf<std::uint32_t>(to, data);
  appendRunsOf<std::uint64_t>(to, data);
}

std::uint64_t ByteReader::number() {
  std::uint64_t number = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    const auto byte = std::uint64_t(bytes(1)[0]);
    number |= (byte & 0x7f) << shift;
    if (byte < 0x80) return number;
  }
  throwDamagedState();
}

std::span<const std::byte> ByteReader::bytes(std::size_t count) {
  if (count > rest_.size()) throwDamagedState();
  const auto taken = rest_.first(count);
  rest_ = rest_.subspan(count);
  return taken;
}

void ByteReader::runs(Bytes& to, std::size_t size, std::size_t word) {
  if (size % word != 0) throwDamagedState();
  const std::size_t end = to.size() + size;
  // A damaged size must not reserve more memory than the data can need.
  to.reserve(to.size() + std::min(size, kLikelyGrowth * rest_.size()));
  while (to.size() < end) {
    const std::uint64_t head = number(), words = head >> 2;
    if (words == 0 || words > (end - to.size()) / word) throwDamagedState();
    const auto which = Which(head & 3);
    if (which == kWords) {
      const auto from = bytes(words * word);
      to.insert(to.end(), from.begin(), from.end());
      continue;
    }
    std::size_t at = to.size();
    to.resize(at + words * word);
    if (which == kZeros) continue;
    const std::uint64_t one = 1;  // its lowest byte comes first
    const auto from = which == kAgain ? bytes(word) : std::as_bytes(std::span(&one, 1)).first(word);
    for (; at < to.size(); at += word) std::memcpy(to.data() + at, from.data(), word);
  }
}

}  // namespace resect
