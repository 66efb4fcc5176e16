// An organ from the labels of a scan: which label is the organ, and which are vessels and tumours
// in it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/cells/cells_file.h"
#include "operation/scenario.h"

namespace resect {

// Whether the path is that of a label image (isImageFile()), or of any folder.
bool isLabelled(const std::filesystem::path& path);

// Fills in the fields of the source from the labels. source.file is a label image, or a folder with
// one image of all structures or one image for each structure. The name of a label tells which kind
// of structure it is (anatomy/structure_kind.h).
//
// source.part, if given, names the labels of the organ; for a folder, the organ's file. (If
// source.file is an image and source.part or source.structures is given, only the pose is filled
// in.) Otherwise the organ is the label whose name means parenchyma, or the only label. The
// tumours, cysts, cavities and vessels become source.structures, unless source.structures has
// entries already. A tumour, cyst or vessel from the organ's own image also becomes part of the
// organ's body. Unless source.pose turns it, the organ lies as in a patient on his back
// (io/scenario/orientation.h) and is not rolled to a resting pose (geometry/resting_pose.h).
// source.notes says which labels were used and which were left out.
//
// Throws Error if no label or more than one could be the organ; the Error lists the labels.
void takeLabels(OrganSource& source);

// A label image of a folder. Its name tells which kind of structure it holds, or nothing.
struct FolderImage {
  std::string file;
  std::string name;  // of the file, without endings
  std::optional<StructureKind> kind;
};

// The label images of a folder, by name; segmentations of DICOM in any folder below. `notes` gets a
// sentence about slices of scans, which are left out. Throws Error if there is no label image.
std::vector<FolderImage> imagesOf(const std::string& folder, std::vector<std::string>& notes);

// The same for several files, label images or models, in the same coordinates, each with one
// structure. They are treated like the files of a folder. A single file becomes source.file.
void takeFiles(OrganSource& source, const std::vector<std::string>& files);

// Adds a structure that lies in the organ. file: the structure's file; if it is empty, `part` is a
// part of the organ's own file. If that file is an image, the structure's label also becomes part
// of the organ's body, since no voxel has two labels; so source.part must name the organ's label. A
// cavity in such an image is not added: its voxels do not belong to the organ anyway. name: the
// structure's name. Throws a usage Error if source.part must name a label and is empty, or if there
// are more than 255 structures.
void addStructure(OrganSource& source, StructureKind kind, const std::string& name,
                  const std::string& file, const std::string& part);

// The files that the source is made from, with their roles, for a file of cells.
std::vector<CellsInput> inputsOf(const OrganSource& source);

}  // namespace resect
