// Label images in every form in which programs write them: the same labels at the same places.
#include <doctest/doctest.h>

#include <map>

#include "formats/images/meta_image_file.h"
#include "formats/images/nifti_file.h"
#include "formats/images/nrrd_file.h"
#include "formats/labels/label_file.h"
#include "formats/labels/label_model.h"
#include "image_bytes.h"
#include "support/sentence.h"

using namespace resect;
using test::isOneSentence, test::sentenceOf, test::tells;
using test::niftiBytes, test::nrrdBytes, test::metaBytes;
using test::NiftiForm, test::NrrdForm, test::PlainImage;
using test::packed, test::textOf, test::twoBoxes, test::voxels;

namespace {

// accuracy: of places, m.
void checkSameLabels(const LabelImage& image, const PlainImage& plain, double accuracy = 1e-9) {
  REQUIRE(image.dims == plain.dims);
  CHECK((image.origin - 1e-3 * plain.origin).norm() < accuracy);
  CHECK((image.step - 1e-3 * plain.step).norm() < accuracy);
  REQUIRE(image.labels.size() == 2);
  CHECK(image.labels[0].value == 3);
  CHECK(image.labels[1].value == 200);
  CHECK(image.labels[0].voxels == 3 * 3);
  CHECK(image.labels[1].voxels == 3 * 2 * 4);
  for (std::size_t i = 0; i < plain.values.size(); ++i) {
    const std::uint16_t label = image.layers[0][i];
    REQUIRE((label == 0 ? 0 : double(image.labels[label - 1u].value)) == plain.values[i]);
  }
}

// The types that hold 200.
constexpr VoxelType kTypes[] = {VoxelType::U8,  VoxelType::U16, VoxelType::I16,
                                VoxelType::U32, VoxelType::I32, VoxelType::U64,
                                VoxelType::I64, VoxelType::F32, VoxelType::F64};

BesideFiles file(const std::string& name, const std::string& bytes) {
  BesideFiles files;
  files[name].assign(bytes.begin(), bytes.end());
  return files;
}

std::string lacking(const std::function<void()>& read) {
  try {
    read();
  } catch (const LacksFile& lacks) {
    return lacks.name;
  }
  return "";
}

}  // namespace

TEST_CASE("a NIfTI image of any version, type and order of bytes is read") {
  const PlainImage plain = twoBoxes();
  for (const int version : {1, 2})
    for (const VoxelType type : kTypes)
      for (const bool big : {false, true}) {
        NiftiForm form;
        form.version = version, form.type = type, form.big = big;
        const LabelImage image = readNiftiFile("a.nii", niftiBytes(plain, form));
        checkSameLabels(image, plain, version == 1 ? 1e-7 : 1e-9);  // single precision
        CHECK(image.format == (version == 1 ? "NIfTI-1" : "NIfTI-2"));
      }
  NiftiForm scaled;
  scaled.slope = 0.5f;
  PlainImage doubled = plain;
  for (double& value : doubled.values) value = 0.5 * value;
  NiftiForm wide = scaled;
  wide.slope = 2, wide.type = VoxelType::F32;
  checkSameLabels(readNiftiFile("a.nii", niftiBytes(doubled, wide)), plain, 1e-7);
  NiftiForm pair;
  pair.pair = true;
  const std::string header = niftiBytes(plain, pair);
  CHECK(lacking([&] { readNiftiFile("/x/a.hdr", header); }) == "a.img");
  CHECK(lacking([&] { readNiftiFile("/x/a.hdr.gz", header); }) == "a.img.gz");
  const std::string data = voxels(plain, VoxelType::U8, false);
  checkSameLabels(readNiftiFile("/x/a.hdr", header, file("a.img", data)), plain, 1e-7);
  checkSameLabels(readNiftiFile("/x/a.hdr.gz", header, file("a.img.gz", packed(data, true))), plain,
                  1e-7);
}

