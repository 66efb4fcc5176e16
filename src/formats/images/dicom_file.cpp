#include "formats/images/dicom_file.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcdeftag.h>
#include <dcmtk/dcmdata/dcdict.h>
#include <dcmtk/dcmdata/dcfilefo.h>
#include <dcmtk/dcmdata/dcistrmb.h>
#include <dcmtk/dcmdata/dcitem.h>
#include <dcmtk/dcmdata/dcmetinf.h>
#include <dcmtk/dcmdata/dcsequen.h>
#include <dcmtk/dcmdata/dcuid.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "base/error.h"
#include "formats/images/voxel_values.h"

namespace resect {
namespace {

// One frame of the segmentation: a slice of one segment.
struct Frame {
  Vec3 position = Vec3::Zero();  // of its first pixel, mm
  int segment = 0;
};

std::string textOf(DcmItem& item, const DcmTagKey& tag) {
  OFString text;
  return item.findAndGetOFString(tag, text).good() ? text.c_str() : "";
}

// The numbers of an element, as many as it has.
std::vector<double> numbersOf(DcmItem& item, const DcmTagKey& tag) {
  std::vector<double> numbers;
  for (unsigned long i = 0; i < 6; ++i) {
    Float64 number = 0;
    if (item.findAndGetFloat64(tag, number, i).bad()) break;
    numbers.push_back(number);
  }
  return numbers;
}

// The first item of a sequence in the item; null if there is none.
DcmItem* itemOf(DcmItem* item, const DcmTagKey& sequence, long number = 0) {
  DcmItem* found = nullptr;
  return item && item->findAndGetSequenceItem(sequence, found, number).good() ? found : nullptr;
}

class Segmentation {
 public:
  Segmentation(const std::string& path, std::string_view bytes) : path_(path) {
    DcmInputBufferStream stream;
    stream.setBuffer(bytes.data(), offile_off_t(bytes.size()));
    stream.setEos();
    file_.transferInit();
    const OFCondition read = file_.read(stream);
    file_.transferEnd();
    if (read.bad() || !file_.getDataset())
      throw error("{}: its DICOM data are damaged ({}); copy or export it again", path,
                  read.text());
    data_ = file_.getDataset();
    const std::string kind = textOf(*data_, DCM_SOPClassUID);
    if (kind != UID_SegmentationStorage)
      throw notLabels(path, fmt::format("it is a DICOM file of modality {}",
                                        textOf(*data_, DCM_Modality).substr(0, 16)));
  }

  LabelImage image() {
    readFrames();
    LabelImage image;
    image.format = "DICOM SEG";
    image.slicesLeftOut = true;
    place(image);
    checkGrid(path_, image);
    fill(image);
    return image;
  }

 private:
  [[nodiscard]] Error damaged(const char* what) const {
    return error("{}: this DICOM segmentation has no {}; export it again", path_, what);
  }

  // The item of a frame's functional groups, or of those that all frames share.
  DcmItem* group(long frame, const DcmTagKey& tag) {
    DcmItem* own = itemOf(itemOf(data_, DCM_PerFrameFunctionalGroupsSequence, frame), tag);
    return own ? own : itemOf(itemOf(data_, DCM_SharedFunctionalGroupsSequence), tag);
  }

