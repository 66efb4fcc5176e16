// The kinds of structures in and on an organ, with one name each. Scenarios, the parts of model
// files and label images all use these names.
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

// The name of a kind in files, such as "tumour" or "portal-vein"; vessels have the names of their
// VesselKind.
std::string_view wordOf(StructureKind kind);
// All names, as "parenchyma, tumour, ...", for messages.
std::string structureWords();

// The kind that a name stands for: the name is, or begins with, the name of a kind or a usual
// synonym of it. Case does not matter; words may be separated by spaces, "-" or "_". Examples:
// "Tumour 2", "metastasis", "portal_vein_left". Empty if the name stands for no kind.
std::optional<StructureKind> structureKind(std::string_view name);

// The kind of the vessel; empty if the structure is no vessel.
std::optional<VesselKind> vesselKind(StructureKind kind);

}  // namespace resect
