#include "blood/bleeding.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/elementary.h"
#include "base/error.h"
#include "blood/flow/segment_parts.h"
#include "organ/heat/heat_organ.h"

namespace resect {
namespace {

constexpr double kOoze = 2e-4;     // m/s: 0.02 ml/s per cm^2 of fresh cut tissue (estimate)
constexpr double kOozeTime = 120;  // s: in which it falls to 1/e (estimate)
constexpr double kOozeEnds = 6;    // of these times, after which it has stopped
constexpr double kJetSpeed = 0.8;  // m/s: faster blood leaves an artery as a jet
constexpr double kFastestJet = 3;  // m/s
constexpr double kFalls = -0.5;    // m: below the table a drop is lost
constexpr double kPulse = 0.2, kHeart = 1.2;  // of the arterial pressure; Hz
// Arterial pressure falls when more than kBorneLoss of the blood is lost, to kLeastPressure at
// kGravest. From there all flows fall to nothing, since no blood is left.
constexpr double kGravest = 0.5, kLeastPressure = 0.4;
constexpr double kStub = 0.5;  // spacings back along a vessel, where its blood leaves the tissue

double pressureShare(double lost) {
  const double share = std::clamp((lost - kBorneLoss) / (kGravest - kBorneLoss), 0.0, 1.0);
  return 1 - share * (1 - kLeastPressure);
}
// The pressure of the vena cava falls with the blood lost, to nothing at this share, which is about
// that of the blood that stretches the vessels (estimate).
constexpr double kStretching = 0.3;
constexpr int kSeekEvery = 12;  // frames with edits after which the parts of the tissue are sought

// Share of its pressure that the heart keeps with this much air in it, m^3.
double airShare(double air) {
  return 1 - std::clamp((air - kBorneAir) / (kDeadlyAir - kBorneAir), 0.0, 1.0);
}

// The height to which the pressures of the sources refer, m: that of the hilum, where the portal
// vein's trunk, which begins outside the organ, ends.
double zeroLevel(const Anatomy& anatomy) {
  const VesselRange portal = anatomy.range(VesselKind::PortalVein);
  return portal.count > 0 ? anatomy.segments[std::size_t(portal.first)].end.y() : 0;
}

double shareLeft(double lost) { return std::clamp((1 - lost) / (1 - kGravest), 0.0, 1.0); }

// Cells at which the edits may have changed the skin.
std::vector<std::int64_t> changedCells(const Organ& organ, std::int32_t number,
                                       std::span<const TissueEdit> edits) {
  std::vector<std::int64_t> cells;
  const Lattice& lattice = organ.rest.lattice;
  for (const TissueEdit& edit : edits) {
    if (edit.organ != number) continue;
    if (const auto* removal = std::get_if<RemoveCell>(&edit.what)) cells.push_back(removal->cell);
    if (const auto* bond = std::get_if<SeverBond>(&edit.what)) cells.push_back(bond->cell);
    if (const auto* bond = std::get_if<TearBond>(&edit.what)) cells.push_back(bond->cell);
    if (const auto* incision = std::get_if<Incision>(&edit.what))
      visitCellsIn(lattice, incision->blade.bounds.padded(lattice.spacing.x()),
                   [&](const Vec3i& cell) { cells.push_back(lattice.index(cell)); });
    if (const auto* carving = std::get_if<Carve>(&edit.what))
      visitCellsIn(lattice, carving->line.bounds().padded(lattice.spacing.x()),
                   [&](const Vec3i& cell) { cells.push_back(lattice.index(cell)); });
  }
  std::erase_if(cells, [&](std::int64_t c) { return c < 0 || c >= lattice.cellCount(); });
  std::ranges::sort(cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

// -1 to 1, the same for the same numbers.
double noise(std::uint64_t a, std::uint64_t b) {
  std::uint64_t z = a * 0x9e3779b97f4a7c15u ^ b * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return double(z >> 11) * 0x1.0p-52 - 1;
}

}  // namespace

int bleedingGrade(double rate) {
  const double mlPerMinute = rate * 60e6;
  return mlPerMinute <= 1    ? 0
         : mlPerMinute <= 5  ? 1
         : mlPerMinute <= 10 ? 2
         : mlPerMinute <= 50 ? 3
                             : 4;
}

Bleeding::Bleeding(std::span<const OperatedOrgan> organs, const Circulation& circulation)
    : circulation_(circulation) {
  organs_.resize(organs.size());
  for (std::size_t i = 0; i < organs.size(); ++i) {
    if (!organs[i].organ.map) continue;
    any_ = true;
    organs_[i].film.setUp(organs[i]);
    organs_[i].flow = VesselFlow(organs[i].organ.map, circulation);
    organs_[i].sinusoids = {circulation.sinusoids};
  }
}

void Bleeding::remake(std::span<const OperatedOrgan> organs) {
  const auto check = [](bool sound) {
    if (!sound)
      throw error(
          "the state has blood or vessels where the organ has none; give it as it was saved");
  };
  for (std::size_t i = 0; i < organs_.size(); ++i) {
    const Organ& organ = organs[i].organ;
    const std::int64_t cells = organ.rest.lattice.cellCount(),
                       segments = organ.map ? std::int64_t(organ.map->anatomy.segments.size()) : 0;
    check(organs_[i].film.ready() || organs_[i].film.wet().empty());
    for (const WetCell& w : organs_[i].film.wet())
      check(w.cell >= 0 && w.cell < cells && w.liquid >= 0 && w.clotted >= 0);
    for (const Oozing& o : organs_[i].oozing) check(o.cell >= 0 && o.cell < cells && o.part >= 0);
    for (const SegmentPart& apart : organ.vessels.apart)
      check(apart.segment >= 0 && apart.segment < segments && apart.part >= SegmentPart::kCrumb &&
            apart.part <= cells);
    for (const VesselInjury& v : organ.vessels.injuries)
      check(v.segment >= 0 && v.segment < segments);
    for (const VesselClip& clip : organ.vessels.clips)
      check(clip.segment >= 0 && clip.segment < segments);
  }
  for (const TablePatch& patch : table_.wet()) check(BloodTable::has(patch.number));
  for (std::size_t i = 0; i < organs_.size(); ++i)
    if (organs_[i].film.ready()) organs_[i].film.remake(organs[i]);
  table_.remake();
}

BloodLedger Bleeding::ledger() const {
  BloodLedger all;
  all.bled = bled_;
  for (const OrganBlood& blood : organs_) {
    if (!blood.film.ready()) continue;
    const FilmVolumes v = blood.film.volumes();
    all.film += v.liquid;
    all.clotted += v.clotted;
  }
  for (const BloodDrop& drop : drops_) all.drops += drop.volume;
  all.pools = table_.volume();
  all.sucked = sucked_;
  all.absorbed = absorbed_;
  all.lost = lost_;
  return all;
}

std::size_t Bleeding::bytes() const {
  std::size_t sum = table_.bytes() + drops_.capacity() * sizeof(BloodDrop);
  for (const OrganBlood& blood : organs_)
    if (blood.film.ready()) sum += blood.film.bytes();
  return sum;
}

// Finds the skin again where edits changed it, and, when some frames have passed, the parts of the
// tissue. Faces that were cut begin to ooze.
void Bleeding::follow(OrganBlood& blood, OperatedOrgan& organ, std::int32_t number,
                      std::span<const TissueEdit> edits, double time) {
  const Lattice& lattice = organ.organ.rest.lattice;
  std::vector<OpenedFaces> opened;
  const std::vector<std::int64_t> changed = changedCells(organ.organ, number, edits);
  blood.film.renew(organ, changed, drops_, opened);
  const double face = lattice.spacing.x() * lattice.spacing.x();
  const SkinCells& skin = blood.film.skin();
  for (const OpenedFaces& cut : opened) {
    // The faces of the cells along an oblique plane are larger than the plane, by this factor.
    const double stairs = skin[skin.numberOf(cut.cell)].normal.cast<double>().lpNorm<1>();
    blood.oozing.push_back({cut.cell, cut.faces * face / std::max(1.0, stairs), time});
  }
  std::erase_if(blood.oozing, [&](const Oozing& o) {
    return time - o.since > kOozeEnds * kOozeTime || !organ.organ.alive[std::size_t(o.cell)];
  });
  if ((blood.unsought > 0 || !changed.empty()) && ++blood.unsought > kSeekEvery) {
    blood.unsought = 0;
    const std::vector<std::int32_t> part = partOfCells(organ);
    organ.organ.vessels.apart = segmentsApart(organ.organ, part);
    for (Oozing& o : blood.oozing) o.part = std::max(0, part[std::size_t(o.cell)]);
  }
}

void Bleeding::shed(OrganBlood& blood, std::int64_t cell, Picolitres volume) {
  bled_ += volume;
  blood.film.add(cell, volume);
}

void Bleeding::ooze(OrganBlood& blood, const OperatedOrgan& organ, double duration, double time) {
  const Lattice& lattice = organ.organ.rest.lattice;
  const SkinCells& skin = blood.film.skin();
  const double left = shareLeft(toCubicMetres(bled_) / circulation_.volume);
  const double level = zeroLevel(organ.organ.map->anatomy);
  for (const Oozing& o : blood.oozing) {
    if (!organ.tissue->solid(o.cell)) continue;
    // In a piece in which no vessel ends, no pressure is known: nothing feeds it.
    if (std::size_t(o.part) >= blood.sinusoids.size()) continue;
    const double over = blood.sinusoids[std::size_t(o.part)] -
                        pressureOutside(blood.film.placeOf(organ, o.cell).place, level);
    const double pressure = std::max(0.0, over / circulation_.sinusoids);
    const Vec3 face =
        lattice.centre(lattice.cell(o.cell)) + skin[skin.numberOf(o.cell)].offset.cast<double>();
    const double open = 1 - coagulatedAt(organ.organ, face);
    const double rate =
        left * kOoze * o.area * pressure * open * math::exp(-(time - o.since) / kOozeTime);
    shed(blood, o.cell, toPicolitres(rate * duration));
  }
}

// Blood from one end: out of an artery in an open wound it leaves as a jet, else it wells up.
void Bleeding::bleedFrom(OrganBlood& blood, const OperatedOrgan& organ, const VesselInjury& injury,
                         int end, std::int64_t cell, double duration, double time,
                         Picolitres volume) {
  const VesselSegment& s = organ.organ.map->anatomy.segments[std::size_t(injury.segment)];
  const double area = std::numbers::pi * s.radius * s.radius * injury.share();
  const double speed = injury.flow[end] / area;
  const SkinCells& skin = blood.film.skin();
  if (s.kind != VesselKind::HepaticArtery || speed < kJetSpeed || skin[skin.numberOf(cell)].slit)
    return shed(blood, cell, volume);
  const auto [place, normal] = blood.film.placeOf(organ, cell);
  const std::uint64_t moment = std::uint64_t(std::llround(time / duration));
  Vec3 way = normal;
  for (int a = 0; a < 3; ++a)
    way[a] += 0.15 * noise(moment, std::uint64_t(injury.segment) * 8 + std::uint64_t(a));
  const double v = std::min(kFastestJet, 0.7 * speed);
  bled_ += volume;
  drops_.push_back(
      {place + 0.5 * organ.organ.rest.lattice.spacing.x() * normal, v * way.normalized(), volume});
}

void Bleeding::bleed(OrganBlood& blood, OperatedOrgan& organ, std::int32_t number, double duration,
                     double time, BloodReport& report) {
  VesselState& state = organ.organ.vessels;
  if (state.injuries.empty()) return;
  const Anatomy& anatomy = organ.organ.map->anatomy;
  const double level = zeroLevel(anatomy);
  const double stub = kStub * organ.organ.rest.lattice.spacing.x();

  std::vector<EndOutside> outside(state.injuries.size());
  std::vector<std::array<std::int64_t, 2>> exits(state.injuries.size());
  std::vector<std::array<Vec3, 2>> places(state.injuries.size());
  for (std::size_t i = 0; i < state.injuries.size(); ++i) {
    const VesselInjury& injury = state.injuries[i];
    const VesselSegment& s = anatomy.segments[std::size_t(injury.segment)];
    const Vec3 along = (s.end - s.start).normalized();
    for (int end = 0; end < 2; ++end) {
      const Vec3 back = end == 0 ? Vec3(-along) : along;
      const Vec3 mouth = s.at(end == 0 ? injury.from : injury.to);
      exits[i][std::size_t(end)] = blood.film.skinNear(mouth + stub * back, back);
      outside[i].closed[end] = exits[i][std::size_t(end)] < 0 ||
                               s.kind == VesselKind::BileDuct;  // bile does not flow here
      if (outside[i].closed[end]) continue;
      const Vec3 place = blood.film.placeOf(organ, exits[i][std::size_t(end)]).place;
      places[i][std::size_t(end)] = place;
      outside[i].pressure[end] = pressureOutside(place, level);
    }
  }
  const double lost = toCubicMetres(bled_) / circulation_.volume,
               fall = pressureShare(lost) * airShare(air_);
  const double turn = 2 * std::numbers::pi * (time * kHeart - std::floor(time * kHeart));
  const SourceShares sources{fall * (1 + kPulse * math::sin(turn)), fall,
                             std::max(0.0, 1 - lost / kStretching)};
  const double air = blood.flow.solve(state, outside, sources, blood.sinusoids);
  report.airRate += air, air_ += air * duration;
  for (std::size_t i = 0; i < state.injuries.size(); ++i)
    for (int end = 0; end < 2; ++end) {
      VesselInjury& injury = state.injuries[i];
      injury.flow[end] *= shareLeft(lost);
      const Picolitres volume = toPicolitres(injury.flow[end] * duration);
      if (volume <= 0 || outside[i].closed[end]) continue;
      injury.bled += toCubicMetres(volume);
      bleedFrom(blood, organ, injury, end, exits[i][std::size_t(end)], duration, time, volume);
      report.ends.push_back({number, injury.segment, VesselEnd(end), places[i][std::size_t(end)],
                             injury.flow[end],
                             anatomy.segments[std::size_t(injury.segment)].radius});
    }
}

// Takes up to `most` of the blood within a radius, from organs and table.
Picolitres Bleeding::take(const Vec3& place, double radius, Picolitres most) {
  if (most <= 0 || !place.allFinite()) return 0;
  Picolitres sum = 0;
  for (OrganBlood& blood : organs_)
    if (blood.film.ready()) sum += blood.film.take(place, radius, most - sum);
  return sum + table_.take(place, radius, most - sum);
}

// What presses on a place of the skin, Pa.
double Bleeding::pressureAt(const Vec3& place) const {
  double most = 0;
  for (const Press& press : pressing_)
    if ((place - press.place).norm() <= press.radius) most = std::max(most, press.pressure);
  return most;
}

// What blood that leaves the tissue at a place has to overcome, Pa: it stands higher than the zero
// level, and something may press on it.
double Bleeding::pressureOutside(const Vec3& place, double level) const {
  return kBloodDensity * kEarth * (place.y() - level) + pressureAt(place);
}

// Drops fly until they meet an organ or the table.
void Bleeding::fly(std::span<const OperatedOrgan> organs, double duration, bool table) {
  std::size_t kept = 0;
  for (BloodDrop& drop : drops_) {
    const Vec3 before = drop.place;
    drop.velocity.y() -= kEarth * duration;
    drop.place += duration * drop.velocity;
    bool landed = false;
    for (std::size_t o = 0; o < organs_.size() && !landed; ++o) {
      BloodFilm& film = organs_[o].film;
      if (!film.ready()) continue;
      const double side = organs[o].organ.rest.lattice.spacing.x();
      const int steps = 1 + int((drop.place - before).norm() / (0.5 * side));
      for (int k = 1; k <= steps && !landed; ++k) {
        const Vec3 at = before + (drop.place - before) * (double(k) / steps);
        Aabb box;
        box.grow(at);
        double nearest = 0;
        std::int64_t best = -1;
        for (const std::int64_t cell : organs[o].tissue->cellsIn(box.padded(0.6 * side))) {
          const SkinCells& skin = film.skin();
          if (!skin.isSkin(skin.numberOf(cell))) continue;
          const double d = (film.placeOf(organs[o], cell).place - at).norm();
          if (best < 0 || d < nearest) nearest = d, best = cell;
        }
        if (best < 0) continue;
        film.add(best, drop.volume);
        landed = true;
      }
    }
    if (landed) continue;
    if (table && drop.place.y() <= 0) {
      if (!table_.add(drop.place, drop.volume)) lost_ += drop.volume;
    } else if (drop.place.y() < kFalls) {
      lost_ += drop.volume;
    } else {
      drops_[kept++] = drop;
    }
  }
  drops_.resize(kept);
}

void Bleeding::step(std::span<OperatedOrgan> organs, std::span<const TissueEdit> edits,
                    double duration, double time, bool table, BloodReport& report) {
  report.rate = report.airRate = 0;
  report.ends.clear();
  if (!any_) return;
  const Picolitres before = bled_;
  pressing_.clear();
  for (const TissueEdit& edit : edits)
    if (const auto* press = std::get_if<Press>(&edit.what)) pressing_.push_back(*press);
  for (std::size_t i = 0; i < organs_.size(); ++i) {
    OrganBlood& blood = organs_[i];
    if (!blood.film.ready()) continue;
    follow(blood, organs[i], std::int32_t(i), edits, time);
    if (!(duration > 0)) continue;
    if (organs[i].organ.vessels.inflowClamped) organs[i].organ.vessels.clampedTime += duration;
    bleed(blood, organs[i], std::int32_t(i), duration, time, report);
    ooze(blood, organs[i], duration, time);
    blood.film.place(organs[i]);
  }
  if (duration > 0) {
    for (const TissueEdit& edit : edits)
      if (const auto* suction = std::get_if<Suction>(&edit.what))
        sucked_ += take(suction->place, suction->radius, toPicolitres(suction->rate * duration));
    for (const Press& press : pressing_)
      absorbed_ += take(press.place, press.radius, toPicolitres(press.soaks * duration));
    for (OrganBlood& blood : organs_)
      if (blood.film.ready()) blood.film.step(duration, table, drops_);
    fly(organs, duration, table);
    table_.step();
    report.rate = toCubicMetres(bled_ - before) / duration;
  }
  for (OrganBlood& blood : organs_)
    if (blood.film.ready()) blood.film.collect();
  report.ledger = ledger();
}

}  // namespace resect
