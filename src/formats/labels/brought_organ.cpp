#include "formats/labels/brought_organ.h"

#include <algorithm>
#include <fstream>
#include <optional>

#include "base/crc32.h"
#include "base/error.h"
#include "base/text/file_stem.h"
#include "base/text/shown_text.h"
#include "formats/child/foreign_file.h"
#include "formats/images/dicom_file.h"
#include "formats/labels/label_file.h"
#include "formats/labels/label_model.h"
#include "formats/meshes/word_reader.h"
#include "io/model.h"
#include "io/scenario/orientation.h"

namespace resect {
namespace {

namespace fs = std::filesystem;

// A label and where it is.
struct Found {
  std::string file;
  std::string part;  // of the file; empty: all
  std::string name;
  std::optional<StructureKind> kind;
  double volume = 0;  // m^3
  bool cutOff = false;
};

// The name of a structure in that of its file, which may begin with what tells nothing: "liver" of
// "VH_M_liver", "tumour" of "02-tumour".
std::string withoutPrefix(const std::string& stem) {
  constexpr std::string_view kBetween = "_- .";
  constexpr std::size_t kTellsNothing = 2;  // letters
  std::string_view name = stem;
  for (;;) {
    const std::size_t end = name.find_first_of(kBetween);
    if (end == name.npos) return std::string(name);
    const std::string_view word = name.substr(0, end);
    const bool digits = word.find_first_not_of("0123456789") == word.npos;
    if (word.size() > kTellsNothing && !digits) return std::string(name);
    name.remove_prefix(end + 1);
  }
}

// The labels of one file.
std::vector<Found> labelsOf(const std::string& file, OrganSource& source) {
  const LabelFacts facts = readLabelFacts(file);
  if (facts.guessed)
    source.notes.push_back(
        fmt::format("{}: its labels have no names; those of TotalSegmentator are taken", file));
  std::vector<Found> all;
  for (std::size_t i = 0; i < facts.labels.size(); ++i) {
    const ImageLabel& label = facts.labels[i];
    std::string name = shownName(label);
    const auto kind = structureKind(name);
    all.push_back({file, facts.labels.size() == 1 ? "" : std::to_string(label.value),
                   std::move(name), kind, facts.volume(i), bool(facts.cutOff[i])});
  }
  return all;
}

std::string beginningOf(const fs::path& file) {
  std::string start(kDicomHead, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(start.data(), std::streamsize(start.size()));
  start.resize(std::size_t(in.gcount()));
  return start;
}

// Studies of DICOM have folders for their series, so segmentations are looked for in all of them.
std::vector<std::string> imagesIn(const std::string& path, std::vector<std::string>& notes) {
  std::vector<std::string> files;
  int slices = 0;
  const fs::recursive_directory_iterator folder(path,
                                                fs::directory_options::skip_permission_denied);
  for (auto entry = begin(folder); entry != end(folder); ++entry) {
    if (!entry->is_regular_file() || !isImageFile(entry->path())) continue;
    const std::string start = beginningOf(entry->path());
    if (startsAsDicom(start) && !startsAsSegmentation(start))
      ++slices;
    else if (startsAsDicom(start) || entry.depth() == 0)
      files.push_back(entry->path().string());
  }
  std::ranges::sort(files);
  if (files.empty() && slices > 0)
    throw error("{}: holds {} DICOM files of a scan and no segmentation; make one with {}", path,
                slices, kLabelMakers);
  if (files.empty())
    throw error(
        "{}: is a folder without label images; choose one of .nii, .nrrd, .mha or DICOM "
        "files",
        path);
  if (slices > 0) notes.push_back(fmt::format("left out: {} DICOM files of a scan", slices));
  return files;
}

// Whether a structure lies in an organ.
bool isWithin(StructureKind kind) {
  return kind == StructureKind::Tumour || kind == StructureKind::Cyst ||
         kind == StructureKind::Cavity || vesselKind(kind);
}

// What a file's name tells: that it is an organ, or what lies in one.
std::optional<StructureKind> kindOfFile(const std::string& stem) {
  const auto kind = structureKind(withoutPrefix(stem));
  return kind && (isWithin(*kind) || *kind == StructureKind::Parenchyma) ? kind : std::nullopt;
}

constexpr std::size_t kFew = 4;  // names, in a note

// The organ among the labels.
const Found& organOf(const OrganSource& source, const std::vector<Found>& all) {
  std::vector<const Found*> organs;
  for (const Found& one : all)
    if (one.kind == StructureKind::Parenchyma) organs.push_back(&one);
  // "liver" stands before "liver_segment_1".
  const auto whole = std::ranges::find_if(organs, [](const Found* one) {
    const std::string name = lowerCase(withoutPrefix(one->name));
    return name == "liver" || name == "parenchyma";
  });
  if (whole != organs.end()) return **whole;
  if (organs.size() == 1) return *organs[0];
  if (all.size() == 1) return all[0];
  std::vector<std::string> names;
  for (const Found& one : all) {
    const bool numbered = !one.part.empty() && one.name != "label " + one.part;
    names.push_back(numbered ? one.part + " " + one.name : one.name);
  }
  throw error("{}: holds {} labels; choose the organ with --part: {}", source.file, all.size(),
              nameList(names));
}

std::string inWords(const Found& one) {
  const std::string name = shownText(one.name, kLongestName);
  return one.volume > 0 ? fmt::format("{} {:.4g} ml", name, 1e6 * one.volume) : name;
}

// In a folder of a file for each structure, the files whose names tell something, or the one that
// is asked for.
std::vector<Found> structuresIn(const std::vector<std::string>& files, OrganSource& source) {
  std::vector<Found> all;
  std::vector<std::string> left;
  for (const std::string& file : files) {
    const std::string stem = fileStem(file);
    const bool wanted = lowerCase(stem) == lowerCase(source.part);
    const auto kind = kindOfFile(stem);
    if (wanted || kind)
      all.push_back({file, "", stem, kind});
    else
      left.push_back(stem);
  }
  if (source.part.empty()) {
    if (!left.empty()) source.notes.push_back("left out: " + nameList(left, kFew));
    return all;
  }
  const auto wanted = std::ranges::find_if(
      all, [&](const Found& one) { return lowerCase(one.name) == lowerCase(source.part); });
  if (wanted == all.end()) return {};
  // Only an organ of which the others could be structures keeps them.
  if (wanted->kind == StructureKind::Parenchyma) {
    std::erase_if(all, [&](const Found& one) {
      return one.kind == StructureKind::Parenchyma && one.name != wanted->name;
    });
    return all;
  }
  return {*wanted};
}

// With the sizes of what the images hold; without those in which nothing is labelled.
std::vector<Found> measured(std::vector<Found> all, OrganSource& source) {
  std::vector<Found> kept;
  for (Found& one : all) {
    if (!isImageFile(one.file)) {
      kept.push_back(std::move(one));
      continue;
    }
    const LabelFacts facts = readLabelFacts(one.file);
    for (std::size_t i = 0; i < facts.labels.size(); ++i) {
      one.volume += facts.volume(i);
      one.cutOff = one.cutOff || facts.cutOff[i];
    }
    if (one.volume > 0)
      kept.push_back(std::move(one));
    else
      source.notes.push_back(one.file + ": nothing is labelled in it; it was left out");
  }
  return kept;
}

void take(OrganSource& source, const Found& organ, const std::vector<Found>& all) {
  const bool given = !source.structures.empty();
  const double unit = source.unit;  // of models; images tell theirs
  source.file = organ.file;
  source.part = organ.part;
  if (isImageFile(organ.file)) source.unit = 1;
  std::string within;
  std::vector<std::string> left;
  for (const Found& one : all) {
    if (&one == &organ) continue;
    if (given || !one.kind || !isWithin(*one.kind)) {
      left.push_back(one.name);
      continue;
    }
    const std::size_t before = source.structures.size();
    addStructure(source, *one.kind, one.name, one.file == organ.file ? "" : one.file, one.part);
    if (source.structures.size() > before)
      source.structures.back().unit = isImageFile(one.file) ? 1 : unit;
    within += fmt::format("{}{} ({})", within.empty() ? "" : ", ", inWords(one), wordOf(*one.kind));
  }
  source.notes.push_back(fmt::format("{}: the organ is {}{}{}", organ.file, inWords(organ),
                                     within.empty() ? "" : ", with " + within,
                                     left.empty() ? "" : "; left out: " + nameList(left, kFew)));
  if (organ.cutOff)
    source.notes.push_back(fmt::format("{} reaches the border of the image and is cut off there",
                                       shownText(organ.name, kLongestName)));
}

// Images are in left-posterior-superior. What a scenario says of its organ holds.
void layAsInPatient(OrganSource& source) {
  if (!source.pose.rotation.isApprox(Eigen::Quaterniond::Identity())) return;
  source.pose.rotation = orientationOf("LPS");
  source.settle = false;
}

}  // namespace

bool isLabelled(const fs::path& path) {
  std::error_code ec;
  return fs::is_directory(path, ec) || isImageFile(path);
}

std::vector<FolderImage> imagesOf(const std::string& folder, std::vector<std::string>& notes) {
  std::vector<FolderImage> images;
  for (const std::string& file : imagesIn(folder, notes))
    images.push_back({file, fileStem(file), kindOfFile(fileStem(file))});
  return images;
}

void takeLabels(OrganSource& source) {
  layAsInPatient(source);
  if (fs::is_directory(source.file)) return takeFiles(source, imagesIn(source.file, source.notes));
  if (!source.part.empty() || !source.structures.empty()) return;
  const std::vector<Found> all = labelsOf(source.file, source);
  if (all.empty()) return;  // its reader says so
  take(source, organOf(source, all), all);
}

void takeFiles(OrganSource& source, const std::vector<std::string>& files) {
  if (files.size() == 1) {
    source.file = files[0];
    if (isImageFile(files[0])) takeLabels(source);
    return;
  }
  if (source.part.find('\n') != source.part.npos)
    throw usageError("{}: of several files one is the organ; give only one --part", source.file);
  std::vector<Found> named = structuresIn(files, source);
  const auto isOrgan = [](const Found& one) { return one.kind == StructureKind::Parenchyma; };
  if (source.part.empty() && std::ranges::none_of(named, isOrgan)) named.clear();
  const std::string first = named.empty() ? "" : named[0].file;
  const std::vector<Found> all = measured(std::move(named), source);
  if (all.empty()) {
    std::vector<std::string> stems;
    for (const std::string& file : files) stems.push_back(fileStem(file));
    if (!first.empty())
      throw error("{}: nothing is labelled in it; choose another organ with --part: {}", first,
                  nameList(stems));
    throw error("{}: none of {} files {}; choose the organ with --part: {}", source.file,
                files.size(),
                source.part.empty() ? "is named as an organ is"
                                    : "is named '" + shownText(source.part, kLongestName) + "'",
                nameList(stems));
  }
  const auto asked = std::ranges::find_if(all, [&](const Found& one) {
    return !source.part.empty() && lowerCase(one.name) == lowerCase(source.part);
  });
  take(source, asked != all.end() ? *asked : organOf(source, all), all);
}

void addStructure(OrganSource& source, StructureKind kind, const std::string& name,
                  const std::string& file, const std::string& part) {
  // What an image labels otherwise is none of the organ's tissue.
  if (kind == StructureKind::Cavity && file.empty() && isImageFile(source.file)) return;
  const std::string& from = file.empty() ? source.file : file;
  for (const BroughtStructure& one : source.structures)
    if (one.file == from && one.part == part)
      throw usageError(
          "{}{} is given two roles, {} and {}; leave one out", part.empty() ? from : "part ",
          part.empty() ? "" : shownText(part, kLongestName), wordOf(one.kind), wordOf(kind));
  int label = 0;
  for (const OrganLabel& one : source.labels) label = std::max(label, one.label);
  for (const BroughtStructure& one : source.structures) label = std::max(label, one.label);
  require(label < 255, "there are more than 255 structures; leave some out");
  const bool vessel = vesselKind(kind).has_value();
  const bool labelled = !vessel && kind != StructureKind::Cavity;
  if (file.empty() && isImageFile(source.file)) {
    require(!source.part.empty(),
            "{}: \"{}\" is a label of the image; name the organ's too, by --part", source.file,
            part);
    source.part += "\n" + (vessel ? std::string(kWithin) + part : part);
  }
  if (kind == StructureKind::Cavity && file.empty()) leaveOut(source.part, part);
  source.structures.push_back({kind, labelled ? label + 1 : 0, name, from, part, source.unit});
}

std::vector<CellsInput> inputsOf(const OrganSource& source) {
  std::vector<CellsInput> inputs;
  const auto add = [&](const std::string& file, std::string_view role, const std::string& part) {
    constexpr std::size_t kMost = std::size_t(1) << 30;
    const RawArray<char> bytes = readForeignFile(file, kMost);
    std::string format = isImageFile(file) ? readLabelFacts(file).description : "";
    std::string parts = part;
    std::ranges::replace(parts, '\n', ',');
    if (!parts.empty()) format += (format.empty() ? "parts " : ", labels ") + parts;
    inputs.push_back({fs::path(file).filename().string(), std::string(role), std::move(format),
                      fmt::format("{:08x}", crc32({bytes.data(), bytes.size()}))});
  };
  if (isBuiltIn(source)) return inputs;
  add(source.file, "organ", source.part);
  for (const BroughtStructure& one : source.structures) add(one.file, wordOf(one.kind), one.part);
  return inputs;
}

}  // namespace resect