  void readFrames() {
    Sint32 count = 0;
    if (data_->findAndGetSint32(DCM_NumberOfFrames, count).bad())
      count = 1;  // the number is missing, as in frames taken out of a file
    if (count < 1) throw damaged("frames");
    Uint16 rows = 0, columns = 0;
    data_->findAndGetUint16(DCM_Rows, rows);
    data_->findAndGetUint16(DCM_Columns, columns);
    if (rows == 0 || columns == 0) throw damaged("rows and columns");
    if (double(count) * rows * columns > 16.0 * double(kMostVoxels))
      throw error("{}: has {} frames of {} x {} pixels, which are too many; export fewer segments",
                  path_, count, columns, rows);
    columns_ = columns, rows_ = rows;
    for (long f = 0; f < count; ++f) {
      DcmItem* const plane = group(f, DCM_PlanePositionSequence);
      DcmItem* const which = group(f, DCM_SegmentIdentificationSequence);
      const std::vector<double> at =
          plane ? numbersOf(*plane, DCM_ImagePositionPatient) : std::vector<double>();
      Uint16 segment = 0;
      if (at.size() != 3) throw damaged("position for each frame");
      if (!which || which->findAndGetUint16(DCM_ReferencedSegmentNumber, segment).bad() ||
          segment == 0)
        throw damaged("segment for each frame");
      frames_.push_back({Vec3(at[0], at[1], at[2]), int(segment)});
    }
  }

  void place(LabelImage& image) {
    DcmItem* const plane = group(0, DCM_PlaneOrientationSequence);
    DcmItem* const measures = group(0, DCM_PixelMeasuresSequence);
    if (!plane || !measures) throw damaged("orientation and pixel measures");
    const std::vector<double> axes = numbersOf(*plane, DCM_ImageOrientationPatient);
    const std::vector<double> pixel = numbersOf(*measures, DCM_PixelSpacing);
    if (axes.size() != 6 || pixel.size() != 2) throw damaged("orientation and pixel spacing");
    const Vec3 along(axes[0], axes[1], axes[2]), down(axes[3], axes[4], axes[5]);
    const Vec3 normal = along.cross(down);
    const auto depth = [&](const Frame& f) { return normal.dot(f.position); };
    const auto first = std::ranges::min_element(frames_, {}, depth);
    low_ = depth(*first);
    const std::vector<double> said = numbersOf(*measures, DCM_SpacingBetweenSlices);
    const std::vector<double> thick = numbersOf(*measures, DCM_SliceThickness);
    distance_ = distance(depth, said.empty() ? 0 : said[0], thick.empty() ? 1 : thick[0]);
    double high = low_;
    for (const Frame& f : frames_) high = std::max(high, depth(f));
    const double slices = std::round((high - low_) / distance_) + 1;
    if (!(slices >= 1 && slices <= 1e5)) throw damaged("sound positions");
    normal_ = normal;
    image.dims = {columns_, rows_, int(slices)};
    image.origin = 1e-3 * first->position;
    image.step.col(0) = 1e-3 * pixel[1] * along;
    image.step.col(1) = 1e-3 * pixel[0] * down;
    image.step.col(2) = 1e-3 * distance_ * normal;
  }

  // Between slices, mm. `said`: what the file says it is, 0 if it does not.
  template <typename Depth>
  double distance(const Depth& depth, double said, double thickness) const {
    constexpr double kSame = 1e-3;  // mm
    std::vector<double> depths;
    for (const Frame& f : frames_) depths.push_back(depth(f));
    std::ranges::sort(depths);
    double least = 0;
    for (std::size_t i = 1; i < depths.size(); ++i)
      if (const double d = depths[i] - depths[i - 1]; d > kSame && (least == 0 || d < least))
        least = d;
    if (least == 0) return said > 0 ? said : thickness;
    const auto fits = [&](double step) {
      return step > kSame && std::ranges::all_of(depths, [&](double d) {
               const double slices = (d - depths.front()) / step;
               return std::abs(slices - std::round(slices)) < 0.1;
             });
    };
    if (fits(said)) return said;
    if (fits(least)) return least;
    throw error("{}: its slices lie at uneven distances (from {:.3g} mm); resample it to even ones",
                path_, least);
  }