TEST_CASE("a NIfTI image placed by a quaternion is placed as one placed by rows") {
  PlainImage plain = twoBoxes();
  for (const bool mirrored : {false, true}) {
    if (mirrored) plain.step.col(2) *= -1;
    const Vec3 spacing = plain.step.colwise().norm();
    Mat3 turn;  // right-anterior-superior
    for (int a = 0; a < 3; ++a) turn.col(a) = turnedRasLps(plain.step.col(a) / spacing[a]);
    const float sign = turn.determinant() < 0 ? -1.0f : 1.0f;
    turn.col(2) *= double(sign);
    Eigen::Quaterniond q(turn);
    if (q.w() < 0) q.coeffs() *= -1;
    std::string bytes = niftiBytes(plain);
    const auto set = [&](std::size_t at, auto value) {
      std::memcpy(bytes.data() + at, &value, sizeof(value));
    };
    set(76, sign), set(252, std::int16_t(1)), set(254, std::int16_t(0));
    const Vec3 offset = turnedRasLps(plain.origin);
    set(256, float(q.x())), set(260, float(q.y())), set(264, float(q.z()));
    for (int a = 0; a < 3; ++a) set(268 + 4 * std::size_t(a), float(offset[a]));
    std::memset(bytes.data() + 280, 0, 48);
    checkSameLabels(readNiftiFile("a.nii", bytes), plain, 1e-7);
  }
}

TEST_CASE("names of labels are read from a table in a NIfTI header") {
  NiftiForm form;
  form.names =
      "<?xml version=\"1.0\"?><CaretExtension><VolumeInformation><LabelTable>"
      "<Label Key=\"3\" Red=\"1\"><![CDATA[liver]]></Label>\n"
      "<Label Key=\"200\" Red=\"0\">spleen</Label></LabelTable></VolumeInformation>";
  for (const int version : {1, 2}) {
    form.version = version;
    const LabelImage image = readNiftiFile("a.nii", niftiBytes(twoBoxes(), form));
    CHECK(image.labels[0].name == "liver");
    CHECK(image.labels[1].name == "spleen");
  }
}

TEST_CASE("an NRRD image of any type, encoding and space is read") {
  const PlainImage plain = twoBoxes();
  const std::map<std::string, VoxelType> types{
      {"uchar", VoxelType::U8},   {"uint8_t", VoxelType::U8},       {"short", VoxelType::I16},
      {"ushort", VoxelType::U16}, {"unsigned int", VoxelType::U32}, {"int", VoxelType::I32},
      {"float", VoxelType::F32},  {"double", VoxelType::F64}};
  for (const auto& [name, type] : types)
    for (const std::string encoding : {"raw", "gzip", "ascii"})
      for (const std::string space : {"left-posterior-superior", "right-anterior-superior"})
        for (const bool big : {false, true}) {
          if (encoding == "ascii" && big) continue;
          NrrdForm form{name, type, big, encoding, space, "", ""};
          checkSameLabels(readNrrdFile("a.nrrd", nrrdBytes(plain, form)), plain);
        }
  NrrdForm apart;
  apart.dataFile = "a.raw";
  const std::string header = nrrdBytes(plain, apart);
  CHECK(lacking([&] { readNrrdFile("a.nhdr", header); }) == "a.raw");
  checkSameLabels(
      readNrrdFile("a.nhdr", header, file("a.raw", voxels(plain, VoxelType::U8, false))), plain);
  apart.more = "byte skip: 5\n";
  checkSameLabels(readNrrdFile("a.nhdr", nrrdBytes(plain, apart),
                               file("a.raw", "12345" + voxels(plain, VoxelType::U8, false))),
                  plain);
}

