#include "formats/meshes/stl_file.h"

#include <bit>
#include <cstdint>

#include "base/error.h"
#include "formats/meshes/word_reader.h"
#include "geometry/polygon.h"

namespace resect {
namespace {

constexpr std::size_t kHeader = 84, kRecord = 50;  // bytes; the header ends with the count

std::uint64_t bytesPromised(std::string_view bytes) {
  return kHeader + kRecord * std::uint64_t(littleEndian(bytes, kHeader - 4));
}

// A binary file may begin with "solid" too, but below 2^24 triangles the highest byte of its count
// is NUL.
bool isText(std::string_view bytes) {
  return startsAsTextStl(bytes) && bytes.substr(0, kHeader).find('\0') == bytes.npos;
}

TriangleMesh readBinary(const std::string& path, std::string_view bytes) {
  if (bytes.size() < kHeader)
    throw error("{}: is neither a text STL nor long enough for a binary one; export it again",
                path);
  const std::uint32_t count = littleEndian(bytes, kHeader - 4);
  if (count == 0 && bytes.size() > kHeader)
    throw error("{}: says that it has no triangles, but {} bytes follow; export it again", path,
                bytes.size() - kHeader);
  if (bytes.size() < bytesPromised(bytes))
    throw error("{}: the file ends early: it promises {} triangles and holds {}; export it again",
                path, count, (bytes.size() - kHeader) / kRecord);
  TriangleMesh mesh;
  mesh.points.reserve(3 * std::size_t(count));
  mesh.triangles.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::size_t record = kHeader + kRecord * i;
    const auto first = std::int32_t(mesh.points.size());
    for (std::size_t corner = 1; corner <= 3; ++corner) {  // 0 is the normal
      Vec3 p;
      for (std::size_t k = 0; k < 3; ++k)
        p[int(k)] = double(std::bit_cast<float>(littleEndian(bytes, record + 12 * corner + 4 * k)));
      mesh.points.push_back(p);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

class TextStl {
 public:
  TextStl(const std::string& path, std::string_view bytes) : words_(path, bytes) {}

  void readInto(Model& model) {
    for (std::string word = keyword(); word == "solid"; word = keyword()) {
      const std::string name(trimmed(words_.line()));
      addToPart(model, name, readSolid());
    }
    // What else follows is none of the model's, unless a facet was left outside.
    if (lastWord_ == "facet" || lastWord_ == "vertex")
      throw words_.fail("has '{}' after endsolid", lastWord_);
  }

 private:
  // In small letters; some programs write "end solid" in two words.
  std::string keyword() {
    lastWord_ = lowerCase(words_.word());
    if (lastWord_ == "end") lastWord_ += lowerCase(words_.word());
    return lastWord_;
  }
  void expect(std::string_view word) {
    if (keyword() != word) throw words_.unexpected(lastWord_, fmt::format("'{}'", word));
  }

  TriangleMesh readSolid() {
    TriangleMesh mesh;
    std::vector<std::int32_t> loop;
    while (keyword() == "facet") {
      // "normal" and its three numbers, which nobody needs and some programs leave undefined.
      for (int i = 0; i < 4; ++i) words_.word();
      expect("outer");
      expect("loop");
      loop.clear();
      while (keyword() == "vertex") {
        loop.push_back(std::int32_t(mesh.points.size()));
        mesh.points.push_back(words_.point());
      }
      if (lastWord_ != "endloop") throw words_.unexpected(lastWord_, "'vertex' or 'endloop'");
      if (loop.size() < 3) throw words_.fail("has a facet of {} corners", loop.size());
      expect("endfacet");
      triangulatePolygon(mesh.points, loop, mesh.triangles);
    }
    if (lastWord_ != "endsolid") throw words_.unexpected(lastWord_, "'facet' or 'endsolid'");
    words_.line();  // the name again
    return mesh;
  }

  WordReader words_;
  std::string lastWord_;
};

}  // namespace

bool isExactBinaryStl(std::string_view bytes) {
  return bytes.size() > kHeader && bytes.size() == bytesPromised(bytes);
}

bool startsAsTextStl(std::string_view bytes) {
  const std::size_t begin = bytes.find_first_not_of("\xef\xbb\xbf \t\r\n");
  if (begin == bytes.npos) return false;
  const std::string word = lowerCase(bytes.substr(begin, 6));
  return word.starts_with("solid") && word.size() == 6 && (word[5] <= ' ' && word[5] >= '\t');
}

Model readStlFile(const std::string& path, std::string_view bytes) {
  Model model;
  model.path = path;
  model.format = "STL";
  if (isExactBinaryStl(bytes) || !isText(bytes))
    addToPart(model, "", readBinary(path, bytes));
  else
    TextStl(path, bytes).readInto(model);
  return model;
}

}  // namespace resect
