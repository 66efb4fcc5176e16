#include "anatomy/structure_kind.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace resect {
namespace {

constexpr int kFirstVessel = int(StructureKind::PortalVein);

struct Word {
  std::string_view word;
  StructureKind kind;
};

// Usual words, lower case, with blanks between words. Where one is the beginning of another, the
// longer one stands first.
constexpr std::array kUsual{
    Word{"parenchyma", StructureKind::Parenchyma},
    // Vessels of the liver that no one told apart are taken as the portal vein, which is most of
    // them.
    Word{"liver vessel", StructureKind::PortalVein},
    Word{"liver tumo", StructureKind::Tumour},
    Word{"liver lesion", StructureKind::Tumour},
    Word{"liver cyst", StructureKind::Cyst},
    Word{"liver", StructureKind::Parenchyma},
    Word{"tumour", StructureKind::Tumour},
    Word{"tumor", StructureKind::Tumour},
    Word{"metastas", StructureKind::Tumour},
    Word{"carcinoma", StructureKind::Tumour},
    Word{"lesion", StructureKind::Tumour},
    Word{"neoplasm", StructureKind::Tumour},
    Word{"hcc", StructureKind::Tumour},
    Word{"cyst", StructureKind::Cyst},
    Word{"gallbladder", StructureKind::Gallbladder},
    Word{"gall bladder", StructureKind::Gallbladder},
    Word{"cavity", StructureKind::Cavity},
    Word{"lumen", StructureKind::Cavity},
    Word{"portal", StructureKind::PortalVein},
    Word{"hepatic vein", StructureKind::HepaticVein},
    Word{"vena cava", StructureKind::HepaticVein},
    Word{"hepatic arter", StructureKind::HepaticArtery},
    Word{"arter", StructureKind::HepaticArtery},
    Word{"bile duct", StructureKind::BileDuct},
    Word{"biliary", StructureKind::BileDuct},
};

}  // namespace

std::string_view wordOf(StructureKind kind) {
  constexpr std::array<std::string_view, kFirstVessel> kWords{"parenchyma", "tumour", "cyst",
                                                              "gallbladder", "cavity"};
  if (const auto vessel = vesselKind(kind)) return wordOf(*vessel);
  return kWords[std::size_t(kind)];
}

std::string structureWords() {
  std::string words;
  for (int k = int(StructureKind::Parenchyma) + 1; k < kStructureKinds; ++k)
    words.append(words.empty() ? "" : ", ").append(wordOf(StructureKind(k)));
  return words;
}

std::optional<StructureKind> structureKind(std::string_view name) {
  std::string plain(name);
  for (char& c : plain)
    c = c == '-' || c == '_' ? ' ' : char(std::tolower(static_cast<unsigned char>(c)));
  const auto found =
      std::ranges::find_if(kUsual, [&](const Word& w) { return plain.starts_with(w.word); });
  if (found == kUsual.end()) return {};
  return found->kind;
}

std::optional<VesselKind> vesselKind(StructureKind kind) {
  if (int(kind) < kFirstVessel) return {};
  return VesselKind(int(kind) - kFirstVessel);
}

}  // namespace resect
