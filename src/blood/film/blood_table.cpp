#include "blood/film/blood_table.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace resect {
namespace {

constexpr double kSoaks = 0.8e-3;    // m: what the cloth holds back
constexpr double kSpreads = 2.0e-3;  // m: depth at which a puddle wets dry cloth, on average
constexpr double kShare = 0.14;      // of the difference of depth that passes in a frame

// Number of the patch at a place; -1 beside the table and on its outermost patches.
std::int32_t numberAt(const Vec3& place) {
  const double x = std::floor(place.x() / kTableCell) + kTableCells / 2,
               z = std::floor(place.z() / kTableCell) + kTableCells / 2;
  if (!(x >= 1 && z >= 1 && x < kTableCells - 1 && z < kTableCells - 1)) return -1;
  return std::int32_t(z) * kTableCells + std::int32_t(x);
}

// 0.5 to 1.5, smooth over some patches.
double unevenness(std::int32_t number) {
  const auto at = [](int x, int z) {
    std::uint32_t h = std::uint32_t(x) * 0x8da6b343u ^ std::uint32_t(z) * 0xd8163841u;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    return double(h & 0xffff) / 65535;
  };
  constexpr int kBlock = 4;
  const int x = number % kTableCells, z = number / kTableCells;
  const double u = double(x % kBlock) / kBlock, v = double(z % kBlock) / kBlock;
  const int i = x / kBlock, j = z / kBlock;
  const double mean = (1 - u) * (1 - v) * at(i, j) + u * (1 - v) * at(i + 1, j) +
                      (1 - u) * v * at(i, j + 1) + u * v * at(i + 1, j + 1);
  return 0.5 + mean;
}

}  // namespace

bool BloodTable::has(std::int32_t number) {
  const int x = number % kTableCells, z = number / kTableCells;
  return number >= 0 && x >= 1 && z >= 1 && x < kTableCells - 1 && z < kTableCells - 1;
}

Vec3 BloodTable::middleOf(std::int32_t number) {
  return {(number % kTableCells - kTableCells / 2 + 0.5) * kTableCell, 0,
          (number / kTableCells - kTableCells / 2 + 0.5) * kTableCell};
}

bool BloodTable::add(const Vec3& place, Picolitres volume) {
  const std::int32_t number = numberAt(place);
  if (number < 0) return false;
  if (volumes_.empty()) volumes_.assign(std::size_t(kTableCells) * kTableCells, 0);
  volumes_[std::size_t(number)] += volume;
  const auto at = std::ranges::lower_bound(wet_, number, {}, &TablePatch::number);
  if (at == wet_.end() || at->number != number)
    wet_.insert(at, {number, volume});
  else
    at->volume += volume;
  return true;
}

void BloodTable::remake() {
  volumes_.clear();
  if (wet_.empty()) return;
  volumes_.assign(std::size_t(kTableCells) * kTableCells, 0);
  for (const TablePatch& p : wet_) volumes_[std::size_t(p.number)] = p.volume;
}

void BloodTable::step() {
  if (wet_.empty()) return;
  constexpr double area = kTableCell * kTableCell;
  constexpr std::int32_t kSides[] = {1,
                                     -1,
                                     kTableCells,
                                     -kTableCells,
                                     kTableCells + 1,
                                     kTableCells - 1,
                                     -kTableCells + 1,
                                     -kTableCells - 1};
  std::vector<std::int32_t> wetted;
  for (const TablePatch& p : wet_) {
    for (std::size_t k = 0; k < std::size(kSides); ++k) {
      const std::int32_t n = p.number + kSides[k];
      const double share = k < 4 ? kShare : 0.5 * kShare;  // less over corners: puddles get round
      const int x = n % kTableCells, z = n / kTableCells;
      if (x < 1 || z < 1 || x >= kTableCells - 1 || z >= kTableCells - 1) continue;
      Picolitres &here = volumes_[std::size_t(p.number)], &there = volumes_[std::size_t(n)];
      const double depth = toCubicMetres(here) / area, other = toCubicMetres(there) / area;
      if (depth <= other || depth < kSoaks) continue;
      if (there == 0) {
        int wet = 0;
        for (int dz = -1; dz <= 1; ++dz)
          for (int dx = -1; dx <= 1; ++dx)
            wet += volumes_[std::size_t(n + dz * kTableCells + dx)] > 0;
        if (depth < kSpreads * unevenness(n) * (1.75 - 0.25 * wet)) continue;
        wetted.push_back(n);
      }
      const Picolitres given = toPicolitres(share * (depth - other) * area);
      here -= given;
      there += given;
    }
  }
  for (const std::int32_t n : wetted) wet_.push_back({n, 0});
  list();
}

// Sorts the patches, drops those that are dry, and copies their volumes.
void BloodTable::list() {
  std::ranges::sort(wet_, {}, &TablePatch::number);
  const auto end = std::unique(wet_.begin(), wet_.end(),
                               [](const auto& a, const auto& b) { return a.number == b.number; });
  wet_.erase(end, wet_.end());
  for (TablePatch& p : wet_) p.volume = volumes_[std::size_t(p.number)];
  std::erase_if(wet_, [](const TablePatch& p) { return p.volume == 0; });
}

Picolitres BloodTable::take(const Vec3& place, double radius, Picolitres most) {
  Picolitres there = 0, taken = 0;
  std::vector<std::size_t> in;
  for (std::size_t i = 0; i < wet_.size(); ++i)
    if ((middleOf(wet_[i].number) - place).norm() <= radius) {
      in.push_back(i);
      there += wet_[i].volume;
    }
  for (const std::size_t i : in) {
    const Picolitres part =
        there <= most ? wet_[i].volume
                      : Picolitres(double(wet_[i].volume) * (double(most) / double(there)));
    volumes_[std::size_t(wet_[i].number)] -= part;
    taken += part;
  }
  if (!in.empty()) list();
  return taken;
}

Picolitres BloodTable::volume() const {
  Picolitres sum = 0;
  for (const TablePatch& p : wet_) sum += p.volume;
  return sum;
}

}  // namespace resect
