#include <fmt/format.h>

#include <bit>

#include "support/malformed/malformed.h"

namespace resect::test {
namespace {

const std::string kHead = "#Inventor V2.1 ascii\n";
const std::string kVrml97 = "#VRML V2.0 utf8\n";
const std::string kPoints =
    "Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0, 0 0 1, 1 0 1, 1 1 1, 0 1 1 ] }\n";
const std::string kFaces =
    "IndexedFaceSet { coordIndex [ 0,3,2,1,-1, 4,5,6,7,-1, 0,1,5,4,-1, 1,2,6,5,-1, 2,3,7,6,-1, "
    "3,0,4,7,-1 ] }\n";

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

// Writer of Inventor's binary form: 32-bit big-endian numbers, strings padded to four bytes.
class BinaryInventor {
 public:
  BinaryInventor& number(std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes_ += char(value >> shift & 255);
    return *this;
  }
  BinaryInventor& real(float value) { return number(std::bit_cast<std::uint32_t>(value)); }
  BinaryInventor& text(const std::string& value) {
    number(std::uint32_t(value.size()));
    bytes_ += value;
    bytes_.append((4 - value.size() % 4) % 4, '\0');
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_ = "#Inventor V2.1 binary  \n";
};

void addTextForms(std::vector<BadFile>& files) {
  const auto add = [&](const std::string& name, const std::string& bytes, bool mayBeFine = false) {
    files.push_back({name, bytes, mayBeFine});
  };
  const std::string whole = kHead + "Separator {\n" + kPoints + kFaces + "}\n";
  add("empty.iv", "");
  add("blank.iv", " \n\n\t \n");
  add("header_only.iv", kHead);
  add("no_header.iv", "Separator { Cube { } }\n");
  add("misspelt_header.iv", "#Inventer V2.1 ascii\nCube { }\n");
  add("future_version.iv", "#Inventor V9.9 ascii\nCube { }\n", true);
  add("unknown_encoding.iv", "#Inventor V2.1 morse\nCube { }\n", true);
  add("binary_header_on_text.iv", "#Inventor V2.1 binary\nSeparator { Cube { } }\n");
  for (const int percent : {10, 30, 50, 70, 90})
    add(fmt::format("cut_at_{}_percent.iv", percent),
        whole.substr(0, whole.size() * std::size_t(percent) / 100));
  add("nested_100000_deep.iv", kHead + repeated("Separator {\n", 100'000));
  add("nested_and_closed.iv", kHead + repeated("Group {", 100'000) + repeated("}", 100'000));
  add("brackets_100000_deep.iv", kHead + "Coordinate3 { point " + repeated("[", 100'000));
  add("word_of_a_million.iv", kHead + std::string(1'000'000, 'x'));
  add("number_of_a_million_digits.iv",
      kHead + "Cube { width " + std::string(1'000'000, '1') + " }");
  add("name_of_1000.iv", kHead + "DEF " + std::string(1000, 'n') + " Cube { }");
  add("string_without_end.iv", kHead + "Info { string \"never closed }");
  add("unknown_node.iv", kHead + "Separator { Frobnicator { size 3 } }");
  add("unknown_field.iv", kHead + "Separator { Cube { girth 3 } }");
  add("library_named_node.iv", kHead + "libc { x 1 }");
  add("word_for_number.iv", kHead + "Cube { width wide }");
  add("nan_coordinates.iv", kHead + "Coordinate3 { point [ 0 0 0, nan nan nan, 0 1 0 ] }" +
                                "IndexedFaceSet { coordIndex [ 0,1,2 ] }");
  add("infinite_coordinates.iv", kHead + "Coordinate3 { point [ 0 0 0, 1e999 0 0, 0 1 0 ] }" +
                                     "IndexedFaceSet { coordIndex [ 0,1,2 ] }");
  add("far_coordinates.iv", kHead + "Coordinate3 { point [ 0 0 0, 1e38 0 0, 0 1e30 0 ] }" +
                                "IndexedFaceSet { coordIndex [ 0,1,2 ] }");
  add("overflowing_transform.iv",
      kHead + "Scale { scaleFactor 1e30 1e30 1e30 } Scale { scaleFactor 1e30 1e30 1e30 } Cube { }");
  add("missing_comma_in_point.iv", kHead + "Coordinate3 { point [ 0 0 0, 1 0 ] }" + kFaces);
  add("face_index_beyond.iv", kHead + kPoints + "IndexedFaceSet { coordIndex [ 0,1,8,-1 ] }");
  add("face_index_huge.iv",
      kHead + kPoints + "IndexedFaceSet { coordIndex [ 0,1,2147483647,-1 ] }");
  add("face_index_overflow.iv",
      kHead + kPoints + "IndexedFaceSet { coordIndex [ 0,1,99999999999999,-1 ] }", true);
  add("faces_without_points.iv", kHead + "IndexedFaceSet { coordIndex [ 0,1,2,-1 ] }", true);
  add("strip_index_beyond.iv",
      kHead + kPoints + "IndexedTriangleStripSet { coordIndex [ 0,1,2,3,4,5,600 ] }");
  add("strip_too_long.iv", kHead + kPoints + "TriangleStripSet { numVertices [ 4, 400000 ] }");
  add("strip_of_minus_seven.iv", kHead + kPoints + "TriangleStripSet { numVertices [ 4, -7 ] }");
  add("strip_rest_twice.iv", kHead + kPoints + "TriangleStripSet { numVertices [ -1, -1 ] }", true);
  add("strip_starts_beyond.iv",
      kHead + kPoints + "TriangleStripSet { startIndex 100 numVertices 3 }");
  add("strip_starts_before.iv",
      kHead + kPoints + "TriangleStripSet { startIndex -5 numVertices 3 }");
  add("face_set_too_long.iv",
      kHead + kPoints + "FaceSet { numVertices [ 2147483647, 2147483647 ] }");
  add("quad_mesh_huge.iv",
      kHead + kPoints + "QuadMesh { verticesPerRow 100000 verticesPerColumn 100000 }");
  add("quad_mesh_negative.iv",
      kHead + kPoints + "QuadMesh { verticesPerRow -4 verticesPerColumn -4 }");
  add("array_huge.iv", kHead + "Array { numElements1 30000 numElements2 30000 Cube { } }");
  add("array_nested.iv",
      kHead + repeated("Array { numElements1 100 ", 5) + "Cube { }" + repeated("}", 5));
  add("copies_huge.iv", kHead + "MultipleCopy { matrix [ " +
                            repeated("1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1,\n", 10'001) +
                            "] Cube { } }");
  add("normal_index_beyond.iv",
      kHead + kPoints +
          "Normal { vector 0 0 1 } IndexedFaceSet { coordIndex [ 0,1,2,-1 ] normalIndex [ "
          "500,501,502 ] }",
      true);
  add("material_index_beyond.iv",
      kHead + kPoints +
          "MaterialBinding { value PER_VERTEX_INDEXED } IndexedFaceSet { coordIndex [ 0,1,2,-1 ] "
          "materialIndex [ 500,501,502 ] }",
      true);
  add("texture_index_beyond.iv",
      kHead + kPoints +
          "Texture2 { image 1 1 1 0xff } TextureCoordinate2 { point 0 0 } IndexedFaceSet { "
          "coordIndex [ 0,1,2,-1 ] textureCoordIndex [ 77,78,79 ] }",
      true);
  add("texture_of_everything.iv", kHead + "Texture2 { filename \"/dev/zero\" } Cube { }", true);
  add("texture_image_huge.iv", kHead + "Texture2 { image 100000 100000 4 0x1 } Cube { }");
  add("nurbs_few_points.iv", kHead + kPoints +
                                 "NurbsSurface { numUControlPoints 40 numVControlPoints 40 "
                                 "uKnotVector [ 0,0,1,1 ] vKnotVector [ 0,0,1,1 ] }");
  add("nurbs_no_knots.iv",
      kHead + kPoints + "NurbsSurface { numUControlPoints 2 numVControlPoints 2 }");
  add("nurbs_falling_knots.iv", kHead + kPoints +
                                    "NurbsSurface { numUControlPoints 2 numVControlPoints 2 "
                                    "uKnotVector [ 3,2,1,0 ] vKnotVector [ 0,0,1,1 ] }");
  add("nurbs_nan_knots.iv", kHead + kPoints +
                                "NurbsSurface { numUControlPoints 2 numVControlPoints 2 "
                                "uKnotVector [ 0,0,1e999,1e999 ] vKnotVector [ 0,0,1,1 ] }");
  add("nurbs_index_beyond.iv",
      kHead + kPoints +
          "IndexedNurbsSurface { numUControlPoints 2 numVControlPoints 2 coordIndex [ 0,1,2,3000 ] "
          "uKnotVector [ 0,0,1,1 ] vKnotVector [ 0,0,1,1 ] }");
  add("nurbs_profile_beyond.iv",
      kHead + kPoints +
          "ProfileCoordinate2 { point [ 0 0, 1 0 ] } NurbsProfile { index [ 0,1,500 ] knotVector [ "
          "0,0,0,1,1,1 ] } NurbsSurface { numUControlPoints 2 numVControlPoints 2 uKnotVector [ "
          "0,0,1,1 ] vKnotVector [ 0,0,1,1 ] }");
  add("use_of_nothing.iv", kHead + "Separator { USE nobody }");
  add("use_inside_itself.iv", kHead + "DEF me Separator { USE me }");
  add("use_deep_inside_itself.iv", kHead + "DEF me Separator { Group { Switch { USE me } } }");
  std::string doubling = kHead + "DEF g0 Separator { Cube { } }\n";
  for (int i = 0; i < 40; ++i)
    doubling += fmt::format("DEF g{} Separator {{ USE g{} USE g{} }}\n", i + 1, i, i);
  add("doubling_40_times.iv", doubling);
  add("file_of_itself.iv", kHead + "File { name \"file_of_itself.iv\" }");
  add("file_of_a_device.iv", kHead + "Separator { File { name \"/dev/stdin\" } }");
  add("inline_of_itself.wrl", kVrml97 + "Inline { url \"inline_of_itself.wrl\" }");
  add("www_inline.iv", kHead + "WWWInline { name \"http://localhost/x.iv\" }");
  add("lines_only.iv", kHead + kPoints + "IndexedLineSet { coordIndex [ 0,1,2,-1 ] }");
  add("points_only.iv", kHead + kPoints + "PointSet { numPoints 900 }");
  add("switched_off.iv", kHead + "Switch { whichChild -1 Cube { } }");
  add("switch_beyond.iv", kHead + "Switch { whichChild 70000 Cube { } }");
  add("lone_bracket.iv", kHead + "}");
  add("crossed_brackets.iv", kHead + "Separator { Coordinate3 { point [ 0 0 0 } ] }");
  add("null_bytes.iv", kHead + std::string("Sep\0arator { \0\0 }", 17));
  add("engine_to_nowhere.iv", kHead + "Cube { width = Calculator { expression \"oa=\" }.oa }",
      true);
  add("field_loop.iv", kHead + "DEF a Cube { width = USE a.height height = USE a.width }", true);
}

void addVrmlForms(std::vector<BadFile>& files) {
  const auto add = [&](const std::string& name, const std::string& body, bool mayBeFine = false) {
    files.push_back({name, kVrml97 + body, mayBeFine});
  };
  add("proto_of_itself.wrl", "PROTO P [ ] { Group { children P { } } } P { }");
  add("proto_doubling.wrl", [] {
    std::string text = "PROTO P0 [ ] { Shape { geometry Box { } } }\n";
    for (int i = 1; i < 40; ++i)
      text += fmt::format("PROTO P{0} [ ] {{ Group {{ children [ P{1} {{ }} P{1} {{ }} ] }} }}\n",
                          i, i - 1);
    return text + "P39 { }\n";
  }());
  add("proto_without_body.wrl", "PROTO P [ field SFFloat x 1 ]");
  add("extern_proto.wrl", "EXTERNPROTO P [ ] \"http://localhost/p.wrl\" P { }");
  add("coord_index_beyond.wrl",
      "Shape { geometry IndexedFaceSet { coord Coordinate { point [ 0 0 0, 1 0 0, 0 1 0 ] } "
      "coordIndex [ 0,1,3,-1 ] } }");
  add("no_coord.wrl", "Shape { geometry IndexedFaceSet { coordIndex [ 0,1,2,-1 ] } }");
  add("grid_too_few_heights.wrl",
      "Shape { geometry ElevationGrid { xDimension 1000 zDimension 1000 height [ 1 2 3 ] } }");
  add("grid_negative.wrl",
      "Shape { geometry ElevationGrid { xDimension -5 zDimension 3 height [ 1 2 3 ] } }");
  add("extrusion_of_nothing.wrl",
      "Shape { geometry Extrusion { spine [ ] crossSection [ ] scale [ ] orientation [ ] } }");
  add("extrusion_too_few_scales.wrl",
      "Shape { geometry Extrusion { spine [ 0 0 0, 0 1 0, 0 2 0, 0 3 0 ] scale [ 1 1, 2 2 ] "
      "orientation [ 0 1 0 1, 0 1 0 2 ] } }",
      true);
  add("route_to_nowhere.wrl", "ROUTE a.b TO c.d Shape { geometry Box { } }", true);
  add("script.wrl", "Script { url \"javascript: while(true) ;\" } Shape { geometry Box { } }",
      true);
  add("level_out_of_range.wrl", "LOD { range [ -1 ] level [ ] }");
}

void addBinaryForms(std::vector<BadFile>& files) {
  const std::string cube = binaryInventorCube();
  const auto add = [&](const std::string& name, const std::string& bytes, bool mayBeFine = false) {
    files.push_back({name, bytes, mayBeFine});
  };
  for (const int percent : {20, 40, 60, 80, 99})
    add(fmt::format("binary_cut_at_{}_percent.iv", percent),
        cube.substr(0, cube.size() * std::size_t(percent) / 100));
  add("binary_count_huge.iv", BinaryInventor()
                                  .text("Coordinate3")
                                  .number(0)
                                  .number(1)
                                  .text("point")
                                  .number(0x7fffffff)
                                  .real(1)
                                  .bytes());
  add("binary_count_negative.iv", BinaryInventor()
                                      .text("Coordinate3")
                                      .number(0)
                                      .number(1)
                                      .text("point")
                                      .number(0xffffffff)
                                      .real(1)
                                      .bytes());
  add("binary_string_huge.iv", BinaryInventor().number(0x7ffffff0).bytes() + "Sep");
  add("binary_children_huge.iv",
      BinaryInventor().text("Separator").number(2).number(0).number(0x7fffffff).bytes());
  BinaryInventor deep;
  for (int i = 0; i < 100'000; ++i) deep.text("Separator").number(2).number(0).number(1);
  add("binary_nested_100000_deep.iv", deep.bytes());
  add("binary_file_node.iv", BinaryInventor()
                                 .text("File")
                                 .number(0)
                                 .number(1)
                                 .text("name")
                                 .text("/dev/zero")
                                 .number(0)
                                 .bytes());
  BinaryInventor beyond;
  beyond.text("Separator").number(2).number(0).number(2);
  beyond.text("Coordinate3").number(0).number(1).text("point").number(3);
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) beyond.real(x);
  beyond.number(0);
  beyond.text("IndexedFaceSet").number(0).number(1).text("coordIndex").number(3);
  beyond.number(0).number(1).number(0x7000'0000).number(0);
  add("binary_index_beyond.iv", beyond.bytes());
  for (BadFile& file : mutated(cube, ".iv", 12, 31)) {
    file.name = "binary_" + file.name;
    files.push_back(std::move(file));
  }
}

}  // namespace

std::string binaryInventorCube() {
  BinaryInventor out;
  out.text("Separator").number(2).number(0).number(2);
  out.text("Coordinate3").number(0).number(1).text("point").number(8);
  for (int corner = 0; corner < 8; ++corner)
    out.real(float(corner & 1)).real(float(corner >> 1 & 1)).real(float(corner >> 2 & 1));
  out.number(0);
  const int quads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  out.text("IndexedFaceSet").number(0).number(1).text("coordIndex").number(30);
  for (const auto& quad : quads) {
    for (const int i : quad) out.number(std::uint32_t(i));
    out.number(0xffffffff);
  }
  return out.number(0).bytes();
}

std::vector<BadFile> malformedInventorFiles() {
  std::vector<BadFile> files;
  addTextForms(files);
  addVrmlForms(files);
  addBinaryForms(files);
  return files;
}

}  // namespace resect::test