  // Puts the frames into the image.
  void fill(LabelImage& image) {
    const Uint8* pixels = nullptr;
    unsigned long count = 0;
    if (data_->findAndGetUint8Array(DCM_PixelData, pixels, &count).bad() || !pixels)
      throw error(
          "{}: its pixels are compressed or missing; export it uncompressed (dcmdrle, "
          "dcmdjpeg)",
          path_);
    Uint16 bits = 0, most = 255;
    data_->findAndGetUint16(DCM_BitsAllocated, bits);
    data_->findAndGetUint16(DCM_MaximumFractionalValue, most);
    if (bits != 1 && bits != 8) throw damaged("pixels of 1 or 8 bits");
    const std::size_t frameSize = std::size_t(rows_) * std::size_t(columns_);
    if (double(count) * 8 < double(frames_.size()) * double(frameSize) * bits)
      throw error("{}: ends early: it promises {} frames; copy or export it again", path_,
                  frames_.size());
    std::map<int, std::vector<std::uint32_t>> voxels;  // by segment
    for (std::size_t f = 0; f < frames_.size(); ++f) {
      const auto slice =
          std::size_t(std::llround((normal_.dot(frames_[f].position) - low_) / distance_));
      for (std::size_t i = 0; i < frameSize; ++i) {
        const std::size_t at = f * frameSize + i;
        const bool inside =
            bits == 1 ? pixels[at / 8] >> (at % 8) & 1 : 2 * pixels[at] >= most && pixels[at] > 0;
        if (inside) voxels[frames_[f].segment].push_back(std::uint32_t(slice * frameSize + i));
      }
    }
    if (voxels.size() > std::size_t(kMostLabels))
      throw error("{}: has more than {} segments; export fewer", path_, kMostLabels);
    const std::map<int, std::string> names = segmentNames();
    for (const auto& [segment, places] : voxels) {
      const auto name = names.find(segment);
      image.labels.push_back({segment, name == names.end() ? "" : name->second,
                              freeLayer(image, places), std::int64_t(places.size())});
      RawArray<std::uint16_t>& layer = image.layers[std::size_t(image.labels.back().layer)];
      for (const std::uint32_t place : places) layer[place] = std::uint16_t(image.labels.size());
    }
  }

  // A layer in which none of the places is taken.
  int freeLayer(LabelImage& image, const std::vector<std::uint32_t>& places) const {
    for (std::size_t l = 0; l < image.layers.size(); ++l)
      if (std::ranges::all_of(places,
                              [&](std::uint32_t place) { return image.layers[l][place] == 0; }))
        return int(l);
    if (int(image.layers.size()) == kMostLayers ||
        double(image.layers.size() + 1) * double(image.voxelCount()) > 2.0 * double(kMostVoxels))
      throw error("{}: too many of its segments overlap; export fewer", path_);
    image.layers.emplace_back().assign(std::size_t(image.voxelCount()), 0);
    return int(image.layers.size()) - 1;
  }

  std::map<int, std::string> segmentNames() {
    std::map<int, std::string> names;
    for (long i = 0; i < kMostLabels; ++i) {
      DcmItem* const segment = itemOf(data_, DCM_SegmentSequence, i);
      if (!segment) break;
      Uint16 number = 0;
      segment->findAndGetUint16(DCM_SegmentNumber, number);
      names[number] = textOf(*segment, DCM_SegmentLabel);
    }
    return names;
  }

  const std::string& path_;
  DcmFileFormat file_;
  DcmDataset* data_ = nullptr;
  int rows_ = 0, columns_ = 0;
  std::vector<Frame> frames_;
  Vec3 normal_ = Vec3::UnitZ();
  double low_ = 0, distance_ = 1;  // of the first slice along the normal, between slices; mm
};

}  // namespace

bool startsAsDicom(std::string_view bytes) {
  return bytes.size() > 132 && bytes.substr(128, 4) == "DICM";
}

bool startsAsSegmentation(std::string_view bytes) {
  return startsAsDicom(bytes) &&
         bytes.substr(0, kDicomHead).find(UID_SegmentationStorage) != bytes.npos;
}

void prepareDicom() {
  dcmDataDict.rdlock();
  dcmDataDict.rdunlock();
}

LabelImage readDicomFile(const std::string& path, std::string_view bytes) {
  return Segmentation(path, bytes).image();
}

}  // namespace resect
