#include "formats/particle_info.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/text/shown_text.h"

#include "io/scenario/length.h"
#include "organ/cell_labels.h"
#include "organ/region_placer.h"

namespace resect {
namespace {

using Json = nlohmann::ordered_json;

const char* formatOf(const std::string& path) {
  return isCellsFile(path) ? "cells of an organ" : "particles in the thesis's format";
}

Json triple(const Vec3& p) { return Json{p.x(), p.y(), p.z()}; }

bool hasLabels(const Discretization& cells) {
  const auto particles = labelledParticles(cells);
  return particles[0] != cells.particleCount();
}

}  // namespace

Json toJson(const KeptCells& kept, const std::string& path) {
  const Discretization& cells = kept.cells;
  const Aabb box = particleBox(cells);
  Json json = {{"file", path},
               {"format", formatOf(path)},
               {"particles", cells.particleCount()},
               {"dims", {cells.lattice.dims.x(), cells.lattice.dims.y(), cells.lattice.dims.z()}},
               {"spacing_m", triple(cells.lattice.spacing)},
               {"volume_ml", 1e6 * cells.volume()},
               {"bounds_m", box.empty() ? Json() : Json{triple(box.min), triple(box.max)}}};
  json["labels"] = Json::array();
  const auto particles = labelledParticles(cells);
  if (hasLabels(cells))
    for (int label = 0; label < 256; ++label)
      if (particles[std::size_t(label)] > 0)
        json["labels"].push_back({{"label", label},
                                  {"name", cells.labelName(label)},
                                  {"particles", particles[std::size_t(label)]}});
  json["landmarks"] = Json::array();
  for (const Landmark& landmark : cells.landmarks)
    json["landmarks"].push_back({{"name", landmark.name}, {"place", triple(landmark.place)}});
  if (isCellsFile(path)) {
    json["source"] = kept.origin.source;
    json["source_unit_m"] = kept.origin.unit;
    json["program"] = kept.origin.program;
    json["inputs"] = Json::array();
    for (const CellsInput& one : kept.origin.inputs)
      json["inputs"].push_back(
          {{"file", one.file}, {"role", one.role}, {"format", one.format}, {"crc32", one.crc32}});
    json["vessels"] = Json::object();
    for (int k = 0; k < kVesselKinds; ++k)
      if (const int count = kept.vessels.range(VesselKind(k)).count; count > 0)
        json["vessels"][std::string(wordOf(VesselKind(k)))] = count;
  }
  return json;
}

std::string toText(const KeptCells& kept, const std::string& path) {
  const Discretization& cells = kept.cells;
  const Aabb box = particleBox(cells);
  std::string text = fmt::format("{}: {}\n", shownText(path, kLongestShownPath), formatOf(path));
  const auto line = [&](const char* name, const std::string& value) {
    text += fmt::format("  {:<16}{}\n", name, shownSentence(value));
  };
  const Vec3 spacing = cells.lattice.spacing;
  line("particles", fmt::format("{}", cells.particleCount()));
  line("spacing", cells.lattice.cubic()
                      ? lengthText(spacing.x())
                      : fmt::format("{} x {} x {}", lengthText(spacing.x()),
                                    lengthText(spacing.y()), lengthText(spacing.z())));
  line("volume", fmt::format("{:.6g} ml", 1e6 * cells.volume()));
  if (!box.empty())
    line("bounds",
         fmt::format("({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g}) m", box.min.x(),
                     box.min.y(), box.min.z(), box.max.x(), box.max.y(), box.max.z()));
  const auto particles = labelledParticles(cells);
  if (hasLabels(cells))
    for (int label = 0; label < 256; ++label)
      if (particles[std::size_t(label)] > 0)
        line("label", fmt::format("{} {}: {} particles", label, shownText(cells.labelName(label)),
                                  particles[std::size_t(label)]));
  for (const Landmark& landmark : cells.landmarks)
    line("landmark", fmt::format("{} at ({:g}, {:g}, {:g}) of the box", shownText(landmark.name),
                                 landmark.place.x(), landmark.place.y(), landmark.place.z()));
  for (int k = 0; k < kVesselKinds; ++k)
    if (const int count = kept.vessels.range(VesselKind(k)).count; count > 0)
      line("vessels", fmt::format("{}: {} segments", wordOf(VesselKind(k)), count));
  for (const CellsInput& one : kept.origin.inputs)
    line("made from", fmt::format("{} ({}){}{}", shownText(one.file), one.role,
                                  one.format.empty() ? "" : ": ", one.format));
  if (!kept.origin.source.empty())
    line("source", fmt::format("{}, unit {:g} m", shownText(kept.origin.source), kept.origin.unit));
  if (!kept.origin.program.empty()) line("written by", shownText(kept.origin.program));
  return text;
}

}  // namespace resect