TEST_CASE("segments of 3D Slicer have their names, also where they overlap") {
  const PlainImage plain = twoBoxes();
  NrrdForm form;
  form.more =
      "Segment0_Name:=Liver\nSegment0_LabelValue:=3\nSegment0_Layer:=0\n"
      "Segment1_Name:=Big vessel\nSegment1_LabelValue:=200\n";
  const LabelImage one = readNrrdFile("a.seg.nrrd", nrrdBytes(plain, form));
  CHECK(one.labels[0].name == "Liver");
  CHECK(one.labels[1].name == "Big vessel");

  // Two layers, the axis of layers first: the second holds one label over all voxels.
  std::string bytes = "NRRD0004\ntype: uchar\ndimension: 4\nspace: left-posterior-superior\n";
  bytes += fmt::format("sizes: 2 {} {} {}\n", plain.dims.x(), plain.dims.y(), plain.dims.z());
  bytes += fmt::format("space directions: none {} {} {}\n", textOf(plain.step.col(0)),
                       textOf(plain.step.col(1)), textOf(plain.step.col(2)));
  bytes += "kinds: list domain domain domain\nencoding: raw\n";
  bytes += "Segment0_Name:=Liver\nSegment0_LabelValue:=3\nSegment0_Layer:=0\n";
  bytes += "Segment1_Name:=Body\nSegment1_LabelValue:=3\nSegment1_Layer:=1\n\n";
  for (const double value : plain.values) bytes += char(value), bytes += char(3);
  const LabelImage two = readNrrdFile("a.seg.nrrd", bytes);
  REQUIRE(two.layers.size() == 2);
  REQUIRE(two.labels.size() == 3);
  CHECK(two.labels[0].name == "Liver");
  CHECK(two.labels[2].name == "Body");
  CHECK(two.labels[2].voxels == two.voxelCount());
  CHECK(two.labels[0].voxels == 9);
}

TEST_CASE("a MetaImage of any type and form is read") {
  const PlainImage plain = twoBoxes();
  const std::map<std::string, VoxelType> types{
      {"MET_UCHAR", VoxelType::U8}, {"MET_SHORT", VoxelType::I16}, {"MET_USHORT", VoxelType::U16},
      {"MET_UINT", VoxelType::U32}, {"MET_FLOAT", VoxelType::F32}, {"MET_DOUBLE", VoxelType::F64}};
  for (const auto& [name, type] : types)
    for (const bool big : {false, true})
      for (const bool compressed : {false, true})
        checkSameLabels(readMetaImageFile("a.mha", metaBytes(plain, {name, type, big, compressed,
                                                                     false, "LOCAL"})),
                        plain);
  checkSameLabels(readMetaImageFile("a.mha", metaBytes(plain, {"MET_SHORT", VoxelType::I16, false,
                                                               false, true, "LOCAL"})),
                  plain);
  const std::string header =
      metaBytes(plain, {"MET_UCHAR", VoxelType::U8, false, false, false, "a.zraw"});
  CHECK(lacking([&] { readMetaImageFile("a.mhd", header); }) == "a.zraw");
  checkSameLabels(
      readMetaImageFile("a.mhd", header, file("a.zraw", voxels(plain, VoxelType::U8, false))),
      plain);
}

TEST_CASE("scans, torn files and files elsewhere are refused with a sentence") {
  PlainImage plain = twoBoxes();
  const std::string nii = niftiBytes(plain), nrrd = nrrdBytes(plain), mha = metaBytes(plain);
  for (const std::size_t lost : {1, 50, 139}) {
    CHECK(tells(sentenceOf([&] { readNiftiFile("a.nii", nii.substr(0, nii.size() - lost)); }),
                "ends early"));
    CHECK(tells(sentenceOf([&] { readNrrdFile("a.nrrd", nrrd.substr(0, nrrd.size() - lost)); }),
                "ends early"));
    CHECK(tells(sentenceOf([&] { readMetaImageFile("a.mha", mha.substr(0, mha.size() - lost)); }),
                "ends early"));
  }
  for (std::size_t size = 0; size < 352; size += 7) {
    CHECK(isOneSentence(sentenceOf([&] { readNiftiFile("a.nii", nii.substr(0, size)); })));
    CHECK(isOneSentence(sentenceOf([&] { readNrrdFile("a.nrrd", nrrd.substr(0, size)); })));
    CHECK(isOneSentence(sentenceOf([&] { readMetaImageFile("a.mha", mha.substr(0, size)); })));
  }
  NiftiForm floats;
  floats.type = VoxelType::F32;
  PlainImage scan = plain;
  scan.values[7] = 0.25;
  CHECK(tells(sentenceOf([&] { readNiftiFile("a.nii", niftiBytes(scan, floats)); }),
              "is a scan and not its labels: it has values such as 0.25"));
  scan.values[7] = -1000;
  CHECK(tells(sentenceOf([&] { readNiftiFile("a.nii", niftiBytes(scan, floats)); }), "below 0"));
  for (std::size_t i = 0; i < scan.values.size(); ++i) scan.values[i] = double(1 + i * 37 % 101);
  CHECK(tells(sentenceOf([&] { readNiftiFile("a.nii", niftiBytes(scan)); }),
              "neighbours mostly differ"));
  for (const char* elsewhere : {"/etc/passwd", "../a.txt", "LIST"}) {
    NrrdForm form;
    form.dataFile = elsewhere;
    CHECK(tells(sentenceOf([&] { readNrrdFile("a.nhdr", nrrdBytes(plain, form)); }),
                "save it as one file"));
  }
  plain.step.col(2) = plain.step.col(1);
  CHECK(tells(sentenceOf([&] { readNrrdFile("a.nrrd", nrrdBytes(plain)); }), "make no image"));
}

