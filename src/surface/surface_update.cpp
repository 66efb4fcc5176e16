#include "surface/surface_update.h"

#include <initializer_list>

#include "base/error.h"

namespace resect {
namespace {

template <typename T>
void append(std::vector<T>& to, IndexRange range, std::span<const T> all) {
  const auto part = all.subspan(std::size_t(range.first), std::size_t(range.count));
  to.insert(to.end(), part.begin(), part.end());
}

std::size_t endOf(std::span<const IndexRange> ranges) {
  std::size_t end = 0;
  for (const IndexRange& r : ranges)
    end = std::max(end, std::size_t(r.first) + std::size_t(r.count));
  return end;
}

template <typename T>
void overwrite(std::vector<T>& to, std::span<const IndexRange> ranges,
               const std::vector<T>& values) {
  auto from = values.begin();
  for (const IndexRange& r : ranges) {
    std::copy_n(from, r.count, to.begin() + r.first);
    from += r.count;
  }
}

// Does one value stand for each of the ranges' numbers?
void requireFits(std::span<const IndexRange> ranges, std::initializer_list<std::size_t> values) {
  std::size_t count = 0;
  for (const IndexRange& r : ranges) {
    require(r.first >= 0 && r.count >= 0, "the range of {} from {} on is none; give numbers from 0",
            r.count, r.first);
    count += std::size_t(r.count);
  }
  for (const std::size_t size : values)
    require(size == count, "{} values were given for ranges of {}; give one for each", size, count);
}

void requireWithin(IndexRange range, std::size_t size) {
  require(range.first >= 0 && range.count >= 0 &&
              std::size_t(range.first) + std::size_t(range.count) <= size,
          "the range of {} from {} on is not among {} values; give one that is", range.count,
          range.first, size);
}

}  // namespace

void addNewVertices(SurfaceUpdate& update, IndexRange range, std::span<const Vec3f> rest,
                    std::span<const float> cut) {
  requireWithin(range, std::min(rest.size(), cut.size()));
  if (range.count == 0) return;
  update.newVertices.push_back(range);
  append(update.rest, range, rest);
  append(update.cut, range, cut);
}

void addMovedVertices(SurfaceUpdate& update, IndexRange range, std::span<const Vec3f> points,
                      std::span<const Vec3f> normals) {
  requireWithin(range, std::min(points.size(), normals.size()));
  if (range.count == 0) return;
  update.movedVertices.push_back(range);
  append(update.points, range, points);
  append(update.normals, range, normals);
}

void addNewTriangles(SurfaceUpdate& update, IndexRange range, std::span<const Triangle> triangles) {
  requireWithin(range, triangles.size());
  if (range.count == 0) return;
  update.newTriangles.push_back(range);
  append(update.triangles, range, triangles);
}

SurfaceUpdate wholeSurface(std::span<const Vec3f> points, std::span<const Vec3f> normals,
                           std::span<const float> cut, std::span<const Triangle> triangles,
                           std::span<const Vec3f> rest) {
  require(normals.size() == points.size() && cut.size() == points.size() &&
              (rest.empty() || rest.size() == points.size()),
          "{} points have {} normals, {} shares of cut and {} rest positions; give one of each for "
          "every point, or no rest position",
          points.size(), normals.size(), cut.size(), rest.size());
  SurfaceUpdate update;
  update.everything = true;
  const IndexRange vertices{0, std::int32_t(points.size())};
  addNewVertices(update, vertices, rest.empty() ? points : rest, cut);
  addMovedVertices(update, vertices, points, normals);
  addNewTriangles(update, {0, std::int32_t(triangles.size())}, triangles);
  return update;
}

void apply(const SurfaceUpdate& update, SurfaceCopy& copy) {
  requireFits(update.newVertices, {update.rest.size(), update.cut.size()});
  requireFits(update.movedVertices, {update.points.size(), update.normals.size()});
  requireFits(update.newTriangles, {update.triangles.size()});
  if (update.everything) copy = {};
  const std::size_t vertices =
      std::max({copy.points.size(), endOf(update.newVertices), endOf(update.movedVertices)});
  copy.points.resize(vertices, Vec3f::Zero());
  copy.normals.resize(vertices, Vec3f::UnitY());
  copy.rest.resize(vertices, Vec3f::Zero());
  copy.cut.resize(vertices, 0.0f);
  copy.triangles.resize(std::max(copy.triangles.size(), endOf(update.newTriangles)),
                        Triangle{0, 0, 0});
  overwrite(copy.rest, update.newVertices, update.rest);
  overwrite(copy.cut, update.newVertices, update.cut);
  overwrite(copy.points, update.movedVertices, update.points);
  overwrite(copy.normals, update.movedVertices, update.normals);
  overwrite(copy.triangles, update.newTriangles, update.triangles);
}

}  // namespace resect
