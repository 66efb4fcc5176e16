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

// Fills in the fields of the source from the labels. source.file is a label image, or a folder with
// one image of all structures or an image for each. Labels get their roles by their names
// (anatomy/structure_kind.h).
//
// source.part, if given, names the labels of the organ; for a folder, the organ's file. Otherwise
// the organ is the label whose name means parenchyma, or the only label. Its tumours, cysts and
// vessels become source.structures, unless there are some already. Those from the organ's own file
// also belong to the organ's body. Unless source.pose turns it, the organ lies as in a patient on
// his back (io/scenario/orientation.h) and is not rolled to rest. source.notes says which labels
// were used and which were left out.
//
// Throws Error if no label or more than one could be the organ; the Error lists them.
void takeLabels(OrganSource& source);

// The same for several files, label images or models, in the same coordinates, each with one
// structure. They are treated like the files of a folder. A single file becomes source.file.
void takeFiles(OrganSource& source, const std::vector<std::string>& files);

// Adds a structure that lies in the organ. file: the structure's file; if it is empty, `part` is a
// part of the organ's own file. If that file is an image, the structure's label also becomes part
// of the organ's body, since no voxel has two labels; source.part must then name the organ's label.
// Only a cavity adds nothing then: its voxels do not belong to the organ anyway. name: of the
// structure. Throws a usage Error if source.part is empty then, or if there are more than 255
// structures.
void addStructure(OrganSource& source, StructureKind kind, const std::string& name,
                  const std::string& file, const std::string& part);

// The files that the source is made from, with their roles, for a file of cells.
std::vector<CellsInput> inputsOf(const OrganSource& source);

}  // namespace resect
