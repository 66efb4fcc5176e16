// Reads the labels and structures of an organ and the labels' materials from a scenario:
// [[organ.label]], [[organ.tumour]], [[organ.structure]] and [[tissue.material]] in
// docs/scenarios.md.
#pragma once

#include "io/scenario/toml_table.h"
#include "operation/scenario.h"

namespace resect {

// Reads all [[label]], [[tumour]] and [[structure]] entries of an organ's table into `organ`, whose
// unit must have been read. Several labels may have the same number, but they must not give it
// different names; else Error is thrown. Tumours and structures get numbers that are free, and
// names by their kind: "tumour", "tumour 2".
void readLabels(const TomlTable& t, OrganSource& organ);

// Reads the keys of a material. One that is missing gets its value from `defaults`. tear_stretch,
// the older name of tear_energy, gives the energy of energyOfStretch() (tissue/material.h) and a
// sentence in `notes`.
TissueMaterial readMaterial(const TomlTable& t, const TissueMaterial& defaults,
                            std::vector<std::string>& notes);

// All [[material]] entries of the tissue's table, at most one per label. A key that is missing gets
// its value from `own`, the material of the cells with label 0.
std::vector<LabelMaterial> readMaterials(const TomlTable& tissue, const TissueMaterial& own,
                                         std::vector<std::string>& notes);

}  // namespace resect
