#include "formats/meshes/three_mf_file.h"

#include <doctest/doctest.h>
#include <zlib.h>

#include "base/crc32.h"
#include "formats/meshes/cube_text.h"
#include "formats/meshes/number_bytes.h"
#include "formats/zip_entry.h"
#include "geometry/measures.h"
#include "geometry/topology.h"
#include "io/model.h"
#include "support/sentence.h"

using namespace resect;
using test::numberBytes;

namespace {

std::string deflated(const std::string& text) {
  std::string packed(compressBound(uLong(text.size())), '\0');
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = uInt(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = uInt(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

struct Entry {
  std::string name, content;
};

std::string zipOf(const std::vector<Entry>& entries, bool pack) {
  std::string bytes, central;
  for (const Entry& e : entries) {
    const std::string data = pack ? deflated(e.content) : e.content;
    const std::string common =
        numberBytes(20, 2) + numberBytes(0, 2) + numberBytes(pack ? 8 : 0, 2) + numberBytes(0, 4) +
        numberBytes(crc32({e.content.data(), e.content.size()}), 4) + numberBytes(data.size(), 4) +
        numberBytes(e.content.size(), 4) + numberBytes(e.name.size(), 2) + numberBytes(0, 2);
    central += "PK\1\2" + numberBytes(20, 2) + common + std::string(10, '\0') +
               numberBytes(bytes.size(), 4) + e.name;
    bytes += "PK\3\4" + common + e.name + data;
  }
  const std::size_t at = bytes.size();
  return bytes + central + "PK\5\6" + numberBytes(0, 4) + numberBytes(entries.size(), 2) +
         numberBytes(entries.size(), 2) + numberBytes(central.size(), 4) + numberBytes(at, 4) +
         numberBytes(0, 2);
}

std::string cubeObject(int id, const std::string& name) {
  std::string text =
      fmt::format("<object id=\"{}\" type=\"model\" name=\"{}\"><mesh><vertices>\n", id, name);
  for (const Vec3& p : test::cube().points)
    text += fmt::format("<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n", p.x(), p.y(), p.z());
  text += "</vertices><triangles>\n";
  for (const Triangle& t : test::kCubeTriangles)
    text += fmt::format("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n", t[0], t[1], t[2]);
  return text + "</triangles></mesh></object>\n";
}

constexpr const char* kCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";

// Two cubes of side 1, the second one twice as large and shifted by 10.
std::string cubesFile(const std::string& attributes, bool pack = true) {
  const std::string model = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- a model of cubes -->\n"
      "<model xml:lang=\"en-US\" {} xmlns=\"{}\"><resources>\n{}{}</resources><build>"
      "<item objectid=\"1\"/><item objectid=\"2\" transform=\"2 0 0 0 2 0 0 0 2 10 0 0\"/>"
      "</build></model>\n",
      attributes, kCore, cubeObject(1, "left kidney"), cubeObject(2, "right kidney"));
  return zipOf(
      {{"[Content_Types].xml",
        "<?xml version=\"1.0\"?><Types "
        "xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
        "<Default Extension=\"rels\" "
        "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
        "<Default Extension=\"model\" "
        "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>"},
       {"_rels/.rels",
        "<?xml version=\"1.0\"?><Relationships "
        "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
        "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
        "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
       {"3D/3dmodel.model", model}},
      pack);
}

Model readThreeMf(const std::string& bytes) { return readThreeMfFile("cubes.3mf", bytes); }

bool refusesFile(const std::string& bytes, const std::string& what) {
  return test::refuses([&] { readThreeMf(bytes); }, what);
}

}  // namespace

TEST_CASE("a file of 3MF gives its objects where they are built, in its unit") {
  struct Unit {
    const char* attribute;
    double metres;
  };
  for (const Unit& unit : {Unit{"", 1e-3}, Unit{"unit=\"millimeter\"", 1e-3},
                           Unit{"unit = 'inch'", 0.0254}, Unit{"unit=\"meter\"", 1}})
    for (const bool pack : {false, true}) {
      CAPTURE(unit.attribute);
      const std::string bytes = cubesFile(unit.attribute, pack);
      CHECK(isThreeMf(bytes));
      const Model model = readThreeMf(bytes);
      CHECK(model.format == "3MF");
      REQUIRE(model.parts.size() == 2);
      CHECK(model.parts[0].name == "left kidney");
      CHECK(model.parts[1].name == "right kidney");
      for (int i = 0; i < 2; ++i) {
        const TriangleMesh& mesh = model.parts[std::size_t(i)].mesh;
        const double side = (i + 1) * unit.metres;
        CHECK(volume(mesh) == doctest::Approx(side * side * side));
        CHECK((bounds(mesh).min - Vec3(i * 10 * unit.metres, 0, 0)).norm() < 1e-6 * unit.metres);
        CHECK(bounds(mesh).size().x() == doctest::Approx(side));
      }
    }
}

TEST_CASE("what a file of 3MF requires is followed or named") {
  const std::string materials =
      "requiredextensions=\"m\" "
      "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\"";
  CHECK(readThreeMf(cubesFile(materials)).parts.size() == 2);
  CHECK(refusesFile(
      cubesFile("requiredextensions=\"p\" "
                "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\""),
      "production/2015/06 of 3MF, which is not followed"));
  CHECK(refusesFile(cubesFile("unit=\"parsec\""), "its unit is \"parsec\""));
  CHECK(refusesFile(zipOf({{"a.txt", "no model"}}, true), "without a 3D model"));
  CHECK(refusesFile(zipOf({{"3D/3dmodel.model", "<mod>"}}, true), "no <model> element"));
  CHECK_FALSE(isThreeMf(zipOf({{"a.txt", "no model"}}, true)));
}

TEST_CASE("a damaged archive is refused with a sentence") {
  const std::string whole = cubesFile("unit=\"millimeter\"");
  for (std::size_t size = 0; size < whole.size(); size += 7)
    CHECK(refusesFile(whole.substr(0, size), "damaged or cut off"));
  std::string central = whole;
  central[whole.rfind("PK\1\2") + 42] = '\x7f';  // the place of an entry
  CHECK(refusesFile(central, "damaged"));
  CHECK(test::refuses([&] { zipEntry("a.zip", whole, ".model", 100); }, "unpacks to more than"));
  CHECK(zipEntry("a.zip", whole, "3D/3DMODEL.MODEL", 1 << 20)->starts_with("<?xml"));
}
