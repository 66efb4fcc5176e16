// An organ from the labels of a scan: which label is the organ, and which are vessels and tumours
// in it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/cells/cells_file.h"
#include "operation/scenario.h"

namespace resect {

// Whether the path is that of a label image (isImageFile()), or of a folder of them.
bool isLabelled(const std::filesystem::path& path);

// Fills in what the labels tell: source.file is a label image, or a folder with an image for each
// structure or one for all. Labels get their roles by their names (anatomy/structure_kind.h).
//
// source.part, if given, names the labels of the organ, in a folder the structure's file. Otherwise
// the organ is the label whose name tells parenchyma, or the only one. Its tumours, cysts and
// vessels become source.structures, unless there are some already; those of the same file belong
// to the organ's body, too. An organ from an image lies as in the patient, who lies on the back
// (io/scenario/orientation.h), and is not rolled to rest. What was taken and what was left out is
// said in source.notes.
//
// Throws Error if no label or more than one could be the organ; the Error lists them.
void takeLabels(OrganSource& source);

// The same for several files with a structure each, label images or models, in the same
// coordinates: as a folder of them. One file alone is taken as source.file.
void takeFiles(OrganSource& source, const std::vector<std::string>& files);

// Adds a structure that lies in the organ: a file, or with `file` empty a part of the organ's own
// file. Of an image, the structure's label also becomes part of the organ's body, since no voxel
// has two labels; source.part must then name the organ's. A cavity that is a label of the organ's
// own image adds nothing, since its voxels are not the organ's anyway. name: of the structure.
// Throws a usage Error if it does not, or if there are more than 255 structures.
void addStructure(OrganSource& source, StructureKind kind, const std::string& name,
                  const std::string& file, const std::string& part);

// The files that the source is made from, with their roles, for a file of cells.
std::vector<CellsInput> inputsOf(const OrganSource& source);

}  // namespace resect
