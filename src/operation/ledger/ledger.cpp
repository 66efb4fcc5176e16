#include "operation/ledger/ledger.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "base/error.h"
#include "operation/ledger/wound_faces.h"
#include "organ/parts/tissue_parts.h"

namespace resect {
namespace {

constexpr std::int64_t kFullCell = 1 << 24;  // units of volume in a full cell

std::int64_t unitsOf(const Discretization& rest, std::int64_t cell) {
  return std::llround(rest.cellVolume(cell) / rest.lattice.cellVolume() * double(kFullCell));
}

struct Count {
  std::int64_t particles = 0, units = 0;
};

}  // namespace

// Counts the tissue of cells that are given in ascending order, label by label.
struct LedgerBooks::Counts {
  const Discretization& rest;
  const OrganBooks& books;
  std::size_t odd = 0;

  // to: one count per place of a label.
  void add(std::int64_t first, std::int64_t length, Count* to) {
    const std::int64_t end = first + length;
    for (std::int64_t cell = first; cell < end;) {  // stretches of one label
      const std::uint8_t label = rest.labelOf(cell);
      const std::int64_t start = cell;
      if (rest.label.empty())
        cell = end;
      else
        do ++cell;
        while (cell < end && rest.label[std::size_t(cell)] == label);
      Count& count = to[books.place[label]];
      count.particles += cell - start;
      count.units += (cell - start) * kFullCell;
    }
    while (odd < books.odd.size() && books.odd[odd].cell < first) ++odd;
    for (; odd < books.odd.size() && books.odd[odd].cell < end; ++odd) {
      Count& count = to[books.place[rest.labelOf(books.odd[odd].cell)]];
      count.particles += books.odd[odd].particles;
      count.units += books.odd[odd].units;
    }
  }
};

namespace {

double volumeOf(std::int64_t units, const Lattice& lattice) {
  return double(units) / double(kFullCell) * lattice.cellVolume();
}
TissueAmount amountOf(const Count& count, const Lattice& lattice, double density) {
  const double volume = volumeOf(count.units, lattice);
  return {count.particles, volume, volume * density};
}

// Calls visit(first, length) for the runs of cells that were there before and are gone.
template <typename Visit>
void visitRemoved(const std::vector<std::uint8_t>& initial, const std::vector<std::uint8_t>& alive,
                  Visit visit) {
  const std::size_t count = initial.size();
  for (std::size_t i = 0; i < count;) {
    std::uint64_t before, now;
    if (i + 8 <= count) {
      std::memcpy(&before, initial.data() + i, 8);
      std::memcpy(&now, alive.data() + i, 8);
      if (before == now) {
        i += 8;
        continue;
      }
    }
    std::size_t end = i;
    while (end < count && initial[end] && !alive[end]) ++end;
    if (end > i) visit(std::int64_t(i), std::int64_t(end - i));
    i = std::max(end, i + 1);
  }
}

TissueSplit& operator+=(TissueSplit& to, const TissueSplit& more) {
  to.before += more.before, to.body += more.body, to.pieces += more.pieces;
  to.debris += more.debris, to.removed += more.removed;
  return to;
}

}  // namespace

std::int64_t Ledger::pieces() const {
  std::int64_t pieces = 0;
  for (const OrganLedger& organ : organs)
    pieces += std::max<std::int64_t>(0, std::int64_t(organ.parts.size()) - 1);
  return pieces;
}

double Ledger::cut() const {
  double sum = 0;
  for (const OrganLedger& organ : organs) sum += organ.cut;
  return sum;
}

double Ledger::bared() const {
  double sum = 0;
  for (const OrganLedger& organ : organs) sum += organ.bared;
  return sum;
}

TissueSplit Ledger::tissue() const {
  TissueSplit sum;
  for (const OrganLedger& organ : organs) sum += organ.tissue;
  return sum;
}

LedgerBooks::LedgerBooks(const Scenario& scenario, const Simulation& simulation)
    : LedgerBooks(
          [&] {
            std::vector<TissueSetup> setups;
            for (const ScenarioOrgan& organ : scenario.organs) setups.push_back(organ.tissue);
            return setups;
          }(),
          simulation) {}

LedgerBooks::LedgerBooks(const std::vector<TissueSetup>& setups, const Simulation& simulation) {
  require(setups.size() == simulation.organs().size(),
          "{} tissue setups were given for {} organs; give one for each", setups.size(),
          simulation.organs().size());
  for (std::size_t i = 0; i < setups.size(); ++i)
    organs_.push_back(booksOf(simulation.organs()[i], setups[i]));
}

LedgerBooks::OrganBooks LedgerBooks::booksOf(const OperatedOrgan& organ, const TissueSetup& setup) {
  const Discretization& rest = organ.organ.rest;
  OrganBooks books;
  books.initial = rest.inside;
  for (std::int64_t cell = 0; cell < rest.lattice.cellCount(); ++cell) {
    if (rest.inside[std::size_t(cell)]) {
      if (const std::int64_t units = unitsOf(rest, cell); units != kFullCell)
        books.odd.push_back({cell, units - kFullCell, 0});
    } else if (rest.value[std::size_t(cell)] > 0) {
      const std::int64_t owner = ownerCell(rest, cell);
      const bool lone = owner == cell;
      books.odd.push_back({owner, unitsOf(rest, cell) - (lone ? kFullCell : 0), lone ? -1 : 0});
      if (lone) books.initial[std::size_t(cell)] = 1;
    }
  }
  std::ranges::stable_sort(books.odd, {}, &Odd::cell);
  std::vector<Odd> merged;
  for (const Odd& odd : books.odd)
    if (!merged.empty() && merged.back().cell == odd.cell)
      merged.back().units += odd.units, merged.back().particles += odd.particles;
    else
      merged.push_back(odd);
  books.odd = std::move(merged);

  books.before.name = organ.name;
  std::array<Count, 256> before{};
  for (int label = 0; label < 256; ++label) books.place[label] = std::uint8_t(label);
  const std::vector<std::uint8_t> nothing(books.initial.size(), 0);
  Counts counts{rest, books};
  visitRemoved(books.initial, nothing, [&](std::int64_t first, std::int64_t length) {
    counts.add(first, length, before.data());
  });
  for (int label = 0; label < 256; ++label) {
    const Count& count = before[std::size_t(label)];
    if (count.units == 0) continue;
    books.place[label] = std::uint8_t(books.density.size());
    books.density.push_back(setup.materialOf(label).density);
    LabelLedger one{label, rest.labelName(label), {}, {}};
    one.tissue.before = amountOf(count, rest.lattice, books.density.back());
    books.before.tissue += one.tissue;
    const bool named =
        std::size_t(label) < rest.labelNames.size() && !rest.labelNames[std::size_t(label)].empty();
    if (label > 0 && named && count.particles > 0) books.structures.emplace_back(rest, label);
    books.before.labels.push_back(std::move(one));
  }
  return books;
}

Ledger LedgerBooks::ledgerOf(const Simulation& simulation) const {
  require(organs_.size() == simulation.organs().size(),
          "these books are of {} organs, and the simulation has {}; make others", organs_.size(),
          simulation.organs().size());
  Ledger ledger;
  for (std::size_t i = 0; i < organs_.size(); ++i)
    ledger.organs.push_back(ledgerOf(simulation.organs()[i], organs_[i]));
  return ledger;
}

OrganLedger LedgerBooks::ledgerOf(const OperatedOrgan& organ, const OrganBooks& books) {
  const Discretization& rest = organ.organ.rest;
  OrganLedger ledger = books.before;
  const std::size_t labels = ledger.labels.size();

  std::vector<Count> removed(labels);
  if (Counts counts{rest, books}; organ.organ.removedVolume > 0)
    visitRemoved(books.initial, organ.organ.alive, [&](std::int64_t first, std::int64_t length) {
      counts.add(first, length, removed.data());
    });
  for (std::size_t l = 0; l < labels; ++l)
    ledger.labels[l].tissue.removed = amountOf(removed[l], rest.lattice, books.density[l]);

  const TissueParts found = tissueParts(organ);
  std::vector<Count> counted(std::size_t(found.count) * labels);
  std::vector<std::int64_t> firstCell(std::size_t(found.count), -1);
  Counts counts{rest, books};
  for (const CellRun& run : found.runs) {
    counts.add(run.first, run.length, counted.data() + std::size_t(run.part) * labels);
    if (std::int64_t& first = firstCell[std::size_t(run.part)]; first < 0) first = run.first;
  }
  std::vector<std::pair<std::int64_t, std::size_t>> order;  // minus the units, number
  for (std::size_t p = 0; p < firstCell.size(); ++p) {
    order.push_back({0, p});
    for (std::size_t l = 0; l < labels; ++l) order.back().first -= counted[p * labels + l].units;
  }
  std::ranges::sort(order);
  const double least = leastPiece(ledger.tissue.before.volume, rest.lattice.spacing.prod());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto [minusUnits, number] = order[i];
    const bool debris = i > 0 && volumeOf(-minusUnits, rest.lattice) < least;
    PartLedger part{{}, {}, firstCell[number]};
    for (std::size_t l = 0; l < labels; ++l) {
      const Count& count = counted[number * labels + l];
      if (count.units == 0) continue;
      const TissueAmount share = amountOf(count, rest.lattice, books.density[l]);
      TissueSplit& split = ledger.labels[l].tissue;
      (i == 0 ? split.body : debris ? split.debris : split.pieces) += share;
      part.tissue += share;
      part.labels.push_back({ledger.labels[l].label, share});
    }
    if (debris)
      ++ledger.debrisParts;
    else
      ledger.parts.push_back(std::move(part));
  }

