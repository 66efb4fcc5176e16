#include "formats/labels/label_model.h"

#include <algorithm>
#include <optional>
#include <ranges>

#include "base/error.h"
#include "base/text/file_stem.h"
#include "base/text/shown_text.h"
#include "formats/labels/enclosed_voxels.h"
#include "formats/labels/label_names.h"
#include "formats/labels/label_surface.h"
#include "formats/meshes/word_reader.h"

namespace resect {
namespace {

// The name of a label in its image.
std::string nameIn(const std::string& path, const LabelImage& image, const ImageLabel& label) {
  return image.labels.size() == 1 && label.name.empty() ? fileStem(path) : shownName(label);
}

std::optional<std::int64_t> numberIn(const std::string& name) {
  constexpr std::string_view kLabel = "label ";
  return wholeNumberOf(lowerCase(name).starts_with(kLabel) ? name.substr(kLabel.size()) : name);
}

}  // namespace

std::string nameList(const std::vector<std::string>& names, std::size_t most) {
  std::string list;
  for (const std::string& name : names | std::views::take(most))
    list += (list.empty() ? "" : ", ") + shownText(name, kLongestName);
  if (names.size() > most) list += fmt::format(" and {} more", names.size() - most);
  return list;
}

std::string labelList(const LabelImage& image) {
  std::vector<std::string> names;
  for (const ImageLabel& label : image.labels)
    names.push_back(fmt::format("{}{}{}", label.value, label.name.empty() ? "" : " ", label.name));
  return nameList(names);
}

int labelNamed(const std::string& path, const LabelImage& image, const std::string& name) {
  const auto called = [&](const ImageLabel& label) {
    return lowerCase(nameIn(path, image, label)) == lowerCase(name);
  };
  auto found = std::ranges::find_if(image.labels, called);
  std::optional<std::int64_t> number = numberIn(name);
  if (!number &&
      std::ranges::all_of(image.labels, [](const ImageLabel& l) { return l.name.empty(); }))
    number = totalSegmentatorLabel(name);
  if (found == image.labels.end() && number)
    found = std::ranges::find(image.labels, *number, &ImageLabel::value);
  if (found == image.labels.end())
    throw error("{}: has no label '{}'; it has: {}", path, shownText(name, kLongestName),
                labelList(image));
  return int(found - image.labels.begin());
}

Model labelModel(const std::string& path, const LabelImage& image, const std::string& parts,
                 const Progress& progress) {
  if (image.labels.empty())
    throw error("{}: all its voxels are 0: nothing is labelled in it; label its organs ({})", path,
                kLabelMakers);
  Model model;
  model.path = path;
  model.format = description(image);
  if (parts.empty()) {
    for (int i = 0; i < int(image.labels.size()); ++i) {
      addToPart(model, nameIn(path, image, image.labels[std::size_t(i)]),
                labelSurface(image, std::span(&i, 1)));
      report(progress, double(i + 1) / double(image.labels.size()));
    }
    return model;
  }
  std::vector<int> chosen, within;
  for (const std::string& line : partNames(parts)) {
    if (line.starts_with(kWithin))
      within.push_back(labelNamed(path, image, line.substr(kWithin.size())));
    else
      chosen.push_back(labelNamed(path, image, line));
  }
  addToPart(model, parts,
            chosen.empty() || within.empty()
                ? labelSurface(image, chosen)
                : labelSurface(withEnclosed(image, chosen, within), chosen));
  report(progress, 1);
  return model;
}

}  // namespace resect
