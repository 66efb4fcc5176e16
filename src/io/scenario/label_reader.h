// Reads the labels of an organ and their materials: [[organ.label]] and [[tissue.material]] of
// docs/scenarios.md.
#pragma once

#include "io/scenario/toml_table.h"
#include "operation/scenario.h"

namespace resect {

// All [[label]] of an organ's table; a label may occur several times; where it is named, always
// with one name.
std::vector<OrganLabel> readLabels(const TomlTable& organ);

// young, poisson, density and tear_stretch; keys not given keep the values of `defaults`.
TissueMaterial readMaterial(const TomlTable& t, const TissueMaterial& defaults);

// All [[material]] of the tissue's table; missing keys have the values of the organ's own material.
std::vector<LabelMaterial> readMaterials(const TomlTable& tissue, const TissueMaterial& own);

}  // namespace resect
