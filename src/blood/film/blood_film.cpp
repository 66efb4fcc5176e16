#include "blood/film/blood_film.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/elementary.h"
#include "base/growth.h"
#include "blood/flow/circulation.h"

namespace resect {
namespace {

constexpr double kStain = 0.10e-3;   // m: a film that stays
constexpr double kWets = 0.9e-3;     // m: film that wets dry skin, on average
constexpr double kUneven = 0.6;      // by how much that differs from place to place
constexpr double kTension = 0.35;    // a dry cell between wet ones is wetted more easily
constexpr int kTensionFrom = 5;      // wet cells of its 26
constexpr double kDryShare = 0.3;    // what a dry neighbour gets against a wet one
constexpr double kLevelling = 0.45;  // of the volume that would level two ponds, in one transfer
constexpr double kDrop = 40e-9;      // m^3: a hanging drop
constexpr double kHangs = 1.5e-3;    // m: a film that an overhang holds
constexpr int kPondSweeps = 4;
constexpr double kClotting = 480;  // s, of blood at rest (Lee and White 1913: 5 to 10 minutes)
constexpr double kSteepest = 1.5;
constexpr double kSlit = 0.3e-3;    // m: width of a closed slit
constexpr double kOntoTable = 0.8;  // spacings above the table, where blood runs onto it

constexpr double widthOf(int kind) { return kind == 1 ? 1 : kind == 2 ? 0.6 : 0.35; }

// -1 to 1, smooth over some cells: sums of hashes of the corners of blocks, interpolated.
double unevenness(const Vec3i& cell) {
  constexpr int kBlock = 3;
  const auto corner = [](int x, int y, int z) {
    std::uint32_t h = std::uint32_t(x) * 0x8da6b343u ^ std::uint32_t(y) * 0xd8163841u ^
                      std::uint32_t(z) * 0xcb1ab31fu;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    return double(h & 0xffff) / 32767.5 - 1;
  };
  Vec3i low;
  Vec3 t;
  for (int a = 0; a < 3; ++a) {
    low[a] = cell[a] / kBlock;
    t[a] = double(cell[a] - low[a] * kBlock) / kBlock;
  }
  double sum = 0;
  for (int k = 0; k < 8; ++k) {
    const int x = k & 1, y = k >> 1 & 1, z = k >> 2;
    sum += (x ? t.x() : 1 - t.x()) * (y ? t.y() : 1 - t.y()) * (z ? t.z() : 1 - t.z()) *
           corner(low.x() + x, low.y() + y, low.z() + z);
  }
  return std::clamp(1.5 * sum, -1.0, 1.0);
}

}  // namespace

void BloodFilm::setUp(const OperatedOrgan& organ) {
  skin_ = SkinCells(organ);
  const std::size_t count = skin_.numbers().count();
  liquid_.assign(count, 0);
  clotted_.assign(count, 0);
  listed_.assign(count, 0);
  outlet_.assign(count, 0);
  located_.assign(count, 0);
  spots_.assign(count, {});
  order_.clear();
  around_.clear();
}

void BloodFilm::remake(const OperatedOrgan& organ) {
  setUp(organ);
  for (const WetCell& w : wet_) {
    const std::int32_t number = skin_.numberOf(w.cell);
    liquid_[std::size_t(number)] = w.liquid;
    clotted_[std::size_t(number)] = w.clotted;
    listed_[std::size_t(number)] = 1;
    order_.push_back(number);
  }
}

// Where the skin of a cell is now.
BloodFilm::Spot BloodFilm::spotOf(const OperatedOrgan& organ, std::int32_t number) const {
  const SkinCell& s = skin_[number];
  Spot spot;
  const std::int64_t cell = skin_.latticeCell(number);
  const Lattice& lattice = skin_.lattice();
  const Vec3 centre = lattice.centre(lattice.cell(cell));
  spot.place = centre.cast<float>() + s.offset;
  spot.normal = s.normal;
  spot.area = s.area;
  if (organ.tissue->moves()) {
    CellPlacement placement;
    organ.tissue->place({&cell, 1}, {&placement, 1});
    const Eigen::Matrix3f f = placement.gradient + Eigen::Matrix3f::Identity();
    spot.place = centre.cast<float>() + placement.displacement + f * s.offset;
    Eigen::Matrix3f cofactor;
    cofactor << f.col(1).cross(f.col(2)), f.col(2).cross(f.col(0)), f.col(0).cross(f.col(1));
    const Vec3f turned = cofactor * s.normal;
    const float stretch = turned.norm();
    if (stretch > 1e-3f) {
      spot.normal = turned / stretch;
      spot.area = s.area * std::clamp(stretch, 0.2f, 5.f);
    }
  }
  spot.height = spot.place.y();
  double level = spot.area * std::max(0.2f, spot.normal.y());  // area seen from above
  if (s.slit) level = kSlit * lattice.spacing.x();
  spot.perVolume = spot.normal.y() > -0.2f || s.slit ? 1 / (kPicolitresPerM3 * level) : 0;
  return spot;
}

void BloodFilm::place(const OperatedOrgan& organ) {
  for (const std::int32_t number : around_) located_[std::size_t(number)] = 0;
  around_.clear();
  const auto need = [&](std::int32_t number) {
    if (located_[std::size_t(number)]) return;
    located_[std::size_t(number)] = 1;
    around_.push_back(number);
    spots_[std::size_t(number)] = spotOf(organ, number);
  };
  for (const std::int32_t number : order_) {
    need(number);
    for (std::uint32_t ways = skin_[number].ways; ways; ways &= ways - 1)
      need(number + skin_.steps()[std::countr_zero(ways)]);
  }
}

void BloodFilm::pour(std::int32_t number, Picolitres volume) {
  liquid_[std::size_t(number)] += volume;
  if (listed_[std::size_t(number)]) return;
  listed_[std::size_t(number)] = 1;
  order_.push_back(number);
}

void BloodFilm::add(std::int64_t cell, Picolitres volume) {
  if (volume > 0) pour(skin_.numberOf(cell), volume);
}

// Gives on what the film of a cell carries off in a frame.
void BloodFilm::run(std::int32_t number, double duration, bool table,
                    std::vector<BloodDrop>& drops) {
  const std::size_t c = std::size_t(number);
  const Spot& spot = spots_[c];
  const double area = spot.area, side = skin_.lattice().spacing.x();
  const double stain = kStain * area;
  double left = double(liquid_[c]) / kPicolitresPerM3 - stain;
  if (left <= 0) return;
  const double thickness = left / area, high = head(number);
  // The part of gravity along the skin.
  const Vec3f downhill = spot.normal.y() * spot.normal - Vec3f::UnitY();

  struct Way {
    std::int32_t to;
    double weight;
  };
  Way ways[kDirections];
  int count = 0;
  double sum = 0, weights = 0;
  bool outlet = false;
  for (std::uint32_t bits = skin_[number].ways; bits; bits &= bits - 1) {
    const int d = std::countr_zero(bits);
    const std::int32_t n = number + skin_.steps()[d];
    const double drop = high - head(n);
    if (drop <= 0) continue;
    double share = 1;
    if (liquid_[std::size_t(n)] == 0 && clotted_[std::size_t(n)] == 0) {
      int wet = 0;
      for (int k = 0; k < kDirections; ++k) wet += liquid_[std::size_t(n + skin_.steps()[k])] > 0;
      const double threshold = kWets * (1 + kUneven * unevenness(skin_.numbers().cell(n))) *
                               std::clamp(1 - kTension * (wet - kTensionFrom), 0.3, 1.0);
      if (thickness < threshold) continue;
      share = kDryShare;
    }
    const int kind = neighbourKind(d);
    const Vec3f way = spots_[std::size_t(n)].place - spot.place;
    const double length = std::max(0.3 * side, double(way.norm()));
    double slope = std::min(kSteepest, drop / length);
    if (outlet_[c]) slope = 0.5 * slope + 0.5 * std::max(0.0, double(way.dot(downhill)) / length);
    outlet |= head(n) < spot.height;
    sum += widthOf(kind) * side * slope * share;
    ways[count] = {n, widthOf(kind) * slope * slope * share};
    weights += ways[count++].weight;
  }
  if (!outlet && spot.normal.y() > 0.1f && thickness > 0.3e-3) ponds_.push_back(number);
  if (count > 0 && weights > 0) {
    // What is left of the film's thickness: x + a x^3 = thickness.
    const double a = duration * kBloodDensity * kEarth / (3 * kBloodViscosity) * sum / area;
    double x = std::min(thickness, math::cbrt(thickness / std::max(1e-30, a)));
    for (int i = 0; i < 3; ++i) x -= (x + a * x * x * x - thickness) / (1 + 3 * a * x * x);
    const double out = (thickness - std::clamp(x, 0.0, thickness)) * area;
    for (int k = 0; k < count; ++k) {
      const std::int32_t n = ways[k].to;
      const double drop = head(number) - head(n);
      if (drop <= 0) continue;
      double volume = out * ways[k].weight / weights;
      if (!outlet_[std::size_t(n)] && spot.perVolume > 0)  // a pond: towards level, never beyond
        volume = std::min(volume, kLevelling * drop / kPicolitresPerM3 /
                                      (spot.perVolume + spots_[std::size_t(n)].perVolume));
      const Picolitres given = std::min(toPicolitres(volume), liquid_[c]);
      if (given <= 0) continue;
      liquid_[c] -= given;
      pour(n, given);
    }
    left = double(liquid_[c]) / kPicolitresPerM3 - stain;
  }
  if (left <= 0) return;
  const Vec3 place = spot.place.cast<double>();
  if (table && place.y() < kOntoTable * side && spot.normal.y() < 0.5f) {
    const Picolitres given = toPicolitres(0.3 * left);
    liquid_[c] -= given;
    drops.push_back({Vec3(place.x(), 0, place.z()), Vec3::Zero(), given});
  } else if (spot.normal.y() < 0 && !skin_[number].slit &&
             left > (count ? std::max(kDrop, kHangs * area) : kDrop)) {
    const Picolitres given = toPicolitres(std::min(left, std::max(kDrop, 0.5 * left)));
    liquid_[c] -= given;
    drops.push_back({place + 0.5 * side * spot.normal.cast<double>(), Vec3(0, -0.05, 0), given});
  }
}

// Whether a neighbour's film lies lower than this cell's skin.
bool BloodFilm::hasOutlet(std::int32_t number) const {
  for (std::uint32_t bits = skin_[number].ways; bits; bits &= bits - 1)
    if (head(number + skin_.steps()[std::countr_zero(bits)]) < spots_[std::size_t(number)].height)
      return true;
  return false;
}

// Ponds level in some more sweeps, there and back.
void BloodFilm::level() {
  for (int sweep = 0; sweep < kPondSweeps; ++sweep)
    for (std::size_t i = 0; i < ponds_.size(); ++i) {
      const std::int32_t number = ponds_[sweep & 1 ? i : ponds_.size() - 1 - i];
      const Spot& spot = spots_[std::size_t(number)];
      for (std::uint32_t bits = skin_[number].ways; bits; bits &= bits - 1) {
        const std::int32_t n = number + skin_.steps()[std::countr_zero(bits)];
        if (liquid_[std::size_t(n)] == 0 || outlet_[std::size_t(n)]) continue;
        const double drop = head(number) - head(n);
        const double both = spot.perVolume + spots_[std::size_t(n)].perVolume;
        if (drop <= 1e-6 || !(both > 0)) continue;
        const Picolitres given =
            std::min(Picolitres(kLevelling * drop / both),
                     liquid_[std::size_t(number)] - toPicolitres(kStain * spot.area));
        if (given <= 0) continue;
        liquid_[std::size_t(number)] -= given;
        pour(n, given);
      }
    }
}

void BloodFilm::clot(double duration) {
  const double share = duration / kClotting;
  for (const std::int32_t number : order_) {
    const Picolitres now = Picolitres(share * double(liquid_[std::size_t(number)]));
    liquid_[std::size_t(number)] -= now;
    clotted_[std::size_t(number)] += now;
  }
}

void BloodFilm::step(double duration, bool table, std::vector<BloodDrop>& drops) {
  const std::size_t before = order_.size();  // cells wetted in this frame wait for the next
  struct Height {
    double head;
    std::int32_t number;
  };
  std::vector<Height> heights;
  heights.reserve(before);
  for (const std::int32_t number : order_) {
    heights.push_back({head(number), number});
    for (std::uint32_t bits = skin_[number].ways; bits; bits &= bits - 1)
      outlet_[std::size_t(number + skin_.steps()[std::countr_zero(bits)])] = 1;
  }
  for (const std::int32_t number : order_) outlet_[std::size_t(number)] = hasOutlet(number);
  std::ranges::sort(heights, [](const Height& a, const Height& b) {
    return a.head > b.head || (a.head == b.head && a.number < b.number);
  });
  ponds_.clear();
  for (const Height& h : heights) run(h.number, duration, table, drops);
  level();
  clot(duration);
}

void BloodFilm::collect() {
  std::erase_if(order_, [&](std::int32_t number) {
    const std::size_t c = std::size_t(number);
    const bool dry = liquid_[c] == 0 && clotted_[c] == 0;
    if (dry) listed_[c] = 0;
    return dry;
  });
  std::ranges::sort(order_);
  wet_.clear();
  for (const std::int32_t number : order_)
    wet_.push_back(
        {skin_.latticeCell(number), liquid_[std::size_t(number)], clotted_[std::size_t(number)]});
}

Picolitres BloodFilm::take(const Vec3& place, double radius, Picolitres most) {
  std::vector<std::int32_t> in;
  Picolitres there = 0, taken = 0;
  for (const std::int32_t number : order_) {
    if (liquid_[std::size_t(number)] == 0 || !located_[std::size_t(number)]) continue;
    if ((spots_[std::size_t(number)].place.cast<double>() - place).norm() > radius) continue;
    in.push_back(number);
    there += liquid_[std::size_t(number)];
  }
  for (const std::int32_t number : in) {
    Picolitres& liquid = liquid_[std::size_t(number)];
    const Picolitres part =
        there <= most ? liquid : Picolitres(double(liquid) * (double(most) / double(there)));
    liquid -= part;
    taken += part;
  }
  return taken;
}

// The blood of a cell without skin goes to the lowest skin cell beside it, or falls.
void BloodFilm::settle(const OperatedOrgan& organ, std::int32_t number,
                       std::vector<BloodDrop>& drops) {
  const std::size_t c = std::size_t(number);
  const Picolitres volume = liquid_[c] + clotted_[c];
  liquid_[c] = clotted_[c] = 0;
  std::int32_t best = -1;
  for (int d = 0; d < kDirections; ++d) {
    const std::int32_t n = number + skin_.steps()[d];
    if (!skin_.isSkin(n)) continue;
    spots_[std::size_t(n)] = spotOf(organ, n);
    if (best < 0 || head(n) < head(best)) best = n;
  }
  if (best >= 0) {
    pour(best, volume);
  } else {
    drops.push_back({spots_[c].place.cast<double>(), Vec3::Zero(), volume});
  }
}

void BloodFilm::renew(const OperatedOrgan& organ, std::span<const std::int64_t> cells,
                      std::vector<BloodDrop>& drops, std::vector<OpenedFaces>& opened) {
  if (cells.empty()) return;
  skin_.renew(organ, cells, opened);
  const std::size_t before = order_.size();
  for (std::size_t i = 0; i < before; ++i)
    if (const std::int32_t number = order_[i]; !skin_.isSkin(number)) settle(organ, number, drops);
}

std::int64_t BloodFilm::skinNear(const Vec3& rest, const Vec3& beside) const {
  constexpr int kReach = 3;
  const Lattice& lattice = skin_.lattice();
  const double side = lattice.spacing.x();
  const Vec3 q = lattice.toCellSpace(rest);
  Vec3i at;
  for (int a = 0; a < 3; ++a) at[a] = int(std::floor(q[a] + 0.5));
  std::int64_t best = -1;
  double least = 0;
  // Shell by shell: cells of shell r lie at least r - 1/2 spacings away.
  for (int r = 0; r <= kReach && (best < 0 || least > (r - 0.5) * side); ++r)
    for (int z = -r; z <= r; ++z)
      for (int y = -r; y <= r; ++y) {
        const int step = std::abs(z) == r || std::abs(y) == r ? 1 : std::max(1, 2 * r);
        for (int x = -r; x <= r; x += step) {
          const Vec3i cell = at + Vec3i(x, y, z);
          if (!lattice.contains(cell) || !skin_.isSkin(skin_.numbers().of(cell))) continue;
          const Vec3 way = lattice.centre(cell) - rest;
          const double cost = way.norm() + (way.dot(beside) < 0 ? side : 0);
          if (best < 0 || cost < least) least = cost, best = lattice.index(cell);
        }
      }
  return best;
}

BloodFilm::SkinPlace BloodFilm::placeOf(const OperatedOrgan& organ, std::int64_t cell) const {
  const Spot spot = spotOf(organ, skin_.numberOf(cell));
  return {spot.place.cast<double>(), spot.normal.cast<double>()};
}

FilmVolumes BloodFilm::volumes() const {
  FilmVolumes sum;
  for (const std::int32_t number : order_) {
    sum.liquid += liquid_[std::size_t(number)];
    sum.clotted += clotted_[std::size_t(number)];
  }
  return sum;
}

std::size_t BloodFilm::bytes() const {
  return skin_.numbers().count() * (sizeof(SkinCell) + sizeof(Spot) + 2 * sizeof(Picolitres) + 3) +
         wet_.capacity() * sizeof(WetCell);
}

}  // namespace resect
