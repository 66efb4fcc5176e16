#include "formats/meshes/ply_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "base/error.h"
#include "formats/meshes/ply_header.h"
#include "formats/meshes/word_reader.h"
#include "geometry/polygon.h"

namespace resect {
namespace {

double valueOf(std::uint64_t raw, PlyNumber type) {
  switch (type) {
    case PlyNumber::Int8:
      return std::int8_t(raw);
    case PlyNumber::Int16:
      return std::int16_t(raw);
    case PlyNumber::Int32:
      return std::int32_t(raw);
    case PlyNumber::Float32:
      return double(std::bit_cast<float>(std::uint32_t(raw)));
    case PlyNumber::Float64:
      return std::bit_cast<double>(raw);
    default:
      return double(raw);
  }
}

class PlyReader {
 public:
  PlyReader(const std::string& path, std::string_view bytes)
      : path_(path), header_(readPlyHeader(path, bytes)), bytes_(bytes), words_(path, bytes) {
    words_.goTo(header_.end);
  }

  TriangleMesh read() {
    bool haveFaces = false;
    for (const PlyElement& element : header_.elements) {
      element_ = &element;
      const bool isFace = element.name == "face", isStrip = element.name == "tristrips";
      haveFaces = haveFaces || ((isFace || isStrip) && element.count > 0);
      if (element.name == "vertex")
        readPoints();
      else
        readLists(isFace || isStrip ? indexProperty() : kNone, isStrip);
    }
    if (!haveFaces)
      throw error("{}: has points and no faces; make a surface of them first, as MeshLab does",
                  path_);
    addFaces();
    return std::move(mesh_);
  }

 private:
  static constexpr std::size_t kNone = std::size_t(-1);

  void readPoints() {
    const std::vector<PlyProperty>& properties = element_->properties;
    std::array<std::size_t, 3> place{kNone, kNone, kNone};
    for (std::size_t p = 0; p < properties.size(); ++p)
      for (std::size_t k = 0; k < 3; ++k)
        if (!properties[p].isList && properties[p].name == std::string_view("xyz").substr(k, 1))
          place[k] = p;
    if (std::ranges::count(place, kNone) > 0)
      throw error("{}: its vertices have no x, y and z; export the file again", path_);
    mesh_.points.reserve(std::size_t(element_->count));
    for (done_ = 0; done_ < element_->count; ++done_) {
      Vec3 point = Vec3::Zero();
      for (std::size_t p = 0; p < properties.size(); ++p) {
        if (properties[p].isList) {
          takeList(properties[p], nullptr);
          continue;
        }
        const double value = take(properties[p].type);
        for (std::size_t k = 0; k < 3; ++k)
          if (place[k] == p) point[int(k)] = value;
      }
      mesh_.points.push_back(point);
    }
  }

  std::size_t indexProperty() const {
    const std::vector<PlyProperty>& properties = element_->properties;
    for (std::size_t p = 0; p < properties.size(); ++p)
      if (properties[p].isList &&
          (properties[p].name == "vertex_indices" || properties[p].name == "vertex_index"))
        return p;
    throw error("{}: its faces have no list vertex_indices; export the file again", path_);
  }

  // Reads the element and keeps the lists of property `wanted`, if any, as faces.
  void readLists(std::size_t wanted, bool strips) {
    const std::vector<PlyProperty>& properties = element_->properties;
    for (done_ = 0; done_ < element_->count && !properties.empty(); ++done_)
      for (std::size_t p = 0; p < properties.size(); ++p) {
        if (!properties[p].isList) {
          take(properties[p].type);
          continue;
        }
        if (p != wanted) {
          takeList(properties[p], nullptr);
          continue;
        }
        Face& face = faces_.emplace_back();
        face.isStrip = strips, face.first = corners_.size();
        takeList(properties[p], &corners_);
        face.count = corners_.size() - face.first;
      }
  }

  void takeList(const PlyProperty& property, std::vector<std::int64_t>* values) {
    const double count = take(property.countType);
    const std::size_t each = header_.form == PlyForm::Text ? 1 : bytesOf(property.type);
    if (!(count >= 0) || count != std::floor(count))
      throw error("{}: {} {} has {:g} numbers; export the file again", path_, element_->name, done_,
                  count);
    if (count > double(words_.left() / each)) throw endsEarly();
    for (double i = 0; i < count; ++i) {
      const double value = take(property.type);
      if (!values) continue;
      constexpr double kMost = std::numeric_limits<std::int32_t>::max();
      if (!(std::abs(value) <= kMost) || value != std::floor(value))
        throw error("{}: {} {} uses point {:g}; export the file again", path_, element_->name,
                    done_, value);
      values->push_back(std::int64_t(value));
    }
  }

  double take(PlyNumber type) {
    if (header_.form == PlyForm::Text) {
      const std::string_view word = words_.word();
      if (word.empty()) throw endsEarly();
      const std::optional<double> value = numberOf(word);
      if (!value) throw words_.unexpected(word, "a number");
      return *value;
    }
    const std::size_t count = bytesOf(type);
    if (words_.left() < count) throw endsEarly();
    const std::size_t at = words_.place();
    std::uint64_t raw = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t from = header_.form == PlyForm::BigEndian ? i : count - 1 - i;
      raw = raw << 8 | static_cast<unsigned char>(bytes_[at + from]);
    }
    words_.goTo(at + count);
    return valueOf(raw, type);
  }

  Error endsEarly() const {
    return error(
        "{}: the file ends early: it promises {} elements '{}' and holds {}; copy or "
        "export it again",
        path_, element_->count, element_->name, done_);
  }

  void addFaces() {
    std::vector<std::int32_t> loop;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const Face& face = faces_[f];
      loop.clear();
      for (std::size_t i = face.first; i < face.first + face.count; ++i) {
        const std::int64_t point = corners_[i];
        if (face.isStrip && point == -1) {  // a strip ends
          addStrip(loop);
          loop.clear();
          continue;
        }
        if (point < 0 || point >= std::int64_t(mesh_.points.size()))
          throw error("{}: face {} uses point {} of only {}; export the file again", path_, f,
                      point, mesh_.points.size());
        loop.push_back(std::int32_t(point));
      }
      if (face.isStrip)
        addStrip(loop);
      else
        triangulatePolygon(mesh_.points, loop, mesh_.triangles);
    }
  }

  void addStrip(const std::vector<std::int32_t>& strip) {
    for (std::size_t k = 0; k + 2 < strip.size(); ++k)
      mesh_.triangles.push_back(k % 2 == 0 ? Triangle{strip[k], strip[k + 1], strip[k + 2]}
                                           : Triangle{strip[k + 1], strip[k], strip[k + 2]});
  }

  struct Face {
    bool isStrip = false;
    std::size_t first = 0, count = 0;  // in corners_
  };

  const std::string& path_;
  PlyHeader header_;
  std::string_view bytes_;
  WordReader words_;
  const PlyElement* element_ = nullptr;  // that is read
  std::int64_t done_ = 0;                // of it
  std::vector<Face> faces_;
  std::vector<std::int64_t> corners_;
  TriangleMesh mesh_;
};

}  // namespace

bool startsAsPly(std::string_view bytes) {
  return lowerCase(bytes.substr(0, 3)) == "ply" && bytes.size() > 3 &&
         (bytes[3] == '\n' || bytes[3] == '\r' || bytes[3] == ' ');
}

Model readPlyFile(const std::string& path, std::string_view bytes) {
  Model model;
  model.path = path;
  model.format = "PLY";
  addToPart(model, "", PlyReader(path, bytes).read());
  return model;
}

}  // namespace resect
