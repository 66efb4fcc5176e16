#include "collision/step_rows.h"

#if defined(__x86_64__)

namespace resect {

StepRows::StepRows(int columns, int rows)
    : columns_(columns),
      stride_((columns + kSpan - 1) / kSpan * kSpan + kSpan),
      rows_(std::size_t(rows)) {
  pairs_.assign(std::size_t(stride_) * rows_.size(), kNoSteps);
  deep_.resize(pairs_.size());
}

StepRows::Row& StepRows::deepRow(std::int32_t place) {
  const std::int32_t y = place / stride_;
  Row& row = rows_[std::size_t(y)];
  if (!row.deep) {
    std::fill_n(deep_.begin() + y * stride_, stride_, kNoSteps);
    row.deep = true;
  }
  return row;
}

void StepRows::insertDeep(std::int32_t place, Step s) {
  Row& row = deepRow(place);
  const Step fifth = resect::insert(deep_[std::size_t(place)], s);
  if (fifth != kNoStep) row.more.push_back({place, fifth});
}

RESECT_AVX2 void StepRows::insertDeep(std::int32_t place, const Step (&steps)[kSpan]) {
  Row& row = deepRow(place);
  const __m256i dropped = resect::insert(deepPairs() + place, load(steps));
  if (isNone(dropped)) return;
  StepPair fifth[kSpan];
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(fifth), dropped);
  for (int k = 0; k < kSpan; ++k)
    if (upperOf(fifth[k]) != kNoStep) row.more.push_back({place + k, upperOf(fifth[k])});
}

// Aims at 30 instructions for eight columns with up to two steps.
RESECT_AVX2 void StepRows::merge(StepRows& other, int y) {
  const auto add = [&](std::int32_t place, __m256i steps) RESECT_AVX2 {
    const __m256i dropped = resect::insert(pairs() + place, steps);
    if (isNone(dropped)) return;
    Step third[kSpan];
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(third), _mm256_srai_epi32(dropped, 16));
    insertDeep(place, third);
  };
  // Steps have 15 bits, so that a half's sign makes none of them into all bits.
  const auto addBoth = [&](std::int32_t place, const StepPair* from) RESECT_AVX2 {
    const __m256i both = load(from + place);
    add(place, _mm256_srai_epi32(_mm256_slli_epi32(both, 16), 16));
    add(place, _mm256_srai_epi32(both, 16));
  };
  const Row& from = other.row(y);
  for (int column = 0; column < columns_; column += kSpan) {
    addBoth(place(y, column), other.pairs());
    if (from.deep) addBoth(place(y, column), other.deepPairs());
  }
  for (const auto& [place, s] : from.more) insert(place, s);
}

}  // namespace resect

#endif
