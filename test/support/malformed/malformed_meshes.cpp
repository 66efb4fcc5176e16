#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <limits>

#include "base/random.h"
#include "support/malformed/malformed.h"

namespace resect::test {
namespace {

template <typename T>
void put(std::string& bytes, T value) {
  char data[sizeof(T)];
  std::memcpy(data, &value, sizeof(T));
  bytes.append(data, sizeof(T));
}

std::string noise(std::size_t size) {
  Random random(77);
  std::string bytes;
  while (bytes.size() < size) bytes += char(random.below(256));
  return bytes;
}

// A binary STL that says it has `count` triangles, followed by those of a tetrahedron.
std::string stl(std::uint32_t count, float odd = 0) {
  std::string bytes(80, ' ');
  put(bytes, count);
  const float corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  for (const auto& face : faces) {
    for (int k = 0; k < 3; ++k) put(bytes, 0.F);
    for (const int i : face)
      for (int k = 0; k < 3; ++k) put(bytes, corners[i][k] + odd);
    put(bytes, std::uint16_t(0));
  }
  return bytes;
}

void addStl(std::vector<BadFile>& files) {
  const auto add = [&](const std::string& name, const std::string& bytes, bool mayBeFine = false) {
    files.push_back({name, bytes, mayBeFine});
  };
  add("empty.stl", "");
  add("one_byte.stl", "s");
  add("header_only.stl", std::string(80, ' '));
  add("count_without_triangles.stl", stl(4).substr(0, 84));
  add("count_too_large.stl", stl(5), true);
  add("count_huge.stl", stl(0xffffffffu), true);
  add("count_zero.stl", stl(0), true);
  add("cut.stl", stl(4).substr(0, 150), true);
  add("nan.stl", stl(4, std::numeric_limits<float>::quiet_NaN()));
  add("infinite.stl", stl(4, std::numeric_limits<float>::infinity()));
  add("ascii_without_end.stl",
      "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n");
  add("ascii_words.stl",
      "solid x\nfacet normal a b c\nouter loop\nvertex d e f\nvertex g h i\nvertex j k "
      "l\nendloop\nendfacet\nendsolid\n",
      true);
  add("ascii_two_corners.stl",
      "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 "
      "0\nendloop\nendfacet\nendsolid\n",
      true);
  add("ascii_empty.stl", "solid x\nendsolid x\n");
  add("noise.stl", noise(5000), true);
}

void addObj(std::vector<BadFile>& files) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const auto add = [&](const std::string& name, const std::string& bytes, bool mayBeFine = false) {
    files.push_back({name, bytes, mayBeFine});
  };
  add("empty.obj", "");
  add("points_only.obj", three);
  add("index_zero.obj", three + "f 0 1 2\n", true);
  add("index_beyond.obj", three + "f 1 2 4\n", true);
  add("index_huge.obj", three + "f 1 2 99999999999999\n", true);
  add("index_before.obj", three + "f -1 -2 -9\n", true);
  add("face_of_one.obj", three + "f 1\n", true);
  add("face_of_nothing.obj", three + "f\n", true);
  add("faces_before_points.obj", "f 1 2 3\n" + three, true);
  add("nan.obj", "v nan nan nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", true);
  add("far.obj", "v 1e30 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  add("words.obj", "v a b c\nv d e f\nv g h i\nf j k l\n", true);
  add("short_vertex.obj", "v 1\nv 1 2\nv\nf 1 2 3\n", true);
  add("line_of_a_million.obj", three + "f " + std::string(1'000'000, '1') + "\n", true);
  add("material_of_a_device.obj", "mtllib /dev/zero\n" + three + "f 1 2 3\n", true);
  add("slashes.obj", three + "f 1/////// 2//9 3/-4/\n", true);
  add("noise.obj", noise(5000), true);
  add("continued_for_ever.obj", three + "f 1 2 \\", true);
}

void addPly(std::vector<BadFile>& files) {
  const auto head = [](const std::string& vertices, const std::string& faces) {
    return "ply\nformat ascii 1.0\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
           "\nproperty list uchar int vertex_indices\nend_header\n";
  };
  const std::string three = "0 0 0\n1 0 0\n0 1 0\n";
  const auto add = [&](const std::string& name, const std::string& bytes, bool mayBeFine = false) {
    files.push_back({name, bytes, mayBeFine});
  };
  add("empty.ply", "");
  add("no_end_of_header.ply", "ply\nformat ascii 1.0\nelement vertex 3\n");
  add("vertices_huge.ply", head("4000000000", "1") + three + "3 0 1 2\n");
  add("vertices_negative.ply", head("-3", "1") + three + "3 0 1 2\n", true);
  add("faces_huge.ply", head("3", "2000000000") + three + "3 0 1 2\n", true);
  add("list_huge.ply", head("3", "1") + three + "255 0 1 2\n", true);
  add("index_beyond.ply", head("3", "1") + three + "3 0 1 3\n", true);
  add("index_negative.ply", head("3", "1") + three + "3 0 1 -1\n", true);
  add("words.ply", head("3", "1") + "a b c\nd e f\ng h i\n3 j k l\n", true);
  add("unknown_type.ply",
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty quaternion x\nend_header\n1\n");
  add("unknown_format.ply",
      "ply\nformat morse 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n");
  add("no_faces.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\nend_header\n" +
          three);
  std::string binary = head("3", "1");
  binary.replace(binary.find("ascii"), 5, "binary_little_endian");
  add("binary_cut.ply", binary + "abc");
  std::string listed = binary + std::string(36, '\0');
  put(listed, std::uint8_t(255));
  add("binary_list_cut.ply", listed);
  add("noise.ply", "ply\n" + noise(3000));
}

void addGltf(std::vector<BadFile>& files) {
  const auto add = [&](const std::string& name, const std::string& bytes, bool mayBeFine = false) {
    files.push_back({name, bytes, mayBeFine});
  };
  std::string data;
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) put(data, x);
  for (const int i : {0, 1, 2}) put(data, std::uint16_t(i));
  put(data, std::uint16_t(0));
  const auto json = [](const std::string& nodes, const std::string& indexCount,
                       const std::string& pointCount, const std::string& offset,
                       const std::string& length) {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":)" + nodes +
           R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[)"
           R"({"bufferView":0,"componentType":5126,"count":)" +
           pointCount + R"(,"type":"VEC3"},{"bufferView":1,"componentType":5123,"count":)" +
           indexCount + R"(,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteOffset":)" + offset +
           R"(,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],"buffers":[{"byteLength":)" +
           length + "}]}";
  };
  const std::string node = R"([{"mesh":0}])";
  const std::string good = binaryGltf(json(node, "3", "3", "0", "44"), data);
  add("empty.glb", "");
  add("magic_only.glb", "glTF");
  for (const std::size_t length :
       {std::size_t(12), std::size_t(60), std::size_t(300), good.size() - 10})
    add(fmt::format("cut_at_{}.glb", length), good.substr(0, length));
  std::string changed = good;
  changed[4] = 1;
  add("version_1.glb", changed);
  changed = good;
  changed[12] = changed[13] = changed[14] = char(0xff);
  add("json_chunk_too_long.glb", changed);
  changed = good;
  changed[12] = changed[13] = 0;
  add("json_chunk_empty.glb", changed, true);
  add("json_garbage.glb", binaryGltf("{\"asset\": [[[ nonsense", data));
  add("json_nested.glb", binaryGltf("{\"asset\":" + std::string(100'000, '['), data));
  add("no_asset.glb", binaryGltf("{}", data));
  add("count_huge.glb", binaryGltf(json(node, "3", "2000000000", "0", "44"), data));
  add("index_count_huge.glb", binaryGltf(json(node, "2000000001", "3", "0", "44"), data));
  add("count_negative.glb", binaryGltf(json(node, "3", "-3", "0", "44"), data));
  add("view_beyond.glb", binaryGltf(json(node, "3", "3", "100000000", "44"), data));
  add("buffer_too_long.glb", binaryGltf(json(node, "3", "3", "0", "4400000000"), data), true);
  add("mesh_beyond.glb", binaryGltf(json(R"([{"mesh":17}])", "3", "3", "0", "44"), data));
  add("child_beyond.glb",
      binaryGltf(json(R"([{"mesh":0,"children":[9]}])", "3", "3", "0", "44"), data));
  add("node_of_itself.glb",
      binaryGltf(json(R"([{"mesh":0,"children":[0]}])", "3", "3", "0", "44"), data));
  std::string beyond = data;
  beyond[36] = char(200);
  add("index_beyond.glb", binaryGltf(json(node, "3", "3", "0", "44"), beyond), true);
  add("noise.glb", "glTF" + noise(3000));
  add("buffer_missing.gltf",
      R"({"asset":{"version":"2.0"},"buffers":[{"uri":"no_such.bin","byteLength":44}],"scene":0,"scenes":[{"nodes":[]}]})");
  add("buffer_of_a_device.gltf",
      R"({"asset":{"version":"2.0"},"buffers":[{"uri":"/dev/zero","byteLength":4000000000}],"scene":0,"scenes":[{"nodes":[]}]})");
  add("bad_base64.gltf",
      R"({"asset":{"version":"2.0"},"buffers":[{"uri":"data:application/octet-stream;base64,%%%%","byteLength":44}],"scene":0,"scenes":[{"nodes":[]}]})");
  add("not_json.gltf", "hello");
}

void addVtk(std::vector<BadFile>& files) {
  const std::string head = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n";
  const std::string three = head + "POINTS 3 float\n0 0 0 1 0 0 0 1 0\n";
  const auto add = [&](const std::string& name, const std::string& bytes, bool mayBeFine = false) {
    files.push_back({name, bytes, mayBeFine});
  };
  add("empty.vtk", "");
  add("wrong_header.vtk", "# itk DataFile\n");
  add("not_poly_data.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\n");
  add("points_negative.vtk", head + "POINTS -3 float\n");
  add("points_huge.vtk", head + "POINTS 9000000000000000000 float\n0 0 0\n");
  add("points_too_many.vtk", head + "POINTS 700000000 float\n0 0 0\n");
  add("points_nan.vtk", head + "POINTS 3 float\nnan 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n");
  add("polygons_negative.vtk", three + "POLYGONS -1 4\n3 0 1 2\n");
  add("polygons_huge.vtk", three + "POLYGONS 9000000000000000000 9000000000000000000\n3 0 1 2\n");
  add("cell_too_long.vtk", three + "POLYGONS 1 4\n300 0 1 2\n");
  add("cell_negative.vtk", three + "POLYGONS 1 4\n-3 0 1 2\n");
  add("index_beyond.vtk", three + "POLYGONS 1 4\n3 0 1 3\n");
  add("index_negative.vtk", three + "TRIANGLE_STRIPS 1 4\n3 0 1 -2\n");
  add("no_polygons.vtk", three);
  add("offsets_falling.vtk",
      three + "POLYGONS 3 3\nOFFSETS vtktypeint64\n0 3 1\nCONNECTIVITY vtktypeint64\n0 1 2\n");
  add("field_huge.vtk", head + "FIELD f 2000000000\na 1 1 float\n0\n");
  std::string binary = three;
  binary.replace(binary.find("ASCII"), 5, "BINARY");
  add("binary_cut.vtk", binary);
  add("noise.vtk", head + noise(3000));
}

void addOthers(std::vector<BadFile>& files) {
  files.push_back({"counts_huge.off", "OFF\n2000000000 2000000000 0\n0 0 0\n"});
  files.push_back({"index_beyond.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 700\n", true});
  files.push_back({"cut.off", "OFF\n3 1 0\n0 0 0\n1 0"});
  files.push_back({"unknown.xyz", "0 0 0\n1 0 0\n"});
  files.push_back({"no_extension", noise(1000)});
  files.push_back({"picture.png", "\x89PNG\r\n\x1a\n" + noise(1000)});
}

}  // namespace

std::string binaryGltf(const std::string& json, const std::string& data) {
  std::string text = json, binary = data;
  text.append((4 - text.size() % 4) % 4, ' ');
  binary.append((4 - binary.size() % 4) % 4, '\0');
  std::string bytes = "glTF";
  put(bytes, std::uint32_t(2));
  put(bytes, std::uint32_t(12 + 8 + text.size() + 8 + binary.size()));
  put(bytes, std::uint32_t(text.size()));
  bytes += "JSON" + text;
  put(bytes, std::uint32_t(binary.size()));
  bytes += std::string("BIN\0", 4) + binary;
  return bytes;
}

std::vector<BadFile> malformedMeshFiles() {
  std::vector<BadFile> files;
  addStl(files);
  addObj(files);
  addPly(files);
  addGltf(files);
  addVtk(files);
  addOthers(files);
  return files;
}

std::vector<BadFile> malformedGzipFiles() {
  // A member of one stored block (RFC 1951) holds its text as it is.
  const auto stored = [](const std::string& text) {
    std::string bytes("\x1f\x8b\x08\0\0\0\0\0\0\x03\x01", 11);
    put(bytes, std::uint16_t(text.size()));
    put(bytes, std::uint16_t(~text.size()));
    return bytes + text;
  };
  const std::string scene = "#Inventor V2.1 ascii\nSeparator { Cube { } }\n";
  std::vector<BadFile> files;
  files.push_back({"gzip_header_only.iv", std::string("\x1f\x8b", 2)});
  files.push_back({"gzip_without_end.iv.gz", stored(scene)});
  files.push_back(
      {"gzip_wrong_checksum.iv.gz", stored(scene) + std::string("\1\2\3\4\x2b\0\0\0", 8)});
  files.push_back({"gzip_noise.iv.gz", std::string("\x1f\x8b\x08", 3) + noise(500)});
  files.push_back({"gzip_of_gzip.iv.gz", stored(stored(scene))});
  // The smallest bomb: runs of 258 zeros at 13 bits each, with the fixed codes of RFC 1951, 3.2.6.
  std::string bomb("\x1f\x8b\x08\0\0\0\0\0\0\x03", 10);
  std::uint32_t bits = 0, filled = 0;
  const auto put1 = [&](int bit) {
    bits |= std::uint32_t(bit) << filled;
    if (++filled == 8) bomb += char(bits), bits = filled = 0;
  };
  const auto putCode = [&](int code, int length) {
    for (int i = length - 1; i >= 0; --i) put1(code >> i & 1);
  };
  put1(1), put1(1), put1(0);  // last block, fixed codes
  putCode(0x30, 8);           // a zero
  for (int i = 0; i < 3'000'000; ++i) putCode(0xc5, 8), putCode(0, 5);
  files.push_back({"gzip_bomb.iv.gz", bomb});
  return files;
}

}  // namespace resect::test
