#include "formats/labels/label_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <sstream>

#include "base/error.h"
#include "base/text/file_stem.h"
#include "formats/child/foreign_reading.h"
#include "formats/gzip.h"
#include "formats/images/dicom_file.h"
#include "formats/images/meta_image_file.h"
#include "formats/images/nifti_file.h"
#include "formats/images/nrrd_file.h"
#include "formats/labels/label_model.h"
#include "formats/labels/label_names.h"
#include "formats/meshes/word_reader.h"

namespace resect {
namespace {

namespace fs = std::filesystem;

// The child's answer: a line for the image and one for each label.
std::string asText(const LabelFacts& facts) {
  std::string text =
      fmt::format("{}\n{} {}\n", facts.description, facts.voxelVolume, int(facts.guessed));
  for (std::size_t i = 0; i < facts.labels.size(); ++i) {
    const ImageLabel& label = facts.labels[i];
    std::string name = label.name;
    std::ranges::replace(name, '\n', ' ');
    text += fmt::format("{} {} {} {}\n", label.value, label.voxels, int(facts.cutOff[i]), name);
  }
  return text;
}

LabelFacts fromText(const std::string& path, const std::string& text) {
  std::istringstream lines(text);
  LabelFacts facts;
  std::string line;
  if (!std::getline(lines, facts.description) || !std::getline(lines, line))
    throw error("{}: was read without an answer; try again", path);
  int guessed = 0;
  std::istringstream(line) >> facts.voxelVolume >> guessed;
  facts.guessed = guessed != 0;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    ImageLabel label;
    int cutOff = 0;
    words >> label.value >> label.voxels >> cutOff;
    words.get();
    std::getline(words, label.name);
    if (label.voxels < 1 || label.voxels > kMostVoxels)
      throw error("{}: was read with a wrong answer; try again", path);
    facts.labels.push_back(std::move(label));
    facts.cutOff.push_back(cutOff != 0);
  }
  return facts;
}

}  // namespace

bool isImageFile(const fs::path& path) {
  constexpr std::array kEndings{".nii", ".nrrd", ".nhdr", ".mha", ".mhd", ".hdr", ".dcm"};
  const std::string last = lowerCase(path.extension().string());
  const std::string ending = last == ".gz" ? lowerCase(path.stem().extension().string()) : last;
  if (std::ranges::find(kEndings, ending) != kEndings.end()) return true;
  std::error_code ec;
  if (!fs::is_regular_file(path, ec)) return false;
  std::array<char, 133> start{};
  std::ifstream(path, std::ios::binary).read(start.data(), start.size());
  return startsAsDicom({start.data(), start.size()});
}

LabelImage readLabelImage(ModelKind kind, const std::string& path, std::string_view bytes,
                          const BesideFiles& beside) {
  switch (kind) {
    case ModelKind::Nifti:
      return readNiftiFile(path, bytes, beside);
    case ModelKind::Nrrd:
      return readNrrdFile(path, bytes, beside);
    case ModelKind::MetaImage:
      return readMetaImageFile(path, bytes, beside);
    default:
      return readDicomFile(path, bytes);
  }
}

LabelFacts factsOf(const std::string& path, const LabelImage& image) {
  LabelFacts facts{description(image), image.voxelVolume(), image.labels, false,
                   std::vector<bool>(image.labels.size(), false)};
  constexpr std::size_t kManyLabels = 20;
  facts.guessed =
      facts.labels.size() > kManyLabels &&
      std::ranges::all_of(facts.labels, [](const ImageLabel& l) {
        return l.name.empty() && !totalSegmentatorName(l.value).empty();  // an atlas has others too
      });
  if (facts.guessed)
    for (ImageLabel& label : facts.labels) label.name = totalSegmentatorName(label.value);
  if (facts.labels.size() == 1 && facts.labels[0].name.empty())
    facts.labels[0].name = fileStem(path);
  const Vec3i& n = image.dims;
  for (const RawArray<std::uint16_t>& layer : image.layers) {
    std::size_t i = 0;
    for (int z = 0; z < n.z(); ++z)
      for (int y = 0; y < n.y(); ++y) {
        const bool innerSlice = image.slicesLeftOut || (z > 0 && z + 1 < n.z());
        const bool inner = innerSlice && y > 0 && y + 1 < n.y();
        for (int x = 0; x < n.x(); x += inner && x == 0 && n.x() > 1 ? n.x() - 1 : 1)
          if (const std::uint16_t label = layer[i + std::size_t(x)])
            facts.cutOff[std::size_t(label) - 1] = true;
        i += std::size_t(n.x());
      }
  }
  return facts;
}

std::string inImageReader(const fs::path& path, const Progress& progress,
                          const std::function<std::string(const LabelImage&)>& work) {
  const std::string name = path.string();
  ForeignReading how;
  how.seconds = kImageSeconds;
  how.progress = progress;
  how.prepare = [](std::string_view bytes) {
    if (startsAsDicom(bytes)) prepareDicom();
  };
  return readForeign(path, how, [&](const ForeignFile& file) {
    std::string unpacked;
    std::string_view bytes = file.bytes;
    if (isGzip(bytes)) bytes = unpacked = unpackGzip(name, bytes, kMostImageBytes);
    const ModelKind kind = modelKind(path, bytes);
    if (!isImage(kind)) throw error("{}: is no label image; use .nii, .nrrd, .mha or DICOM", name);
    return work(readLabelImage(kind, name, bytes, file.beside));
  });
}

LabelFacts readLabelFacts(const fs::path& path, const Progress& progress) {
  const std::string name = path.string();
  return fromText(name, inImageReader(path, progress, [&](const LabelImage& image) {
                    return asText(factsOf(name, image));
                  }));
}

}  // namespace resect
