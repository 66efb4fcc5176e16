#include "blood/film/film_map.h"

#include <algorithm>
#include <array>

namespace resect {
namespace {

// Weights of a cell's own blood and of its neighbours' by their kind.
constexpr std::array<float, 4> kWeights = {1, 0.6f, 0.36f, 0.22f};

std::uint8_t toByte(float thickness) {
  return std::uint8_t(std::clamp(255 * thickness / TissueMap::kDeepest + 0.5f, 0.f, 255.f));
}

}  // namespace

std::shared_ptr<const TissueMap> filmMap(const BloodFilm& film, const OperatedOrgan& organ) {
  auto map = std::make_shared<TissueMap>();
  const SkinCells& skin = film.skin();
  const Lattice& lattice = skin.lattice();
  map->spacing = lattice.spacing.cast<float>();
  map->low = (lattice.origin - lattice.spacing).cast<float>();
  map->dims = lattice.dims + Vec3i::Constant(2);
  const std::size_t count = skin.numbers().count();
  map->texels.assign(2 * count, 0);
  std::vector<std::uint8_t> done(count, 0);
  const auto thickness = [&](std::int32_t number, float& liquid, float& clotted) {
    const float area = skin[number].area;
    if (!(area > 0)) return;
    liquid = float(toCubicMetres(film.liquidAt(number))) / area;
    clotted = float(toCubicMetres(film.clottedAt(number))) / area;
  };
  const auto mean = [&](std::int32_t number) {
    float liquid = 0, clotted = 0, weights = 0;
    const auto add = [&](std::int32_t n, float w) {
      if (!skin.isSkin(n)) return;
      float l = 0, c = 0;
      thickness(n, l, c);
      liquid += w * l, clotted += w * c, weights += w;
    };
    add(number, kWeights[0]);
    for (int d = 0; d < kDirections; ++d) {
      const std::int32_t n = number + skin.steps()[d];
      if (n >= 0 && n < std::int32_t(count)) add(n, kWeights[std::size_t(neighbourKind(d))]);
    }
    if (!(weights > 0)) return;
    map->texels[2 * std::size_t(number)] = toByte(liquid / weights);
    map->texels[2 * std::size_t(number) + 1] = toByte(clotted / weights);
  };
  const auto need = [&](std::int32_t number) {
    if (number < 0 || number >= std::int32_t(count) || done[std::size_t(number)]) return;
    done[std::size_t(number)] = 1;
    mean(number);
  };
  for (const WetCell& wet : film.wet()) {
    const std::int32_t number = skin.numberOf(wet.cell);
    need(number);
    for (int d = 0; d < kDirections; ++d) need(number + skin.steps()[d]);
    map->box.grow(film.placeOf(organ, wet.cell).place);
  }
  if (!map->box.empty()) map->box = map->box.padded(2 * lattice.spacing.x());
  return map;
}

}  // namespace resect
