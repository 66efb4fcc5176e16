#include "formats/meshes/gltf_file.h"

#include <doctest/doctest.h>

#include <cstring>

#include "formats/meshes/cube_text.h"
#include "formats/meshes/number_bytes.h"
#include "geometry/measures.h"
#include "geometry/topology.h"
#include "support/malformed/malformed.h"
#include "support/sentence.h"

using namespace resect;
using test::numberBytes;

namespace {

// What a cube's positions are stored as.
struct Form {
  int componentType;
  int one;          // the number that stands for 1
  bool normalized;  // whether `one` is a share
};

int sizeOf(const Form& form) { return form.componentType <= 5121 ? 1 : 2; }

std::string dataOf(const Form& form) {
  std::string data;
  for (const Vec3& p : test::cube().points) {
    for (int k = 0; k < 3; ++k) data += numberBytes(p[k] == 1 ? form.one : 0, sizeOf(form));
    data += numberBytes(0, sizeOf(form));  // each starts at a multiple of four bytes
  }
  for (const Triangle& t : test::kCubeTriangles)
    for (const std::int32_t i : t) data += numberBytes(i, 2);
  return data;
}

std::string jsonOf(const Form& form, const std::string& buffer, const std::string& required,
                   double scale) {
  const int stride = 4 * sizeOf(form), points = 8 * stride;
  return fmt::format(
      R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],)"
      R"("nodes":[{{"mesh":0,"scale":[{0},{0},{0}],"name":"left kidney"}}],)"
      R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"NORMAL":0}},"indices":1}}]}}],)"
      R"("accessors":[{{"bufferView":0,"componentType":{1},"normalized":{2},"count":8,"type":"VEC3",)"
      R"("min":[0,0,0],"max":[{3},{3},{3}]}},)"
      R"({{"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}}],)"
      R"("bufferViews":[{{"buffer":0,"byteLength":{4},"byteStride":{5}}},)"
      R"({{"buffer":0,"byteOffset":{4},"byteLength":72}}],)"
      R"("buffers":[{{{6}"byteLength":{7}}}],"extensionsUsed":[{8}],"extensionsRequired":[{8}]}})",
      scale, form.componentType, form.normalized, form.one, points, stride, buffer, points + 72,
      required);
}

constexpr const char* kQuantized = R"("KHR_mesh_quantization")";

void checkGltfCube(const Model& model) {
  REQUIRE(model.parts.size() == 1);
  CHECK(model.parts[0].name == "left kidney");
  CHECK(topology(model.parts[0].mesh).closed());
  CHECK(volume(model.parts[0].mesh) == doctest::Approx(1).epsilon(1e-5));
}

std::string sentenceOfGltf(const std::string& bytes) {
  return test::sentenceOf([&] { readGltfFile("a.glb", bytes); });
}

}  // namespace

TEST_CASE("quantized positions of every kind are read") {
  for (const Form& form : {Form{5120, 100, false}, Form{5121, 200, false}, Form{5122, 16383, false},
                           Form{5123, 60000, false}, Form{5120, -100, false}}) {
    CAPTURE(form.componentType);
    const double scale = 1.0 / std::abs(form.one);
    Model model =
        readGltfFile("a.glb", test::binaryGltf(jsonOf(form, "", kQuantized, scale), dataOf(form)));
    if (form.one < 0) flip(model.parts.at(0).mesh);  // mirrored by the numbers themselves
    checkGltfCube(model);
  }
  for (const Form& form : {Form{5120, 127, true}, Form{5121, 255, true}, Form{5122, 32767, true},
                           Form{5123, 65535, true}}) {
    CAPTURE(form.componentType);
    checkGltfCube(
        readGltfFile("a.glb", test::binaryGltf(jsonOf(form, "", kQuantized, 1), dataOf(form))));
  }
  // The smallest number is no less than -1.
  const Form least{5120, -128, true};
  Model model =
      readGltfFile("a.glb", test::binaryGltf(jsonOf(least, "", kQuantized, 1), dataOf(least)));
  flip(model.parts.at(0).mesh);
  checkGltfCube(model);
}