  const WoundFaces faces = woundFaces(organ.organ, books.structures);
  ledger.cut = faces.cut, ledger.bared = faces.bared;
  ledger.tissue = {};
  std::size_t structure = 0;
  for (LabelLedger& label : ledger.labels) {
    ledger.tissue += label.tissue;
    if (structure == books.structures.size() || books.structures[structure].label() != label.label)
      continue;
    const double margin = faces.margins[structure++];
    label.margin = label.tissue.removed.volume > 0 ? 0 : margin;
  }
  return ledger;
}

namespace {

// Differs by more than rounding.
bool apart(double a, double b, double whole) { return std::abs(a - b) > 1e-12 * whole; }

std::string discrepancy(const TissueSplit& split, const std::string& of) {
  TissueAmount sum = split.left();
  sum += split.removed;
  const TissueAmount& whole = split.before;
  if (sum.particles != whole.particles)
    return fmt::format("{}: {} particles of {} are accounted for", of, sum.particles,
                       whole.particles);
  if (apart(sum.volume, whole.volume, whole.volume))
    return fmt::format("{}: {} ml of {} are accounted for", of, 1e6 * sum.volume,
                       1e6 * whole.volume);
  if (apart(sum.mass, whole.mass, whole.mass))
    return fmt::format("{}: {} g of {} are accounted for", of, 1e3 * sum.mass, 1e3 * whole.mass);
  return {};
}

std::string discrepancy(const OrganLedger& ledger) {
  std::string found = discrepancy(ledger.tissue, ledger.name);
  TissueSplit labels;
  for (const LabelLedger& label : ledger.labels) {
    if (found.empty()) found = discrepancy(label.tissue, ledger.name + ", " + label.name);
    labels += label.tissue;
  }
  TissueAmount parts = ledger.tissue.debris;
  for (const PartLedger& part : ledger.parts) parts += part.tissue;
  const TissueAmount left = ledger.tissue.left();
  if (found.empty() && parts.particles != left.particles)
    found = fmt::format("{}: the parts have {} particles of {}", ledger.name, parts.particles,
                        left.particles);
  if (found.empty() && apart(parts.volume, left.volume, ledger.tissue.before.volume))
    found = fmt::format("{}: the parts have {} ml of {}", ledger.name, 1e6 * parts.volume,
                        1e6 * left.volume);
  if (found.empty() && apart(parts.mass, left.mass, ledger.tissue.before.mass))
    found = fmt::format("{}: the parts have {} g of {}", ledger.name, 1e3 * parts.mass,
                        1e3 * left.mass);
  return found;
}

// What the organ itself has counted, edit by edit.
std::string discrepancy(const OrganLedger& ledger, const Organ& organ) {
  if (ledger.tissue.removed.particles != organ.removed)
    return fmt::format("{}: {} particles are gone, and {} were removed", ledger.name,
                       ledger.tissue.removed.particles, organ.removed);
  if (ledger.tissue.left().particles != organ.particles)
    return fmt::format("{}: {} particles are in parts, and {} are left", ledger.name,
                       ledger.tissue.left().particles, organ.particles);
  const double whole = ledger.tissue.before.volume;
  if (std::abs(ledger.tissue.removed.volume - organ.removedVolume) > 1e-7 * whole ||
      std::abs(ledger.tissue.left().volume - organ.volume()) > 1e-7 * whole)
    return fmt::format("{}: {} ml are gone, and {} ml were removed", ledger.name,
                       1e6 * ledger.tissue.removed.volume, 1e6 * organ.removedVolume);
  return {};
}

}  // namespace

std::string discrepancy(const Ledger& ledger, const Simulation* simulation) {
  std::string found;
  for (std::size_t i = 0; i < ledger.organs.size() && found.empty(); ++i) {
    found = discrepancy(ledger.organs[i]);
    if (found.empty() && simulation)
      found = discrepancy(ledger.organs[i], simulation->organs()[i].organ);
  }
  return found;
}

}  // namespace resect
