// Reads the labels of an organ and their materials: [[organ.label]] and [[tissue.material]] of
// docs/scenarios.md.
#pragma once

#include "io/scenario/toml_table.h"
#include "operation/scenario.h"

namespace resect {

// All [[label]] of an organ's table; a label may occur several times, with the same name.
std::vector<OrganLabel> readLabels(const TomlTable& organ);

// name, young, poisson, density and tear_stretch; missing keys have the values of `missing`.
TissueMaterial readMaterial(const TomlTable& t, const TissueMaterial& missing);

// All [[material]] of the tissue's table; missing keys have the values of the organ's own material.
std::vector<LabelMaterial> readMaterials(const TomlTable& tissue, const TissueMaterial& own);

}  // namespace resect
