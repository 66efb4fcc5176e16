// DICOM segmentations, written here by DCMTK as segmentation programs write them.
#include "formats/images/dicom_file.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcdeftag.h>
#include <dcmtk/dcmdata/dcfilefo.h>
#include <dcmtk/dcmdata/dcitem.h>
#include <dcmtk/dcmdata/dcmetinf.h>
#include <dcmtk/dcmdata/dcuid.h>
#include <doctest/doctest.h>

#include "formats/labels/brought_organ.h"
#include "image_bytes.h"
#include "io/whole_file.h"
#include "support/sentence.h"
#include "support/temporary_folder.h"

using namespace resect;
using test::isOneSentence, test::sentenceOf, test::tells;
using test::PlainImage, test::TemporaryFolder, test::twoBoxes;

namespace {

struct SegForm {
  int bits = 1;
  bool said = true;       // with SpacingBetweenSlices
  double gap = 1;         // the last slice lies so many slices away
  bool reversed = false;  // frames from the last slice to the first
  std::string kind = UID_SegmentationStorage;
  bool counted = true;  // with NumberOfFrames
};

std::string decimal(double value) { return fmt::format("{:.10g}", value); }

std::string decimals(const Vec3& v) {
  return fmt::format("{:.10g}\\{:.10g}\\{:.10g}", v.x(), v.y(), v.z());
}

// Segment 1: label 200 of the image, in the slices where it is; segment 2: all voxels of slice 1.
std::string segBytes(const PlainImage& image, const SegForm& form = {}) {
  const int columns = image.dims.x(), rows = image.dims.y(), slices = image.dims.z();
  struct Frame {
    int segment, slice;
  };
  std::vector<Frame> frames;
  for (int z = 0; z < slices; ++z) frames.push_back({1, z});
  frames.push_back({2, 1});
  if (form.reversed) std::ranges::reverse(frames);
  DcmFileFormat file;
  DcmDataset& data = *file.getDataset();
  data.putAndInsertString(DCM_SOPClassUID, form.kind.c_str());
  data.putAndInsertString(DCM_SOPInstanceUID, "1.2.3.4");
  data.putAndInsertString(DCM_Modality, form.kind == UID_SegmentationStorage ? "SEG" : "CT");
  data.putAndInsertUint16(DCM_Rows, Uint16(rows));
  data.putAndInsertUint16(DCM_Columns, Uint16(columns));
  data.putAndInsertUint16(DCM_BitsAllocated, Uint16(form.bits));
  data.putAndInsertUint16(DCM_MaximumFractionalValue, 200);
  if (form.counted)
    data.putAndInsertString(DCM_NumberOfFrames, std::to_string(frames.size()).c_str());
  DcmItem* item = nullptr;
  const char* names[] = {"Liver", "Slab"};
  for (int s = 0; s < 2; ++s) {
    data.findOrCreateSequenceItem(DCM_SegmentSequence, item, -2);
    item->putAndInsertUint16(DCM_SegmentNumber, Uint16(s + 1));
    item->putAndInsertString(DCM_SegmentLabel, names[s]);
  }
  DcmItem *shared = nullptr, *inner = nullptr;
  const Vec3 spacing = image.step.colwise().norm();
  data.findOrCreateSequenceItem(DCM_SharedFunctionalGroupsSequence, shared);
  shared->findOrCreateSequenceItem(DCM_PlaneOrientationSequence, inner);
  inner->putAndInsertString(
      DCM_ImageOrientationPatient,
      (decimals(image.step.col(0) / spacing[0]) + "\\" + decimals(image.step.col(1) / spacing[1]))
          .c_str());
  shared->findOrCreateSequenceItem(DCM_PixelMeasuresSequence, inner);
  inner->putAndInsertString(DCM_PixelSpacing,
                            (decimal(spacing[1]) + "\\" + decimal(spacing[0])).c_str());
  inner->putAndInsertString(DCM_SliceThickness, "99");  // which is not their distance
  if (form.said) inner->putAndInsertString(DCM_SpacingBetweenSlices, decimal(spacing[2]).c_str());
  std::vector<bool> pixels;
  for (const Frame& frame : frames) {
    DcmItem* own = nullptr;
    data.findOrCreateSequenceItem(DCM_PerFrameFunctionalGroupsSequence, own, -2);
    own->findOrCreateSequenceItem(DCM_PlanePositionSequence, inner);
    const double slice = frame.slice == slices - 1 ? frame.slice - 1 + form.gap : frame.slice;
    inner->putAndInsertString(DCM_ImagePositionPatient,
                              decimals(image.origin + slice * image.step.col(2)).c_str());
    own->findOrCreateSequenceItem(DCM_SegmentIdentificationSequence, inner);
    inner->putAndInsertUint16(DCM_ReferencedSegmentNumber, Uint16(frame.segment));
    for (int i = 0; i < rows * columns; ++i)
      pixels.push_back(frame.segment == 2 ||
                       image.values[std::size_t(frame.slice * rows * columns + i)] == 200);
  }
  std::vector<Uint8> bytes(form.bits == 8 ? pixels.size() : (pixels.size() + 7) / 8);
  bytes.resize((bytes.size() + 1) / 2 * 2);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (form.bits == 8)
      bytes[i] = pixels[i] ? 100 : 99;  // of 200: a half, and less
    else if (pixels[i])
      bytes[i / 8] = Uint8(bytes[i / 8] | 1 << (i % 8));
  }
  data.putAndInsertUint8Array(DCM_PixelData, bytes.data(), (unsigned long)bytes.size());
  const TemporaryFolder folder;
  const auto path = folder / "seg.dcm";
  REQUIRE(file.saveFile(path.c_str(), EXS_LittleEndianExplicit).good());
  return readWholeFile(path);
}

