#include "cli/ledger_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

#include "base/text/shown_text.h"

namespace resect {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const TissueAmount& amount) {
  return {{"particles", amount.particles},
          {"tissue_ml", 1e6 * amount.volume},
          {"mass_g", 1e3 * amount.mass}};
}

void put(Json& json, const TissueSplit& split) {
  json["before"] = toJson(split.before);
  json["body"] = toJson(split.body);
  json["pieces"] = toJson(split.pieces);
  json["debris"] = toJson(split.debris);
  json["removed"] = toJson(split.removed);
}

// Whether there are labels besides the organs' own.
bool hasLabels(const Ledger& ledger) {
  for (const OrganLedger& organ : ledger.organs)
    for (const LabelLedger& label : organ.labels)
      if (label.label > 0) return true;
  return false;
}

std::string inWords(const TissueAmount& amount) {
  return fmt::format("{} particles, {:.2f} ml, {:.2f} g", amount.particles, 1e6 * amount.volume,
                     1e3 * amount.mass);
}

// "spleen, " if there are several organs.
std::string prefixOf(const Ledger& ledger, const OrganLedger& organ) {
  return ledger.organs.size() > 1 ? shownText(organ.name) + ", " : "";
}

std::string piecesInWords(const Ledger& ledger) {
  constexpr std::size_t kMost = 4;  // that are told one by one
  std::vector<std::string> pieces;
  TissueAmount smaller;
  for (const OrganLedger& organ : ledger.organs)
    for (std::size_t i = 1; i < organ.parts.size(); ++i) {
      pieces.push_back(prefixOf(ledger, organ) + inWords(organ.parts[i].tissue));
      if (pieces.size() > kMost) smaller += organ.parts[i].tissue;
    }
  if (pieces.empty()) return "none";
  std::string text = fmt::format("{}: {}", pieces.size(), pieces[0]);
  for (std::size_t i = 1; i < std::min(kMost, pieces.size()); ++i) text += " + " + pieces[i];
  if (pieces.size() > kMost)
    text += fmt::format(" + {} others: {}", pieces.size() - kMost, inWords(smaller));
  return text;
}

std::string marginInWords(double margin) {
  if (std::isinf(margin)) return "nothing was cut or removed";
  return margin > 0 ? fmt::format("{:.1f} mm", 1e3 * margin) : "cut into";
}

}  // namespace

Json toJson(const Ledger& ledger) {
  Json organs = Json::array();
  for (const OrganLedger& organ : ledger.organs) {
    Json one{{"organ", organ.name}};
    put(one, organ.tissue);
    one["parts"] = Json::array();
    for (const PartLedger& part : organ.parts) {
      one["parts"].push_back(toJson(part.tissue));
      for (const PartLedger::Share& share : part.labels) {
        Json tissue = toJson(share.tissue);
        tissue["label"] = share.label;
        one["parts"].back()["labels"].push_back(std::move(tissue));
      }
    }
    one["debris_parts"] = organ.debrisParts;
    one["cut_cm2"] = 1e4 * organ.cut;
    one["bared_cm2"] = 1e4 * organ.bared;
    one["labels"] = Json::array();
    for (const LabelLedger& label : organ.labels) {
      Json labelled{{"label", label.label}, {"name", label.name}};
      put(labelled, label.tissue);
      if (label.margin)
        labelled["margin_mm"] = std::isinf(*label.margin) ? Json() : Json(1e3 * *label.margin);
      one["labels"].push_back(std::move(labelled));
    }
    organs.push_back(std::move(one));
  }
  return organs;
}

std::string toText(const Ledger& ledger) {
  std::string text;
  const auto row = [&](const char* what, const std::string& value) {
    text += fmt::format("  {:<10} {}\n", what, value);
  };
  const TissueSplit all = ledger.tissue();
  row("organ", inWords(all.before));
  row("removed", fmt::format("{} ({:.2f} %)", inWords(all.removed),
                             100 * all.removed.volume / all.before.volume));
  row("remains", all.body.volume > 0 ? inWords(all.body) : "nothing is left");
  row("pieces", piecesInWords(ledger));
  std::int64_t debrisParts = 0;
  double cut = 0, bared = 0;
  for (const OrganLedger& organ : ledger.organs)
    debrisParts += organ.debrisParts, cut += organ.cut, bared += organ.bared;
  if (debrisParts > 0)
    row("debris",
        fmt::format("{} part{}: {}", debrisParts, debrisParts > 1 ? "s" : "", inWords(all.debris)));
  row("cut", fmt::format("{:.2f} cm2 cut or torn, {:.2f} cm2 bared by removing tissue", 1e4 * cut,
                         1e4 * bared));
  if (ledger.organs.size() > 1)
    for (const OrganLedger& organ : ledger.organs)
      row(&organ == &ledger.organs[0] ? "organs" : "",
          fmt::format("{}: {:.2f} of {:.2f} ml removed, {:.2f} of {:.2f} g", shownText(organ.name),
                      1e6 * organ.tissue.removed.volume, 1e6 * organ.tissue.before.volume,
                      1e3 * organ.tissue.removed.mass, 1e3 * organ.tissue.before.mass));
  if (!hasLabels(ledger)) return text;
  const char* name = "labels";
  for (const OrganLedger& organ : ledger.organs)
    for (const LabelLedger& label : organ.labels) {
      const TissueSplit& t = label.tissue;
      row(name, fmt::format("{}{}: {} of {} particles removed, {:.2f} of {:.2f} ml, {:.2f} of "
                            "{:.2f} g{}",
                            prefixOf(ledger, organ), shownText(label.name), t.removed.particles,
                            t.before.particles, 1e6 * t.removed.volume, 1e6 * t.before.volume,
                            1e3 * t.removed.mass, 1e3 * t.before.mass,
                            label.margin ? "; margin: " + marginInWords(*label.margin) : ""));
      name = "";
    }
  return text;
}

}  // namespace resect
