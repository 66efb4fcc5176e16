#include "heat/heat_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/elementary.h"
#include "base/error.h"

namespace resect {
namespace {

constexpr double kBoils = 100;              // C
constexpr double kCoagulates = 42;          // C: below it takes an hour
constexpr double kWater = 1060 * 0.7;       // kg/m^3: water in liver, 70 %
constexpr double kSteam = 2.26e6 * kWater;  // J/m^3: its latent heat
constexpr double kChars = 150;              // C, and
constexpr double kCharTime = 100;           // K s: above it until all is charred (estimate)
constexpr double kWarm = 0.01;              // K: warmer spots warm those beside them
constexpr double kUnchanged = 0.005;        // K and a share: below both a spot is forgotten
constexpr double kShortestStep = 0.099;     // s
constexpr double kLongestStep = 0.25;  // s; steps of h^2 / (8 k / rho c), 2.1 s, would be unstable

constexpr double kBoltzmannOverPlanck = 2.0837e10;       // 1/(K s)
constexpr double kEnthalpy = 2.768e5, kEntropy = 553.5;  // J/mol; J/(mol K): Jacques et al. 1991
constexpr double kGas = 8.314, kKelvin = 273.15;         // J/(mol K); K

std::array<Vec3i, 3> forward() { return {Vec3i(1, 0, 0), Vec3i(0, 1, 0), Vec3i(0, 0, 1)}; }

}  // namespace

double coagulationRate(double temperature) {
  const double kelvin = temperature + kKelvin;
  return kBoltzmannOverPlanck * kelvin * math::exp(kEntropy / kGas - kEnthalpy / (kGas * kelvin));
}

HeatField::HeatField(const Aabb& box) {
  lattice_.spacing = Vec3::Constant(kSpacing);
  lattice_.origin = box.min;
  for (int a = 0; a < 3; ++a) lattice_.dims[a] = int(std::ceil(box.size()[a] / kSpacing)) + 1;
}

void HeatField::requireSound() const {
  std::int64_t last = -1;
  for (const HeatedSpot& s : spots_) {
    if (s.index <= last || s.index >= lattice_.cellCount() || !std::isfinite(s.temperature))
      throw error("the state has heat where the organ is not; give it as it was saved");
    last = s.index;
  }
}

const HeatedSpot* HeatField::find(std::int64_t index) const {
  const auto at = std::ranges::lower_bound(spots_, index, {}, &HeatedSpot::index);
  return at != spots_.end() && at->index == index ? &*at : nullptr;
}

// Calls visit(cell, weight, spot) for the 8 cells round a place; spot: null if there is none.
template <typename Visit>
void HeatField::visitCorners(const Vec3& place, Visit visit) const {
  const Vec3 at = lattice_.toCellSpace(place);
  for (int corner = 0; corner < 8; ++corner) {
    Vec3i cell;
    double weight = 1;
    for (int a = 0; a < 3; ++a) {
      const double low = std::floor(at[a]);
      const bool high = corner >> a & 1;
      cell[a] = int(low) + high;
      weight *= high ? at[a] - low : 1 - (at[a] - low);
    }
    visit(cell, weight, lattice_.contains(cell) ? find(lattice_.index(cell)) : nullptr);
  }
}

template <typename Value>
double HeatField::between(const Vec3& place, double elsewhere, Value value) const {
  if (spots_.empty()) return elsewhere;
  double sum = 0;
  visitCorners(place, [&](const Vec3i&, double weight, const HeatedSpot* spot) {
    sum += weight * (spot ? value(*spot) : elsewhere);
  });
  return sum;
}

double HeatField::coagulatedTissue(const Vec3& place,
                                   const std::function<bool(const Vec3&)>& isTissue) const {
  double sum = 0, weights = 0;
  visitCorners(place, [&](const Vec3i&, double weight, const HeatedSpot* spot) {
    if (spot) sum += weight * spot->coagulated, weights += weight;
  });
  if (sum == 0) return 0;
  visitCorners(place, [&](const Vec3i& cell, double weight, const HeatedSpot* spot) {
    if (!spot && isTissue(lattice_.centre(cell))) weights += weight;  // not heated
  });
  return sum / weights;
}

double HeatField::temperature(const Vec3& place) const {
  return between(place, kBodyTemperature, [](const HeatedSpot& s) { return s.temperature; });
}
double HeatField::coagulated(const Vec3& place) const {
  return between(place, 0, [](const HeatedSpot& s) { return s.coagulated; });
}
double HeatField::charred(const Vec3& place) const {
  return between(place, 0, [](const HeatedSpot& s) { return s.charred; });
}

double HeatField::energy() const {
  double sum = 0;
  for (const HeatedSpot& s : spots_)
    sum += kHeatCapacity * (s.temperature - kBodyTemperature) + kSteam * (1 - s.water);
  return sum * lattice_.cellVolume();
}

// Makes spots of added_, at 37 C, unless they exist.
void HeatField::insert() {
  std::ranges::sort(added_);
  added_.erase(std::unique(added_.begin(), added_.end()), added_.end());
  const std::size_t before = spots_.size();
  for (const std::int64_t index : added_) {
    const auto end = spots_.begin() + std::ptrdiff_t(before);
    const auto at = std::ranges::lower_bound(spots_.begin(), end, index, {}, &HeatedSpot::index);
    if (at == end || at->index != index) spots_.push_back({.index = index});
  }
  std::inplace_merge(spots_.begin(), spots_.begin() + std::ptrdiff_t(before), spots_.end(),
                     [](const HeatedSpot& a, const HeatedSpot& b) { return a.index < b.index; });
  added_.clear();
}

// Heats the tissue in the ball, or if there is none, the nearest place of the lattice.
void HeatField::add(const HeatSource& source, double duration,
                    const std::function<bool(const Vec3&)>& isTissue) {
  if (!(source.power > 0) || !source.place.allFinite()) return;
  Aabb box;
  box.grow(source.place);
  std::vector<std::int64_t> heated;
  visitCellsIn(lattice_, box.padded(source.radius), [&](const Vec3i& cell) {
    const Vec3 centre = lattice_.centre(cell);
    if ((centre - source.place).norm() <= source.radius && isTissue(centre))
      heated.push_back(lattice_.index(cell));
  });
  if (heated.empty()) {
    const auto cell = lattice_.cellAt(source.place);
    if (!cell || !isTissue(lattice_.centre(*cell))) return;
    heated.push_back(lattice_.index(*cell));
  }
  added_ = heated;
  insert();
  const double rise =
      source.power * duration / (double(heated.size()) * lattice_.cellVolume() * kHeatCapacity);
  for (const std::int64_t index : heated)
    std::ranges::lower_bound(spots_, index, {}, &HeatedSpot::index)->temperature += rise;
}

// Spots beside warm ones become spots too.
void HeatField::spread(const std::function<bool(const Vec3&)>& isTissue) {
  for (const Vec3i& axis : forward())
    for (const int side : {-1, 1}) {
      const Vec3i step = side * axis;
      const std::int64_t stride = side * (lattice_.index(axis) - lattice_.index(Vec3i::Zero()));
      std::size_t other = 0;  // runs along with the spots
      for (const HeatedSpot& s : spots_) {
        if (s.temperature < kBodyTemperature + kWarm) continue;
        while (other < spots_.size() && spots_[other].index < s.index + stride) ++other;
        if (other < spots_.size() && spots_[other].index == s.index + stride) continue;
        const Vec3i beside = lattice_.cell(s.index) + step;
        if (lattice_.contains(beside) && isTissue(lattice_.centre(beside)))
          added_.push_back(s.index + stride);
      }
    }
  insert();
}

// Calls visit(i, j) for each pair of spots of which j is one step farther than i along `axis`.
template <typename Visit>
void HeatField::visitPairs(const Vec3i& axis, Visit visit) const {
  const std::int64_t stride = lattice_.index(axis) - lattice_.index(Vec3i::Zero());
  std::size_t j = 0;  // runs along with i
  for (std::size_t i = 0; i < spots_.size(); ++i) {
    const std::int64_t wanted = spots_[i].index + stride;
    while (j < spots_.size() && spots_[j].index < wanted) ++j;
    if (j == spots_.size()) break;
    if (spots_[j].index == wanted && lattice_.contains(lattice_.cell(spots_[i].index) + axis))
      visit(i, j);
  }
}

// By differences of the fourth order: along each axis, the second difference of T less a twelfth of
// that difference's own second difference. The second difference alone is up to 8 % off where heat
// arrives, and the error depends on the direction.
void HeatField::conduct(double duration) {
  flux_.assign(spots_.size(), 0);
  const double conductance = kConductivity * kSpacing;  // between two spots, W/K
  for (const Vec3i& axis : forward()) {
    bend_.assign(spots_.size(), 0);
    visitPairs(axis, [&](std::size_t i, std::size_t j) {
      const double difference = spots_[j].temperature - spots_[i].temperature;
      bend_[i] += difference;
      bend_[j] -= difference;
    });
    visitPairs(axis, [&](std::size_t i, std::size_t j) {
      const double difference = spots_[j].temperature - spots_[i].temperature;
      const double flow = conductance * (difference - (bend_[j] - bend_[i]) / 12);
      flux_[i] += flow;
      flux_[j] -= flow;
    });
  }
  const double volume = lattice_.cellVolume();
  for (std::size_t i = 0; i < spots_.size(); ++i) {
    HeatedSpot& s = spots_[i];
    const double perfused = kPerfusion * kBloodCapacity * (1 - s.coagulated) * volume;  // W/K
    s.temperature += duration * (flux_[i] - perfused * (s.temperature - kBodyTemperature)) /
                     (kHeatCapacity * volume);
  }
}

void HeatField::keepIn(const std::function<bool(const Vec3&)>& isTissue) {
  std::erase_if(spots_, [&](const HeatedSpot& s) {
    return !isTissue(lattice_.centre(lattice_.cell(s.index)));
  });
}

void HeatField::step(std::span<const HeatSource> sources, double duration,
                     const std::function<bool(const Vec3&)>& isTissue) {
  changed_ = false;
  if (spots_.empty()) waited_ = 0;
  const int steps = std::max(1, int(std::ceil(duration / kLongestStep)));
  for (int k = 0; k < steps && duration > 0; ++k) {
    for (const HeatSource& source : sources) add(source, duration / steps, isTissue);
    waited_ += duration / steps;
    if (waited_ >= kShortestStep) advance(std::exchange(waited_, 0), isTissue);
  }
  if (sources.empty() && waited_ == 0) forget();  // what heats slowly would else be forgotten
}

void HeatField::advance(double duration, const std::function<bool(const Vec3&)>& isTissue) {
  steamRate_ = 0;
  const bool warm = std::ranges::any_of(
      spots_, [](const HeatedSpot& s) { return s.temperature >= kBodyTemperature + kWarm; });
  if (!warm) return;
  spread(isTissue);
  conduct(duration);
  for (HeatedSpot& s : spots_) {
    if (s.temperature > kBoils && s.water > 0) {
      const double steam = std::min(s.water, (s.temperature - kBoils) * kHeatCapacity / kSteam);
      s.water -= steam;
      steamRate_ += steam * kWater * lattice_.cellVolume() / duration;
      s.temperature -= steam * kSteam / kHeatCapacity;
    }
    if (s.temperature < kCoagulates) continue;
    const double before = s.coagulated + s.charred;
    const double react = coagulationRate(s.temperature) * duration;
    s.coagulated += (1 - s.coagulated) * (1 - math::exp(-react));
    if (s.temperature > kChars)
      s.charred = std::min(1.0, s.charred + (s.temperature - kChars) * duration / kCharTime);
    changed_ |= s.coagulated + s.charred > before + 1e-4;
  }
}

// Drops spots that are cool and unchanged, unless they are beside a warm one.
void HeatField::forget() {
  const auto warm = [&](const Vec3i& cell) {
    const HeatedSpot* s = lattice_.contains(cell) ? find(lattice_.index(cell)) : nullptr;
    return s && s->temperature >= kBodyTemperature + kWarm;
  };
  std::vector<std::int64_t>& idle = added_;
  idle.clear();
  for (const HeatedSpot& s : spots_) {
    if (std::abs(s.temperature - kBodyTemperature) >= kWarm || s.coagulated >= kUnchanged ||
        s.water < 1)
      continue;
    const Vec3i cell = lattice_.cell(s.index);
    const auto steps = forward();
    if (std::ranges::none_of(
            steps, [&](const Vec3i& step) { return warm(cell + step) || warm(cell - step); }))
      idle.push_back(s.index);
  }
  if (idle.empty()) return;
  std::erase_if(spots_,
                [&](const HeatedSpot& s) { return std::ranges::binary_search(idle, s.index); });
  idle.clear();
}

}  // namespace resect
