// Reads label images of all supported file formats.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "formats/beside_files.h"
#include "formats/images/label_image.h"
#include "formats/model_kind.h"

namespace resect {

// Whether the file is a label image or a scan. It counts as an image if its name has the extension
// of an image format. DICOM files often have no extension. So a file with another extension, or
// with none, counts as an image if its first bytes are those of DICOM. Nothing else of the content
// is checked.
bool isImageFile(const std::filesystem::path& path);

// kind: must be a kind of image (isImage() in formats/model_kind.h). bytes: content of the file,
// decompressed. beside: the files that the image refers to.
LabelImage readLabelImage(ModelKind kind, const std::string& path, std::string_view bytes,
                          const BesideFiles& beside = {});

// Facts about a label image, without its voxels.
struct LabelFacts {
  std::string description;  // result of description() (formats/images/label_image.h)
  double voxelVolume = 0;   // volume of one voxel, m^3
  std::vector<ImageLabel> labels;
  // Whether the names in `labels` are guesses. They are guesses under three conditions: the image
  // has more than 20 labels, no label has a name, and the program TotalSegmentator has a name for
  // each label's number. Each label then gets TotalSegmentator's name.
  bool guessed = false;
  std::vector<bool> cutOff;  // for each label: whether its voxels reach the image's border

  double volume(std::size_t label) const { return double(labels[label].voxels) * voxelVolume; }
};

LabelFacts factsOf(const std::string& path, const LabelImage& image);

// Reads the image in a sandboxed child process, calls `work` there, and returns the result of
// `work`.
std::string inImageReader(const std::filesystem::path& path, const Progress& progress,
                          const std::function<std::string(const LabelImage&)>& work);

// Reads the file in a sandboxed child process. If the image has only one label and this label has
// no name, the label gets the name of the file, without folder and extension.
LabelFacts readLabelFacts(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace resect