TEST_CASE("labels are found by name, by number, and by TotalSegmentator's names") {
  const PlainImage plain = twoBoxes();
  LabelImage image = readNrrdFile("a.nrrd", nrrdBytes(plain));
  CHECK(labelNamed("a", image, "200") == 1);
  CHECK(labelNamed("a", image, "label 3") == 0);
  CHECK(labelNamed("a", image, "kidney_left") == 0);
  CHECK(labelNamed("a", image, "Kidney left") == 0);
  CHECK(tells(sentenceOf([&] { labelNamed("a", image, "liver"); }), "it has: 3, 200"));
  image.labels[0].name = "Liver";
  CHECK(labelNamed("a", image, "liver") == 0);
  CHECK(tells(sentenceOf([&] { labelNamed("a", image, "kidney_left"); }), "it has: 3 Liver, 200"));
  const Model model = labelModel("x/y/spleen.nii.gz", image, "");
  REQUIRE(model.parts.size() == 2);
  CHECK(model.parts[0].name == "Liver");
  CHECK(model.parts[1].name == "label 200");
  const Model both = labelModel("x", image, "liver\n200");
  REQUIRE(both.parts.size() == 1);
  CHECK(chosenParts(both, "liver\n200").parts.size() == 1);
}

TEST_CASE("many labels without names get those of TotalSegmentator, few do not") {
  LabelImage image;
  image.dims = {30, 1, 1};
  image.step = 0.001 * Mat3::Identity();
  image.layers.emplace_back();
  for (int i = 0; i < 30; ++i) {
    image.layers[0].push_back(std::uint16_t(i < 21 ? i + 1 : 0));
    if (i < 21) image.labels.push_back({i + 1, "", 0, 1});
  }
  LabelFacts facts = factsOf("x", image);
  CHECK(facts.guessed);
  CHECK(facts.labels[4].name == "liver");
  CHECK(facts.cutOff[0]);
  // An atlas has numbers beyond those.
  image.labels.back().value = 200;
  CHECK_FALSE(factsOf("x", image).guessed);
  image.labels.pop_back();
  facts = factsOf("x", image);
  CHECK_FALSE(facts.guessed);
  CHECK(facts.labels[4].name.empty());
}

TEST_CASE("orientation is told by letters and degrees") {
  LabelImage image;
  image.step = Vec3(-0.001, -0.001, 0.002).asDiagonal();
  CHECK(orientation(image) == "RAS");
  CHECK(obliqueness(image) < 1e-6);
  image.step.col(0) = 0.001 * Vec3(0, std::cos(0.2), std::sin(0.2));
  image.step.col(1) = 0.001 * Vec3(1, 0, 0);
  CHECK(orientation(image) == "PLS");
  CHECK(obliqueness(image) == doctest::Approx(0.2 * 180 / 3.14159265).epsilon(1e-6));
}
