#include <algorithm>
#include <cstring>

#include "fuzz_target.h"
#include "small_tables.h"

namespace {

using resect::RawArray;

std::uint32_t number(const char* at) {
  const auto* b = reinterpret_cast<const unsigned char*>(at);
  return std::uint32_t(b[0]) << 24 | std::uint32_t(b[1]) << 16 | std::uint32_t(b[2]) << 8 | b[3];
}

void put(char* at, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) at[i] = char(value >> (24 - 8 * i));
}

// The two sums of SQLite's log format over some bytes, of which there are a multiple of eight.
struct Sums {
  std::uint32_t first = 0, second = 0;
  void add(const char* from, std::size_t size) {
    for (std::size_t i = 0; i + 8 <= size; i += 8) {
      std::uint32_t words[2];
      std::memcpy(words, from + i, 8);
      first += words[0] + second;
      second += words[1] + first;
    }
  }
  void write(char* to) const { put(to, first), put(to + 4, second); }
};

// A log with right sums and salts, which the fuzzer would not find.
void reseal(RawArray<char>& log) {
  constexpr std::size_t kHead = 32, kFrameHead = 24;
  if (log.size() < kHead) return;
  put(log.data(), 0x377f0682);
  Sums sums;
  sums.add(log.data(), 24);
  sums.write(log.data() + 24);
  const std::size_t page = number(log.data() + 8);
  if (page < 512 || page > 65536) return;
  for (std::size_t at = kHead; at + kFrameHead + page <= log.size(); at += kFrameHead + page) {
    char* frame = log.data() + at;
    std::memcpy(frame + 8, log.data() + 16, 8);
    sums.add(frame, 8);
    sums.add(frame + kFrameHead, page);
    sums.write(frame + 16);
  }
}

// A file and its log, as the child in the sandbox reads them; the first four bytes say how long the
// file is. The child's answer must be one that the parent takes.
void read(std::string_view bytes) {
  if (bytes.size() < 4) return;
  const std::size_t size = std::min<std::size_t>(number(bytes.data()), bytes.size() - 4);
  resect::RecordingBytes recording;
  recording.file.assign(bytes.begin() + 4, bytes.begin() + 4 + std::ptrdiff_t(size));
  recording.log.assign(bytes.begin() + 4 + std::ptrdiff_t(size), bytes.end());
  reseal(recording.log);
  auto& tables = resect::test::smallTables();
  tables.add(resect::rowsOf(recording, tables.shape, "the recording"));
}

}  // namespace

RESECT_FUZZ_TARGET(read(bytes))
