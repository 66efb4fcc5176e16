#include "collision/step_tiles.h"

#if defined(__x86_64__)
#include <algorithm>
#include <cstring>

namespace resect {

StepTiles::StepTiles(int columns, int rows)
    : across_((columns + kTileColumns - 1) / kTileColumns),
      rows_(std::size_t((rows + kTileRows - 1) / kTileRows)) {
  pairs_.resize(std::size_t(across_) * rows_.size());
  deep_.resize(pairs_.size());
  std::memset(static_cast<void*>(pairs_.data()), 0xff, pairs_.size() * sizeof(StepPairs));
}

RESECT_AVX2 void StepTiles::insertDeep(int tileRow, int tile, const TileStep* steps) {
  StepPairs* const deep = deepPairs(tileRow);
  Row& row = rows_[std::size_t(tileRow)];
  if (!row.deep) {
    std::memset(static_cast<void*>(deep), 0xff, std::size_t(across_) * sizeof(StepPairs));
    row.deep = true;
  }
  const __m128i dropped = resect::insert(deep[tile], load(steps));
  if (areNone(dropped)) return;
  alignas(16) TileStep fifth[kLanes];
  store(fifth, dropped);
  for (int lane = 0; lane < kLanes; ++lane)
    if (fifth[lane] != kNoStep)
      row.more.push_back({std::uint32_t(tile * kLanes + lane), fifth[lane]});
}

RESECT_AVX2 void StepTiles::merge(StepTiles& other, int tileRow) {
  const auto add = [&](int tile, const TileStep* steps) __attribute__((target("avx2"))) {
    const __m128i dropped = resect::insert(pairs(tileRow)[tile], load(steps));
    if (areNone(dropped)) return;
    alignas(16) TileStep third[kLanes];
    store(third, dropped);
    insertDeep(tileRow, tile, third);
  };
  const Row& from = other.row(tileRow);
  for (int tile = 0; tile < across_; ++tile) {
    const StepPairs& pair = other.pairs(tileRow)[tile];
    add(tile, pair.lower);
    add(tile, pair.upper);
    if (!from.deep) continue;
    add(tile, other.deepPairs(tileRow)[tile].lower);
    add(tile, other.deepPairs(tileRow)[tile].upper);
  }
  for (const auto& [lane, s] : from.more)
    insert(tileRow, int(lane) / kLanes, int(lane) % kLanes, s);
}

}  // namespace resect

#endif
