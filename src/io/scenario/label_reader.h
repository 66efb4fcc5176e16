// Reads the labels and structures of an organ, and the materials of labels, from a scenario:
// [[organ.label]], [[organ.tumour]], [[organ.structure]] and [[tissue.material]] in
// docs/scenarios.md.
#pragma once

#include "io/scenario/toml_table.h"
#include "operation/scenario.h"

namespace resect {

// Reads all [[label]], [[tumour]] and [[structure]] entries of an organ's table into `organ`. The
// unit of `organ` must already have been read. A label is a number that marks cells of the organ.
// Several [[label]] entries may give the same label; throws Error if they give it different names.
// Each [[tumour]] or [[structure]] entry gets a label that is not used yet, except vessels and
// cavities, which get none. The name of this label is made from the kind of the structure:
// "tumour", "tumour 2".
void readLabels(const TomlTable& t, OrganSource& organ);

// Reads the TOML keys of a material. A missing key gets its value from `defaults`. The outdated key
// tear_stretch is converted to the tear energy by energyOfStretch() (tissue/material.h), and
// `notes` gets a sentence about it.
TissueMaterial readMaterial(const TomlTable& t, const TissueMaterial& defaults,
                            std::vector<std::string>& notes);

// All [[material]] entries of the tissue's table, at most one per label. A missing key gets its
// value from `own`, the material of the cells with label 0.
std::vector<LabelMaterial> readMaterials(const TomlTable& tissue, const TissueMaterial& own,
                                         std::vector<std::string>& notes);

}  // namespace resect