void checkSameSegments(const LabelImage& image, const PlainImage& plain) {
  REQUIRE(image.dims == plain.dims);
  CHECK((image.origin - 1e-3 * plain.origin).norm() < 1e-9);
  CHECK((image.step - 1e-3 * plain.step).norm() < 1e-9);
  REQUIRE(image.labels.size() == 2);
  CHECK(image.labels[0].name == "Liver");
  CHECK(image.labels[1].name == "Slab");
  CHECK(image.labels[1].voxels == plain.dims.x() * plain.dims.y());
  CHECK(image.labels[1].layer == 1);  // it overlaps the other
  for (std::size_t i = 0; i < plain.values.size(); ++i)
    REQUIRE((image.layers[0][i] == 1) == (plain.values[i] == 200));
}

}  // namespace

TEST_CASE("a DICOM segmentation is read: overlapping segments, frames in any order, fractions") {
  const PlainImage plain = twoBoxes();
  for (const int bits : {1, 8})
    for (const bool said : {true, false})
      for (const bool reversed : {false, true})
        checkSameSegments(readDicomFile("a.dcm", segBytes(plain, {bits, said, 1, reversed})),
                          plain);
}

TEST_CASE("a DICOM segmentation that does not say how many frames it has is read as one") {
  const LabelImage image = readDicomFile("a.dcm", segBytes(twoBoxes(), {.counted = false}));
  CHECK(image.dims.z() == 1);
  CHECK(image.labels[0].name == "Liver");
}

TEST_CASE("DICOM files that are no segmentation, uneven slices and torn files are refused") {
  const PlainImage plain = twoBoxes();
  const auto refusal = [](const std::string& bytes) {
    return sentenceOf([&] { readDicomFile("a.dcm", bytes); });
  };
  SegForm scan;
  scan.kind = UID_CTImageStorage;
  CHECK(tells(refusal(segBytes(plain, scan)), "is a scan and not its labels"));
  SegForm uneven;
  uneven.gap = 1.5;
  CHECK(tells(refusal(segBytes(plain, uneven)), "uneven distances"));
  const std::string whole = segBytes(plain);
  CHECK(startsAsDicom(whole));
  for (std::size_t size = 100; size < whole.size(); size += 61)
    CHECK(isOneSentence(refusal(whole.substr(0, size))));
  SegForm skipped;  // a slice without frames between others
  skipped.gap = 2;
  CHECK(readDicomFile("a.dcm", segBytes(plain, skipped)).dims.z() == plain.dims.z() + 1);
}

TEST_CASE("of a study of DICOM, the segmentation is taken, in whatever folder it lies") {
  const TemporaryFolder study;
  SegForm scan;
  scan.kind = UID_CTImageStorage;
  std::filesystem::create_directories(study / "series 1");
  std::filesystem::create_directories(study / "series 2");
  for (const char* slice : {"series 1/IM0001", "series 1/IM0002", "slice.dcm"})
    study.write(slice, segBytes(twoBoxes(), scan));
  OrganSource source;
  source.file = study.path().string();
  CHECK(tells(sentenceOf([&] { takeLabels(source); }),
              "holds 3 DICOM files of a scan and no segmentation"));
  study.write("series 2/IM0001", segBytes(twoBoxes()));
  source = {};
  source.file = study.path().string();
  takeLabels(source);
  CHECK(source.file == (study / "series 2/IM0001").string());
  CHECK(source.part == "1");  // the liver
  REQUIRE_FALSE(source.notes.empty());
  CHECK(source.notes[0] == "left out: 3 DICOM files of a scan");
}
