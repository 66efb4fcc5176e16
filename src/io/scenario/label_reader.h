// Reads the labels of an organ and their materials: [[organ.label]] and [[tissue.material]] of
// docs/scenarios.md.
#pragma once

#include "io/scenario/toml_table.h"
#include "operation/scenario.h"

namespace resect {

// All [[label]] of an organ's table. A label's number may occur several times, but with one name
// only (else an Error).
std::vector<OrganLabel> readLabels(const TomlTable& organ);

// Reads young, poisson, density and tear_stretch; a missing key has its value from `defaults`.
TissueMaterial readMaterial(const TomlTable& t, const TissueMaterial& defaults);

// All [[material]] of the tissue's table; a missing key has its value from `own`, the material of
// the organ's own cells.
std::vector<LabelMaterial> readMaterials(const TomlTable& tissue, const TissueMaterial& own);

}  // namespace resect
