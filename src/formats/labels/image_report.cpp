#include "formats/labels/image_report.h"

#include <nlohmann/json.hpp>

#include "anatomy/structure_kind.h"
#include "base/text/shown_text.h"
#include "io/model.h"

namespace resect {

std::string toText(const LabelFacts& facts, const std::string& path) {
  std::string text =
      fmt::format("{}: {}\n", shownText(path, kLongestShownPath), shownText(facts.description));
  for (std::size_t i = 0; i < facts.labels.size(); ++i) {
    const ImageLabel& label = facts.labels[i];
    const auto kind = structureKind(label.name);
    text += fmt::format("  label {:<6} {:<32} {:>10.5g} ml{}{}{}\n", label.value,
                        shownText(label.name, kLongestName), 1e6 * facts.volume(i),
                        kind ? "  " : "", kind ? wordOf(*kind) : "",
                        facts.cutOff[i] ? ", cut off by the image's border" : "");
  }
  if (facts.labels.empty() && facts.voxelVolume > 0) text += "  nothing is labelled\n";
  return text;
}

nlohmann::ordered_json toJson(const LabelFacts& facts, const std::string& path) {
  nlohmann::ordered_json json{{"file", path}, {"format", facts.description}};
  json["labels"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < facts.labels.size(); ++i) {
    const ImageLabel& label = facts.labels[i];
    const auto kind = structureKind(label.name);
    json["labels"].push_back({{"value", label.value},
                              {"name", label.name},
                              {"voxels", label.voxels},
                              {"volume_ml", 1e6 * facts.volume(i)},
                              {"kind", kind ? nlohmann::ordered_json(wordOf(*kind)) : nullptr},
                              {"cut_off", bool(facts.cutOff[i])}});
  }
  return json;
}

}  // namespace resect
