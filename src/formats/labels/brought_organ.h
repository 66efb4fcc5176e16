// Makes an OrganSource from the labels of a scan. An OrganSource says from which files and parts an
// organ is made. The functions decide which label is the organ, and which labels are vessels and
// tumours in the organ.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/cells/cells_file.h"
#include "operation/scenario.h"

namespace resect {

// Whether the path leads to a label image (isImageFile()) or to any folder.
bool isLabelled(const std::filesystem::path& path);

// Fills in the fields of the source from the labels. source.file is a label image or a folder. A
// folder contains one image of all structures, or one image for each structure. A structure is, for
// example, the organ, a vessel or a tumour. The name of a label tells the kind of the structure
// (anatomy/structure_kind.h).
//
// If source.part is given, it names the labels of the organ, or for a folder the organ's file. If
// source.part is not given, the organ is the label whose name means parenchyma (the organ's own
// tissue), or the only label. If source.file is an image, and source.part or source.structures is
// given, only the pose is filled in.
//
// The tumours, cysts, cavities and vessels become source.structures, unless source.structures has
// entries already. A tumour, a cyst or a vessel from the organ's own image also becomes part of the
// organ's body. source.notes says which labels were used and which were left out.
//
// If source.pose has no rotation, the organ is laid as in a patient on his back
// (io/scenario/orientation.h), and is not rolled to a resting pose (geometry/resting_pose.h).
//
// Throws Error if no label could be the organ, or if more than one label could. The Error lists the
// labels.
void takeLabels(OrganSource& source);

// A label image of a folder.
struct FolderImage {
  std::string file;
  std::string name;                   // of the file, without folder and endings
  std::optional<StructureKind> kind;  // kind that the name means; nothing if it means none
};

// The label images of a folder, sorted by name. DICOM segmentations are also found in subfolders.
// DICOM files of the scan itself are left out; `notes` then gets a sentence about this. Throws
// Error if there is no label image.
std::vector<FolderImage> imagesOf(const std::string& folder, std::vector<std::string>& notes);

// Fills in the fields of the source from several files, which are treated like the files of a
// folder in takeLabels(). Each file is a label image or a model, and has one structure. All files
// must have the same coordinate system. If there is only one file, it becomes source.file.
void takeFiles(OrganSource& source, const std::vector<std::string>& files);

// Adds a structure that lies in the organ. file: the structure's file; if it is empty, `part` is a
// part of the organ's own file. name: the structure's name.
//
// In an image, the voxels of a structure usually do not have the organ's label. So if a structure
// is a label of the organ's own image, its label also becomes part of the organ's body. In this
// case, source.part must name the organ's label. A cavity from this image is not added, because its
// voxels do not have the organ's label, so the organ is hollow there already.
//
// Throws a usage Error in these cases: source.part must name a label but is empty; the same part of
// the same file is a structure already; there would be more than 255 structures.
void addStructure(OrganSource& source, StructureKind kind, const std::string& name,
                  const std::string& file, const std::string& part);

// The files that the organ is made from, with their roles, for the header of a file of cells.
std::vector<CellsInput> inputsOf(const OrganSource& source);

}  // namespace resect
