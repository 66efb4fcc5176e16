#include "io/scenario/label_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/model.h"
#include "io/scenario/length.h"
#include "io/scenario/region_reader.h"

namespace resect {
namespace {

constexpr int kLastLabel = 255;

// The first number from 1 that no label has.
int freeLabel(const TomlTable& t, const OrganSource& organ) {
  const auto taken = [&](int label) {
    return std::ranges::find(organ.labels, label, &OrganLabel::label) != organ.labels.end() ||
           std::ranges::find(organ.structures, label, &BroughtStructure::label) !=
               organ.structures.end();
  };
  for (int label = 1; label <= kLastLabel; ++label)
    if (!taken(label)) return label;
  t.complain("kind",
             fmt::format("would be label {}; an organ has at most {}", kLastLabel + 1, kLastLabel));
}

// "tumour", "tumour 2", ...
std::string freeName(const OrganSource& organ, std::string_view word) {
  const auto taken = [&](const std::string& name) {
    return std::ranges::find(organ.labels, name, &OrganLabel::name) != organ.labels.end() ||
           std::ranges::find(organ.structures, name, &BroughtStructure::name) !=
               organ.structures.end();
  };
  std::string name(word);
  for (int number = 2; taken(name); ++number) name = fmt::format("{} {}", word, number);
  return name;
}

void addStructure(const TomlTable& t, StructureKind kind, OrganSource& organ) {
  const bool labelled = !vesselKind(kind) && kind != StructureKind::Cavity;
  const int label = labelled ? freeLabel(t, organ) : 0;
  const std::string name = labelled ? freeName(organ, wordOf(kind)) : "";
  if (!labelled || t.has("file")) {
    BroughtStructure one{kind, label, name, t.text("file"), "", organ.unit};
    one.part = partLines(t.isList("part") ? t.texts("part") : partNames(t.text("part", "")));
    if (t.has("unit")) one.unit = parseUnit(t.text("unit"), "unit");
    if (kind == StructureKind::Cavity && one.file == organ.file) leaveOut(organ.part, one.part);
    organ.structures.push_back(std::move(one));
  } else {
    organ.labels.push_back({label, name, readRegion(t)});
  }
  t.refuseUnknownKeys();
}

}  // namespace

void readLabels(const TomlTable& t, OrganSource& organ) {
  for (const TomlTable& one : t.tables("label")) {
    OrganLabel label{one.integer("label", 1, kLastLabel), one.text("name", ""), readRegion(one)};
    for (const OrganLabel& before : organ.labels)
      if (before.label == label.label && !label.name.empty() && !before.name.empty() &&
          before.name != label.name)
        one.complain("name", "is \"" + label.name + "\", and label " + std::to_string(label.label) +
                                 " was \"" + before.name + "\" before; a label has one name");
    one.refuseUnknownKeys();
    organ.labels.push_back(std::move(label));
  }
  for (const TomlTable& one : t.tables("tumour")) addStructure(one, StructureKind::Tumour, organ);
  for (const TomlTable& one : t.tables("structure")) {
    const std::string word = one.text("kind");
    const auto kind = structureKind(word);
    if (!kind || wordOf(*kind) != word || kind == StructureKind::Parenchyma)
      one.complain("kind", "is \"" + word + "\"; use one of " + structureWords());
    addStructure(one, *kind, organ);
  }
}

namespace {

// Two lists of one length: shares and times of Maxwell branches.
std::vector<Relaxation> readBranches(const TomlTable& t, const std::vector<Relaxation>& missing) {
  const std::vector<double> shares =
      t.numbers("relaxation_shares", ranges::kRelaxationShare.low, ranges::kRelaxationShare.high);
  const std::vector<double> times =
      t.numbers("relaxation_times", ranges::kRelaxationTime.low, ranges::kRelaxationTime.high);
  if (!t.has("relaxation_shares") && !t.has("relaxation_times")) return missing;
  if (shares.size() != times.size() || shares.size() > kMostBranches)
    t.complain(t.has("relaxation_times") ? "relaxation_times" : "relaxation_shares",
               fmt::format("has {} entries, and there are {} shares; give a time, s, for each "
                           "share, and at most {}",
                           times.size(), shares.size(), kMostBranches));
  std::vector<Relaxation> branches;
  for (std::size_t k = 0; k < shares.size(); ++k) branches.push_back({shares[k], times[k]});
  return branches;
}

// tear_energy, or tear_stretch, its older name. The other keys of `material` have been read.
double readTearEnergy(const TomlTable& t, const TissueMaterial& material,
                      std::vector<std::string>& notes) {
  if (!t.has("tear_stretch"))
    return t.number("tear_energy", ranges::kTearEnergy, material.tearEnergy);
  if (t.has("tear_energy"))
    t.complain("tear_stretch", "is the older name of tear_energy; keep one of the two");
  const double stretch = t.number("tear_stretch", ranges::kTearStretch, 1);
  const double energy = std::clamp(energyOfStretch(material, stretch), ranges::kTearEnergy.low,
                                   ranges::kTearEnergy.high);
  notes.push_back(fmt::format(
      "tear_stretch = {:g} is read as tear_energy = {:.3g} J/m^2, at which smooth tissue tears at "
      "that stretch; give tear_energy instead",
      stretch, energy));
  return energy;
}

}  // namespace

TissueMaterial readMaterial(const TomlTable& t, const TissueMaterial& defaults,
                            std::vector<std::string>& notes) {
  TissueMaterial material = defaults;
  material.young = t.number("young", ranges::kYoung, defaults.young);
  material.poisson = t.number("poisson", ranges::kPoisson, defaults.poisson);
  material.density = t.number("density", ranges::kDensity, defaults.density);
  material.stiffening = t.number("stiffening", ranges::kStiffening, defaults.stiffening);
  material.capsule = t.number("capsule", ranges::kCapsule, defaults.capsule);
  material.capsuleStrength =
      t.number("capsule_strength", ranges::kCapsuleStrength, defaults.capsuleStrength);
  material.capsuleTension =
      t.number("capsule_tension", ranges::kCapsuleTension, defaults.capsuleTension);
  material.cutEnergy = t.number("cut_energy", ranges::kCutEnergy, defaults.cutEnergy);
  material.capsuleCutEnergy =
      t.number("capsule_cut_energy", ranges::kCapsuleCutEnergy, defaults.capsuleCutEnergy);
  material.branches = readBranches(t, defaults.branches);
  material.tearEnergy = readTearEnergy(t, material, notes);
  if (material.waveSpeed() > ranges::kFastestWave)
    t.complain("young",
               fmt::format("makes pressure waves, with poisson and density, of {:.0f} m/s, faster "
                           "than the {:g} m/s of "
                           "any tissue; give a smaller young or poisson, or a greater density",
                           material.waveSpeed(), ranges::kFastestWave));
  return material;
}

std::vector<LabelMaterial> readMaterials(const TomlTable& tissue, const TissueMaterial& own,
                                         std::vector<std::string>& notes) {
  std::vector<LabelMaterial> materials;
  for (const TomlTable& t : tissue.tables("material")) {
    LabelMaterial one{t.integer("label", 1, kLastLabel), readMaterial(t, own, notes)};
    one.material.name = t.text("name", "label " + std::to_string(one.label));
    if (std::any_of(materials.begin(), materials.end(),
                    [&](const LabelMaterial& before) { return before.label == one.label; }))
      t.complain("label", "is " + std::to_string(one.label) +
                              ", which has a material already; keep one of the two");
    t.refuseUnknownKeys();
    materials.push_back(std::move(one));
  }
  return materials;
}

}  // namespace resect
