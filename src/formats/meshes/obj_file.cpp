#include "formats/meshes/obj_file.h"

#include <limits>
#include <map>
#include <utility>

#include "base/error.h"
#include "base/text/shown_text.h"
#include "formats/meshes/word_reader.h"
#include "geometry/polygon.h"

namespace resect {
namespace {

// Empty at the end of the line, where a comment may begin.
std::string_view takeWord(std::string_view& line) {
  line = trimmed(line);
  if (line.starts_with('#')) line = {};
  const std::string_view word = line.substr(0, line.find_first_of(" \t\v\f"));
  line.remove_prefix(word.size());
  return word;
}

struct Part {
  std::string name;
  std::vector<Triangle> triangles;  // of the file's points
};

class ObjReader {
 public:
  ObjReader(const std::string& path, std::string_view bytes)
      : lines_(path, bytes), begin_(lines_.place()) {}

  // Twice over the file, since a face may use points that come later.
  Model read() {
    readLines([&](std::string_view keyword, std::string_view line) {
      if (keyword == "v") readPoint(line);
    });
    lines_.goTo(begin_);
    readLines([&](std::string_view keyword, std::string_view line) {
      if (keyword == "v") ++pointsSoFar_;
      if (keyword == "f" || keyword == "fo") readFace(line);
      if (keyword == "o" || keyword == "g") beginPart(keyword == "o", std::string(trimmed(line)));
    });
    Model model;
    for (const Part& part : parts_) model.parts.push_back({part.name, ownMesh(part)});
    return model;
  }

 private:
  template <typename Take>
  void readLines(const Take& take) {
    std::string joined;
    while (!lines_.atEnd()) {
      start_ = lines_.place();
      std::string_view line = lines_.line();
      if (line.ends_with('\\') && !line.starts_with('#')) {  // goes on in the next line
        joined = line;
        while (joined.ends_with('\\') && !lines_.atEnd()) {
          joined.back() = ' ';
          joined += lines_.line();
        }
        line = joined;
      }
      const std::string keyword = lowerCase(takeWord(line));
      take(keyword, line);
    }
  }

  void beginPart(bool isObject, const std::string& name) {
    if (isObject) object_ = name;
    name_ = name.empty() ? object_ : name;
    current_ = std::nullopt;
  }

  // x y z, or x y z w, which stands for (x, y, z) / w; a colour may follow.
  void readPoint(std::string_view line) {
    double numbers[4] = {0, 0, 0, 1};
    int count = 0;
    for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line), ++count) {
      if (count >= 4) continue;
      const std::optional<double> value = numberOf(word);
      if (!value) throw unexpected(word, "a coordinate");
      numbers[count] = *value;
    }
    if (count < 3) throw fail("has a vertex of {} numbers instead of 3", count);
    const double w = count == 4 ? numbers[3] : 1;
    if (w == 0) throw fail("has a vertex of weight 0, which is no place");
    if (points_.size() >= std::size_t(std::numeric_limits<std::int32_t>::max()) / 3)
      throw fail("has more points than are read");
    points_.emplace_back(numbers[0] / w, numbers[1] / w, numbers[2] / w);
  }

  void readFace(std::string_view line) {
    loop_.clear();
    for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
      const std::optional<std::int64_t> number = wholeNumberOf(word.substr(0, word.find('/')));
      if (!number) throw unexpected(word, "the number of a point");
      // Negative numbers count back from the last point so far.
      const std::int64_t point = *number < 0 ? pointsSoFar_ + *number : *number - 1;
      if (*number == 0) throw fail("has a face with point 0, but points are counted from 1");
      if (point < 0 || point >= std::int64_t(points_.size()))
        throw fail("has a face with point {} of only {}", *number, points_.size());
      loop_.push_back(std::int32_t(point));
    }
    if (loop_.size() < 3) throw fail("has a face of {} corners", loop_.size());
    triangulatePolygon(points_, loop_, part().triangles);
  }

  Part& part() {
    if (!current_) {
      const auto [at, isNew] = number_.emplace(name_, parts_.size());
      if (isNew) parts_.push_back({name_, {}});
      current_ = at->second;
    }
    return parts_[*current_];
  }

  // With only the points that the part uses, in the order of their use.
  TriangleMesh ownMesh(const Part& part) {
    TriangleMesh mesh;
    mesh.triangles = part.triangles;
    own_.resize(points_.size(), -1);
    std::vector<std::int32_t> used;
    for (Triangle& t : mesh.triangles)
      for (std::int32_t& i : t) {
        if (own_[std::size_t(i)] < 0) {
          own_[std::size_t(i)] = std::int32_t(used.size());
          used.push_back(i);
        }
        i = own_[std::size_t(i)];
      }
    mesh.points.reserve(used.size());
    for (const std::int32_t i : used) {
      mesh.points.push_back(points_[std::size_t(i)]);
      own_[std::size_t(i)] = -1;
    }
    return mesh;
  }

  template <typename... Args>
  Error fail(fmt::format_string<Args...> format, Args&&... args) {
    lines_.goTo(start_);
    return lines_.fail(format, std::forward<Args>(args)...);
  }
  Error unexpected(std::string_view word, std::string_view what) {
    lines_.goTo(start_);
    return lines_.unexpected(word, what);
  }

  WordReader lines_;
  std::size_t begin_ = 0, start_ = 0;  // of the text, of the line
  std::int64_t pointsSoFar_ = 0;
  std::vector<Vec3> points_;
  std::vector<Part> parts_;
  std::map<std::string, std::size_t> number_;  // of the part of that name
  std::string object_, name_;
  std::optional<std::size_t> current_;  // part; nothing if name_ is new since the last face
  std::vector<std::int32_t> loop_, own_;
};

}  // namespace

Model readObjFile(const std::string& path, std::string_view bytes) {
  Model model = ObjReader(path, bytes).read();
  model.path = path;
  model.format = "OBJ";
  return model;
}

}  // namespace resect