TEST_CASE("quantized positions are read from a file beside the model and from its text") {
  const Form form{5123, 65535, true};
  const std::string data = dataOf(form);
  BesideFiles beside;
  const std::string json = jsonOf(form, R"("uri":"my%20cube.bin",)", kQuantized, 1);
  std::string lacking;
  try {
    readGltfFile("a.gltf", json);
  } catch (const LacksFile& file) {
    lacking = file.name;
  }
  CHECK(lacking == "my cube.bin");
  RawArray<char> file;
  file.resize(data.size());
  std::memcpy(file.data(), data.data(), data.size());
  beside.emplace("my cube.bin", std::move(file));
  checkGltfCube(readGltfFile("a.gltf", json, beside));

  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  REQUIRE(data.size() % 3 == 1);
  for (std::size_t i = 0; i < data.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < data.size() ? std::uint8_t(data[i + k]) : 0u);
    for (int shift = 18; shift >= 0; shift -= 6) text += kDigits[three >> shift & 63];
  }
  text.replace(text.size() - 2, 2, "==");
  checkGltfCube(readGltfFile(
      "a.gltf", jsonOf(form, R"("uri":"data:application/octet-stream;base64,)" + text + "\",",
                       kQuantized, 1)));
}

TEST_CASE("a .gltf is read with a byte order mark and a padded end") {
  const Form form{5123, 65535, true};
  BesideFiles beside;
  const std::string data = dataOf(form);
  RawArray<char> file;
  file.resize(data.size());
  std::memcpy(file.data(), data.data(), data.size());
  beside.emplace("cube.bin", std::move(file));
  const std::string json = jsonOf(form, R"("uri":"cube.bin",)", kQuantized, 1);
  checkGltfCube(
      readGltfFile("a.gltf", "\xef\xbb\xbf\r\n" + json + std::string("\n\0\x1a", 3), beside));
}

TEST_CASE("a .glb is read with bytes after its end") {
  const Form form{5123, 65535, true};
  checkGltfCube(readGltfFile(
      "a.glb",
      test::binaryGltf(jsonOf(form, "", kQuantized, 1), dataOf(form)) + std::string(10, 'x')));
}

TEST_CASE("an extension that a file requires is followed or named") {
  const Form form{5123, 65535, true};
  const auto with = [&](const std::string& required) {
    return test::binaryGltf(jsonOf(form, "", required, 1), dataOf(form));
  };
  for (const char* other : {"EXT_meshopt_compression", "KHR_draco_mesh_compression",
                            "EXT_mesh_gpu_instancing", "ACME_warp"}) {
    CHECK(test::isRefusalOf("a.glb: ", std::string("requires the glTF extension ") + other,
                            sentenceOfGltf(with(fmt::format("\"{}\",{}", other, kQuantized)))));
  }
  // What only changes looks does no harm.
  checkGltfCube(
      readGltfFile("a.glb", with(fmt::format(R"("KHR_materials_unlit",{})", kQuantized))));
}

TEST_CASE("damaged quantized files and torn text are refused") {
  const Form form{5123, 65535, true};
  const std::string json = jsonOf(form, "", kQuantized, 1), data = dataOf(form);
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = json;
    other.replace(other.find(from), from.size(), to);
    return sentenceOfGltf(test::binaryGltf(other, data));
  };
  CHECK(test::tells(changed(R"("count":8)", R"("count":900)"), "beyond the end of their buffer"));
  CHECK(test::tells(changed(R"("byteStride":8)", R"("byteStride":2)"), "beyond the end"));
  CHECK(test::tells(changed(R"("count":8)", R"("count":-8)"), "beyond the end"));
  CHECK(test::tells(changed(R"("type":"VEC3")", R"("type":"VEC2")"), "unknown form"));
  CHECK(test::tells(changed(R"("bufferView":0)", R"("bufferView":7)"), "not that of a glTF"));
  CHECK(test::tells(changed(R"({"POSITION":0)", R"({"POSITION":7)"), "not that of a glTF"));
  CHECK(test::tells(changed(R"("asset")", R"(asset)"), "damaged at byte"));
  CHECK(test::tells(changed(R"("count":8)", R"("count":1e999)"), "not that of a glTF"));
  for (std::size_t length = 1; length < json.size(); length += 29)
    CHECK(test::tells(test::sentenceOf([&] { readGltfFile("a.gltf", json.substr(0, length)); }),
                      "the file ends early"));
}
