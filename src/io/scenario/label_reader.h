// Which structures does a scenario mark in its organ, and what are they of? [[organ.label]] and
// [[tissue.material]] of docs/scenarios.md.
#pragma once

#include "io/scenario/toml_table.h"
#include "operation/scenario.h"

namespace resect {

// All [[label]] of an organ's table; a label may come several times, with one name.
std::vector<OrganLabel> readLabels(const TomlTable& organ);

// name, young, poisson, density and tear_stretch; missing ones are those of `missing`.
TissueMaterial readMaterial(const TomlTable& t, const TissueMaterial& missing);

// All [[material]] of the tissue's table; missing keys are those of the organ's own.
std::vector<LabelMaterial> readMaterials(const TomlTable& tissue, const TissueMaterial& own);

}  // namespace resect
