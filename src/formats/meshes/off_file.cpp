#include "formats/meshes/off_file.h"

#include "base/error.h"
#include "formats/meshes/word_reader.h"
#include "geometry/polygon.h"

namespace resect {
namespace {

// The letters before OFF, in this order: texture coordinates, colours, normals, 4 or n dimensions.
bool isOffWord(std::string_view word) {
  for (const std::string_view letters : {"st", "c", "n", "4", "n"})
    if (word != "off" && word.starts_with(letters)) word.remove_prefix(letters.size());
  return word == "off";
}

class OffReader {
 public:
  OffReader(const std::string& path, std::string_view bytes) : text_(path, bytes), path_(path) {}

  TriangleMesh read() {
    const std::size_t begin = text_.place();
    const std::string_view first = nextWord();
    if (!isOffWord(lowerCase(first)))
      text_.goTo(begin);  // the word may be left out
    else if (first.find('4') != first.npos || first.ends_with("nOFF"))
      throw error("{}: has points of four or more dimensions; export it with three", path_);
    const std::size_t counts = text_.place();
    if (lowerCase(nextWord()) == "binary")
      throw error("{}: is a binary .off file; save it as text, or as .ply or .stl", path_);
    text_.goTo(counts);
    const std::int64_t points = count("points"), faces = count("faces");
    text_.line();  // the number of edges, which may be left out
    TriangleMesh mesh;
    readPoints(points, mesh);
    readFaces(faces, mesh);
    return mesh;
  }

 private:
  // Words of one line; comments begin with #.
  std::string_view nextWord() {
    for (;;) {
      const std::string_view word = text_.word();
      if (!word.starts_with('#')) return word;
      text_.goTo(text_.place() - word.size());
      text_.line();
    }
  }
  std::int64_t count(const char* what) {
    const std::string_view word = nextWord();
    const std::optional<std::int64_t> value = wholeNumberOf(word);
    const std::string wanted = fmt::format("the number of {}", what);
    if (!value || *value < 0) throw text_.unexpected(word, wanted);
    // Each takes a digit and the end of its line at least.
    if (std::uint64_t(*value) > text_.left())
      throw text_.fail("the file ends early: it promises {} {}", *value, what);
    return *value;
  }

  void readPoints(std::int64_t count, TriangleMesh& mesh) {
    for (std::int64_t i = 0; i < count; ++i) {
      beginLine();
      mesh.points.push_back(text_.point());
      text_.line();
    }
  }

  void readFaces(std::int64_t count, TriangleMesh& mesh) {
    std::vector<std::int32_t> loop;
    for (std::int64_t i = 0; i < count; ++i) {
      beginLine();
      const std::int64_t corners = text_.wholeNumber("the number of a face's corners");
      if (corners < 0 || std::uint64_t(corners) > text_.left())
        throw text_.fail("has a face of {} corners", corners);
      loop.clear();
      for (std::int64_t k = 0; k < corners; ++k) {
        const std::int64_t point = text_.wholeNumber("the number of a point");
        if (point < 0 || point >= std::int64_t(mesh.points.size()))
          throw text_.fail("face {} uses point {} of only {}", i, point, mesh.points.size());
        loop.push_back(std::int32_t(point));
      }
      triangulatePolygon(mesh.points, loop, mesh.triangles);
      text_.line();
    }
  }

  // Passes over empty lines and comments.
  void beginLine() {
    const std::string_view word = nextWord();
    text_.goTo(text_.place() - word.size());
  }

  WordReader text_;
  const std::string& path_;
};

}  // namespace

bool startsAsOff(std::string_view bytes) {
  const std::size_t begin = bytes.find_first_not_of("\xef\xbb\xbf \t\r\n");
  if (begin == bytes.npos) return false;
  const std::string_view line = bytes.substr(begin, 16);
  return isOffWord(lowerCase(line.substr(0, line.find_first_of(" \t\r\n#"))));
}

Model readOffFile(const std::string& path, std::string_view bytes) {
  Model model;
  model.path = path;
  model.format = "OFF";
  addToPart(model, "", OffReader(path, bytes).read());
  return model;
}

}  // namespace resect
