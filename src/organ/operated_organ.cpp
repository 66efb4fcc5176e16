#include "organ/operated_organ.h"

#include "base/error.h"
#include "base/state/state_hash.h"
#include "organ/skin/touch_surface.h"
#include "organ/vessel_cords.h"
#include "tissue/still_tissue.h"

namespace resect {
namespace {

void checkRestored(Organ& organ) {
  bool fits = std::int64_t(organ.alive.size()) == organ.rest.lattice.cellCount() &&
              organ.fields.fit(organ.rest.lattice) && organ.severed.fit() &&
              organ.carved.fit(organ.field.brickCount()) && organ.iso >= kMinIso &&
              organ.iso <= kMaxIso &&
              (organ.remnant.empty() || organ.remnant.size() == organ.alive.size());
  for (const std::uint8_t alive : organ.alive) fits = fits && alive <= 1;
  for (std::size_t c = 0; fits && c < organ.remnant.size(); ++c)
    fits = organ.remnant[c] + organ.alive[c] <= 1;
  if (!fits)
    throw error(
        "the state does not fit the organ; restore it into the operation that it was saved "
        "from");
}

bool isRemnant(const std::vector<std::uint8_t>& remnant, std::int64_t cell) {
  return !remnant.empty() && remnant[std::size_t(cell)] != 0;
}

}  // namespace

OperatedOrgan operatedOrgan(std::string name, Organ organ, std::unique_ptr<TissueModel> tissue) {
  if (!tissue) tissue = std::make_unique<StillTissue>(organ.rest.lattice, organ.alive);
  // Still tissue does not open when it is cut, so the blade leaves a gap.
  constexpr float kStillKerf = 0.5e-3f;  // m
  organ.kerf = tissue->moves() ? 0 : kStillKerf;
  if (tissue->moves()) tissue->setSurface(touchSurface(organ));
  OperatedOrgan all{std::move(name), std::move(organ), std::move(tissue), {}, {}, {}};
  renewCords(all);
  return all;
}

void beginRestore(OperatedOrgan& o) {
  o.tissue->beginRestore();
  o.remnantBefore = o.organ.remnant;
}

void remake(OperatedOrgan& o, bool keepsLook, bool anew) {
  Organ& organ = o.organ;
  checkRestored(organ);
  organ.heat.requireSound();
  o.tissue->endRestore(organ.alive);
  renewCords(o);
  organ.field.capsRestored(organ.carved);
  std::vector<std::int64_t> changed;  // cells whose particles are gone now, or there again
  for (std::int64_t cell = 0; cell < organ.rest.lattice.cellCount(); ++cell) {
    const bool there = organ.alive[std::size_t(cell)] != 0 || isRemnant(organ.remnant, cell);
    if (!(organ.rest.value[std::size_t(cell)] > 0)) continue;
    const bool drawn = organ.field.cellValue(cell) > 0;
    if (drawn == there && isRemnant(o.remnantBefore, cell) == isRemnant(organ.remnant, cell))
      continue;
    if (ownerCell(organ.rest, cell) != cell) continue;
    if (drawn != there) setParticle(organ, cell, there);
    changed.push_back(cell);
  }
  const std::span<const std::int64_t> touched = updateField(organ);
  anew ? setIso(organ, organ.iso) : updateRestoredSurface(organ, touched);
  if (keepsLook) organ.surface.updateLook(organ.field);
  if (o.tissue->moves())
    o.skin.follow(organ.surface, organ.rest.lattice, *o.tissue, changed, keepsLook);
}

std::uint64_t fingerprint(const Organ& organ) {
  StateHash hash;
  const Discretization& rest = organ.rest;
  for (int a = 0; a < 3; ++a) {
    hash.add(rest.lattice.origin[a]);
    hash.add(rest.lattice.spacing[a]);
    hash.add(rest.lattice.dims[a]);
  }
  hash.addSpan(rest.value.levels());
  hash.addSpan(rest.value.numbers());
  hash.addSpan(std::span<const std::uint8_t>(rest.inside));
  hash.add(rest.skinScale);
  hash.add(organ.field.refine());
  if (organ.map)
    for (const VesselSegment& s : organ.map->anatomy.segments) {
      for (int a = 0; a < 3; ++a) hash.add(s.end[a]);
      hash.add(s.radius);
    }
  return hash.value();
}

std::size_t OperatedOrgan::bytes() const {
  return heldBytes(organ) + heldBytes(*tissue) + skin.bytes();
}

}  // namespace resect
