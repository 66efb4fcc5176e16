// The kinds of structures in and on an organ. Each kind has one name. Scenarios, the parts of model
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
  Cavity,  // a space without tissue, such as the lumen of a hollow organ
  PortalVein,
  HepaticVein,
  HepaticArtery,
  BileDuct
};
inline constexpr int kStructureKinds = 9;

// The name of a kind in files, such as "tumour" or "portal-vein". A kind of vessel has the name of
// its VesselKind.
std::string_view wordOf(StructureKind kind);
// The names of what can lie in an organ (all but "parenchyma"), for messages: "tumour, cyst, ...".
std::string structureWords();

// The kind that a name stands for. The name must begin with the name of a kind, or with a usual
// synonym of such a name. Case does not matter; words may be separated by spaces, "-" or "_".
// Examples: "Tumour 2", "metastasis", "portal_vein_left". The result is empty if the name stands
// for no kind.
std::optional<StructureKind> structureKind(std::string_view name);

// The kind of the vessel; empty if the structure is no vessel.
std::optional<VesselKind> vesselKind(StructureKind kind);

}  // namespace resect
