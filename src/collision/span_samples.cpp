#include "collision/span_samples.h"

#include "base/assert.h"

#if defined(__x86_64__)
#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <memory>
#include <mutex>

#include "base/parallel.h"
#include "collision/span_caster.h"
#include "collision/step_rows.h"

namespace resect {
namespace {

constexpr std::size_t kShared = 1 << 22;  // columns of all threads' rows that there may be at least

// Each thread that casts triangles has rows of its own: as many as ever work at once.
class RowsOfThreads {
 public:
  RowsOfThreads(int columns, int rows) : columns_(columns), rows_(rows) {}

  // Calls work(rows).
  template <typename Work>
  void lend(const Work& work) {
    StepRows* rows = nullptr;
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        rows = idle_.back();
        idle_.pop_back();
      }
    }
    if (!rows) {
      auto made = std::make_unique<StepRows>(columns_, rows_);
      const std::lock_guard lock(mutex_);
      rows = all_.emplace_back(std::move(made)).get();
    }
    work(*rows);
    const std::lock_guard lock(mutex_);
    idle_.push_back(rows);
  }

  std::vector<std::unique_ptr<StepRows>>& all() { return all_; }

 private:
  int columns_, rows_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<StepRows>> all_;
  std::vector<StepRows*> idle_;
};

// How many of the lanes up to each one are in the set.
constexpr std::array<std::array<std::uint8_t, kSpan>, 256> kCounts = [] {
  std::array<std::array<std::uint8_t, kSpan>, 256> counts{};
  for (unsigned set = 0; set < 256; ++set)
    for (unsigned lane = 0; lane < kSpan; ++lane)
      counts[set][lane] = std::uint8_t(std::popcount(set & ((2u << lane) - 1)));
  return counts;
}();
RESECT_AVX2 inline __m256i countsOf(unsigned set) {
  return _mm256_cvtepu8_epi32(
      _mm_loadl_epi64(reinterpret_cast<const __m128i*>(kCounts[set].data())));
}

// Each bit of four at twice its place.
constexpr std::array<std::uint8_t, 16> kSpread = [] {
  std::array<std::uint8_t, 16> spread{};
  for (unsigned set = 0; set < 16; ++set)
    for (unsigned bit = 0; bit < 4; ++bit)
      spread[set] = std::uint8_t(spread[set] | (set >> bit & 1) << (2 * bit));
  return spread;
}();

// Turns the steps of a row into stretches.
class StretchWriter {
 public:
  StretchWriter(StepRows& rows, InsideStretch* all) : rows_(rows), all_(all) {}

  // to: where the row's stretches go; offsets: behind the first.
  void write(int y, InsideStretch* to, std::uint32_t* offsets);

 private:
  void writeTwo(__m256i pairs, InsideStretch*& to, std::uint32_t* offsets) const;
  void writeFour(__m256i pairs, __m256i deep, InsideStretch*& to, std::uint32_t* offsets) const;
  void writeAny(int y, int begin, int end, InsideStretch*& to, std::uint32_t* offsets);

  StepRows& rows_;
  InsideStretch* all_;
  std::vector<Step> many_;
};

// The stretches of pairs, four columns in each vector, and which of the eight hold a point: where
// the first step enters, the second leaves, and a point lies between them.
struct Stretches {
  __m256i low, high;
  unsigned set;
};
RESECT_AVX2 inline Stretches stretchesOf(__m256i pairs) {
  const __m256i first = _mm256_srli_epi32(_mm256_slli_epi32(pairs, 16), 17),
                last = _mm256_srli_epi32(pairs, 17);
  // The second one's sign above none, and that of the first where it enters.
  const __m256i none = _mm256_cmpgt_epi32(_mm256_setzero_si256(), pairs);
  const __m256i through =
      _mm256_slli_epi32(_mm256_andnot_si256(pairs, _mm256_srli_epi32(pairs, 16)), 31);
  const __m256i some =
      _mm256_andnot_si256(none, _mm256_and_si256(through, _mm256_cmpgt_epi32(last, first)));
  const __m256i even = _mm256_unpacklo_epi32(first, last), odd = _mm256_unpackhi_epi32(first, last);
  return {_mm256_permute2x128_si256(even, odd, 0x20), _mm256_permute2x128_si256(even, odd, 0x31),
          unsigned(_mm256_movemask_ps(_mm256_castsi256_ps(some)))};
}

