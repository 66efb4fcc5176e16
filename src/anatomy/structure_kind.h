// Kinds of structures in and at an organ: one list of words for scenarios, parts of models and
// label images.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "anatomy/anatomy.h"

namespace resect {

enum class StructureKind {
  Parenchyma,
  Tumour,
  Cyst,
  Gallbladder,
  Cavity,  // without tissue, as the lumen of a hollow organ
  PortalVein,
  HepaticVein,
  HepaticArtery,
  BileDuct
};
inline constexpr int kStructureKinds = 9;

// The word of a kind in files, such as "tumour" or "portal-vein"; vessels have those of VesselKind.
std::string_view wordOf(StructureKind kind);
// All words, "parenchyma, tumour, ...", for messages.
std::string structureWords();

// The kind that a name tells: it is, or begins with, the word of a kind or a usual word for it,
// with any case, and blanks, "-" or "_" between words: "Tumour 2", "metastasis",
// "portal_vein_left". Nothing if it tells none.
std::optional<StructureKind> structureKind(std::string_view name);

// Nothing if the kind is no vessel.
std::optional<VesselKind> vesselKind(StructureKind kind);

}  // namespace resect
