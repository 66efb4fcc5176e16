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

// Whether the file is a label image or a scan, judged by its name. DICOM files often have no
// extension, so they are recognised by their first bytes. The rest of the content is not checked.
bool isImageFile(const std::filesystem::path& path);

// kind: one for which isImage() is true. bytes: content of the file, decompressed.
LabelImage readLabelImage(ModelKind kind, const std::string& path, std::string_view bytes,
                          const BesideFiles& beside = {});

// What an image holds, without its voxels.
struct LabelFacts {
  std::string description;  // description() of the image
  double voxelVolume = 0;   // m^3
  std::vector<ImageLabel> labels;
  // Whether the names in `labels` are guesses: if an image has more than 20 labels, none with a
  // name and none with a number that TotalSegmentator does not use, its names are taken.
  bool guessed = false;
  std::vector<bool> cutOff;  // for each label: whether it reaches the border of the image

  double volume(std::size_t label) const { return double(labels[label].voxels) * voxelVolume; }
};

LabelFacts factsOf(const std::string& path, const LabelImage& image);

// Reads the image in a sandboxed child process, calls `work` there, and returns what it returns.
std::string inImageReader(const std::filesystem::path& path, const Progress& progress,
                          const std::function<std::string(const LabelImage&)>& work);

// Reads the file in a sandboxed child process. A single label without a name gets the name of the
// file, without folder and extension.
LabelFacts readLabelFacts(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace resect