// Writes those of four stretches that are in the set.
RESECT_AVX2 inline InsideStretch* putStretches(__m256i stretches, unsigned set, InsideStretch* to) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), packed(stretches, set));
  return to + std::popcount(set);
}
RESECT_AVX2 inline void putOffsets(__m256i counts, std::ptrdiff_t before, std::uint32_t* offsets) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(offsets),
                      _mm256_add_epi32(_mm256_set1_epi32(std::int32_t(before)), counts));
}

// Columns with at most two steps. Aims at 40 instructions for eight.
RESECT_AVX2 [[gnu::always_inline]] inline void StretchWriter::writeTwo(
    __m256i pairs, InsideStretch*& to, std::uint32_t* offsets) const {
  const Stretches s = stretchesOf(pairs);
  putOffsets(countsOf(s.set), to - all_, offsets);
  to = putStretches(s.low, s.set & 0xf, to);
  to = putStretches(s.high, s.set >> 4, to);
}

// Do the two steps of every column enter and leave, or are there none? One that enters alone, with
// none above it, may pass: no stretch begins there.
RESECT_AVX2 inline bool goThrough(__m256i pairs) {
  const __m256i none = _mm256_cmpeq_epi32(pairs, _mm256_set1_epi32(-1));
  const __m256i odd = _mm256_and_si256(pairs, _mm256_set1_epi32(0x1'0001));
  const __m256i through = _mm256_cmpeq_epi32(odd, _mm256_set1_epi32(0x1'0000));
  return _mm256_testc_si256(_mm256_or_si256(none, through), _mm256_set1_epi32(-1));
}

// Columns that go in and out at most twice: what is sorted so has a point between the two. Aims at
// 90 instructions for eight.
RESECT_AVX2 [[gnu::always_inline]] inline void StretchWriter::writeFour(
    __m256i pairs, __m256i deep, InsideStretch*& to, std::uint32_t* offsets) const {
  const Stretches s = stretchesOf(pairs), t = stretchesOf(deep);
  putOffsets(_mm256_add_epi32(countsOf(s.set), countsOf(t.set)), to - all_, offsets);
  const auto putBoth = [&](__m256i a, __m256i b, unsigned inA, unsigned inB)
      __attribute__((target("avx2"), always_inline)) {
    const __m256i even = _mm256_unpacklo_epi64(a, b), odd = _mm256_unpackhi_epi64(a, b);
    const unsigned both = kSpread[inA] | unsigned(kSpread[inB]) << 1;
    to = putStretches(_mm256_permute2x128_si256(even, odd, 0x20), both & 0xf, to);
    to = putStretches(_mm256_permute2x128_si256(even, odd, 0x31), both >> 4, to);
  };
  putBoth(s.low, t.low, s.set & 0xf, t.set & 0xf);
  putBoth(s.high, t.high, s.set >> 4, t.set >> 4);
}

// Any columns.
void StretchWriter::writeAny(int y, int begin, int end, InsideStretch*& to,
                             std::uint32_t* offsets) {
  const StepRows::Row& row = rows_.row(y);
  for (int column = begin; column < end; ++column) {
    many_.clear();
    const auto add = [&](StepPair pair) {
      for (const Step s : {lowerOf(pair), upperOf(pair)})
        if (s != kNoStep) many_.push_back(s);
    };
    const std::int32_t place = rows_.place(y, column);
    add(rows_.pairs()[place]);
    if (row.deep) add(rows_.deepPairs()[place]);
    if (many_.size() == 4)
      for (auto more = std::ranges::lower_bound(row.more, std::pair(place, Step(0)));
           more != row.more.end() && more->first == place; ++more)
        many_.push_back(more->second);
    to = writeStretches<Step>(many_, to);
    *offsets++ = std::uint32_t(to - all_);
  }
}

RESECT_AVX2 void StretchWriter::write(int y, InsideStretch* to, std::uint32_t* offsets) {
  StepRows::Row& row = rows_.row(y);
  std::sort(row.more.begin(), row.more.end());
  const StepPair *const pairs = rows_.pairs(), *const deep = rows_.deepPairs();
  auto more = row.more.begin();
  const int whole = rows_.columns() / kSpan * kSpan;
  for (int column = 0; column < whole; column += kSpan, offsets += kSpan) {
    const std::int32_t place = rows_.place(y, column);
    const bool four = more == row.more.end() || more->first >= place + kSpan;
    if (!row.deep)
      writeTwo(load(pairs + place), to, offsets);
    else if (four && goThrough(load(pairs + place)) && goThrough(load(deep + place))) [[likely]]
      writeFour(load(pairs + place), load(deep + place), to, offsets);
    else
      writeAny(y, column, column + kSpan, to, offsets);
    while (more != row.more.end() && more->first < place + kSpan) ++more;
  }
  writeAny(y, whole, rows_.columns(), to, offsets);
}

// Stretches that the columns of a row can have together, and as many as are written beside them.
std::size_t roomOf(StepRows& rows, int y) {
  const StepRows::Row& row = rows.row(y);
  return std::size_t(rows.columns()) * (row.deep ? 2 : 1) + row.more.size() / 2;
}

}  // namespace

bool canFindSpans() {
  static const bool can = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return can;
}

InsideSamples insideSamplesBySpans(const SnappedMesh& mesh, const ColumnGrid& grid,
                                   const SampleLine& line) {
  GridOnMesh lines(mesh, grid);
  if (!RoughMesh::isEnough(lines)) return insideSamplesPlainly(mesh, grid, line);
  InsideSamples inside;
  inside.countX = std::size_t(grid.countX);
  inside.offsets.resize((inside.countX + 1) * std::size_t(grid.countY));

  const RoughMesh placed(std::move(lines));
  const SpanCaster caster(placed, line);
  RowsOfThreads lent(grid.countX, grid.countY);
  // A thread's rows take 4 bytes a column, deep ones as much again.
  const std::size_t most = std::max<std::size_t>(4, kShared / grid.count());
  const std::size_t share =
      threadsAllowed() <= most ? 1 : (mesh.triangles.size() + most - 1) / most;
  parallelFor(mesh.triangles.size(), std::max(4 * kRun, share),
              [&](std::size_t begin, std::size_t end) {
                lent.lend([&](StepRows& rows) { caster.cast(begin, end, rows); });
              });
  if (lent.all().empty()) return inside;  // no triangles
  StepRows& rows = *lent.all().front();
  const auto count = std::size_t(grid.countY);
  if (lent.all().size() > 1)
    parallelFor(count, 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t y = begin; y < end; ++y)
        for (std::size_t k = 1; k < lent.all().size(); ++k) rows.merge(*lent.all()[k], int(y));
    });

  std::vector<std::size_t> begins(count + 1, 0);
  for (std::size_t y = 0; y < count; ++y) begins[y + 1] = begins[y] + roomOf(rows, int(y));
  RESECT_ASSERT(begins.back() <= std::numeric_limits<std::uint32_t>::max());
  inside.all.resize(begins.back());
  parallelFor(count, 16, [&](std::size_t begin, std::size_t end) {
    StretchWriter writer(rows, inside.all.data());
    for (std::size_t y = begin; y < end; ++y) {
      std::uint32_t* const offsets = inside.offsets.data() + y * (inside.countX + 1);
      offsets[0] = std::uint32_t(begins[y]);
      writer.write(int(y), inside.all.data() + begins[y], offsets + 1);
    }
  });
  return inside;
}

}  // namespace resect

#else

namespace resect {

bool canFindSpans() { return false; }

InsideSamples insideSamplesBySpans(const SnappedMesh& mesh, const ColumnGrid& grid,
                                   const SampleLine& line) {
  return insideSamplesPlainly(mesh, grid, line);
}

}  // namespace resect

#endif
