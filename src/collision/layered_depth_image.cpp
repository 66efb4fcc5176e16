#include "collision/layered_depth_image.h"

#include <algorithm>
#include <utility>

#include "base/assert.h"
#include "base/error.h"

namespace resect {

LayeredDepthImage LayeredDepthImage::ofMesh(std::shared_ptr<const TriangleMesh> mesh,
                                            const Aabb& box, int columnsX, int columnsY,
                                            const char* name) {
  RESECT_ASSERT(columnsX >= 1 && columnsY >= 1 && (box.size().array() > 0).all());
  LayeredDepthImage image;
  image.box_ = box;
  image.columnsX_ = columnsX;
  image.columnsY_ = columnsY;
  const Vec2 pitch(box.size().x() / columnsX, box.size().y() / columnsY);
  auto body = std::make_shared<const InsideQuery>(std::move(mesh), box);
  const Crossings columns =
      castColumns(body->snapped(), ColumnGrid{image.pixelCentre(0, 0), pitch, columnsX, columnsY});
  image.offsets_.reserve(columns.columnCount() + 1);
  for (std::size_t c = 0; c < columns.columnCount(); ++c) {
    int balance = 0;
    for (const Crossing& crossing : columns[c]) balance += crossing.sign;
    if (balance != 0)
      throw error(
          "{} is not closed: the line x = {:.6g}, y = {:.6g} enters it {} than it leaves; "
          "close the mesh first",
          name, image.pixelCentre(int(c % columnsX), int(c / columnsX)).x(),
          image.pixelCentre(int(c % columnsX), int(c / columnsX)).y(),
          balance > 0 ? "more often" : "less often");
    forEachInside(columns[c], [&](double entered, double left) {
      const DepthInterval clipped{std::max(entered, box.min.z()), std::min(left, box.max.z())};
      if (clipped.entry < clipped.exit) image.intervals_.push_back(clipped);
    });
    image.offsets_.push_back(image.intervals_.size());
  }
  image.bodies_.push_back(std::move(body));
  return image;
}

LayeredDepthImage LayeredDepthImage::intersection(const LayeredDepthImage& a,
                                                  const LayeredDepthImage& b) {
  RESECT_ASSERT(a.columnsX_ == b.columnsX_ && a.columnsY_ == b.columnsY_ &&
                a.box_.min == b.box_.min && a.box_.max == b.box_.max);
  LayeredDepthImage image;
  image.box_ = a.box_;
  image.columnsX_ = a.columnsX_;
  image.columnsY_ = a.columnsY_;
  image.bodies_ = a.bodies_;
  image.bodies_.insert(image.bodies_.end(), b.bodies_.begin(), b.bodies_.end());
  for (int j = 0; j < a.columnsY_; ++j)
    for (int i = 0; i < a.columnsX_; ++i) {
      const auto first = a.pixel(i, j), second = b.pixel(i, j);
      for (std::size_t m = 0, n = 0; m < first.size() && n < second.size();) {
        const DepthInterval common{std::max(first[m].entry, second[n].entry),
                                   std::min(first[m].exit, second[n].exit)};
        if (common.entry < common.exit) image.intervals_.push_back(common);
        // The one that ends first can meet nothing more.
        first[m].exit < second[n].exit ? ++m : ++n;
      }
      image.offsets_.push_back(image.intervals_.size());
    }
  return image;
}

int LayeredDepthImage::depth() const {
  std::size_t most = 0;
  for (std::size_t c = 1; c < offsets_.size(); ++c)
    most = std::max(most, offsets_[c] - offsets_[c - 1]);
  return int(most);
}

double LayeredDepthImage::volume() const {
  if (intervals_.empty()) return 0;
  double length = 0;
  for (const DepthInterval& interval : intervals_) length += interval.exit - interval.entry;
  return length * (box_.size().x() / columnsX_) * (box_.size().y() / columnsY_);
}

bool LayeredDepthImage::isInside(const Vec3& p) const {
  if (bodies_.empty()) return false;
  return std::all_of(bodies_.begin(), bodies_.end(),
                     [&](const auto& body) { return body->isInside(p); });
}

std::span<const DepthInterval> LayeredDepthImage::pixel(int i, int j) const {
  RESECT_ASSERT(i >= 0 && i < columnsX_ && j >= 0 && j < columnsY_);
  const std::size_t c = std::size_t(j) * columnsX_ + i;
  return {intervals_.data() + offsets_[c], intervals_.data() + offsets_[c + 1]};
}

Vec2 LayeredDepthImage::pixelCentre(int i, int j) const {
  return {box_.min.x() + (i + 0.5) * (box_.size().x() / columnsX_),
          box_.min.y() + (j + 0.5) * (box_.size().y() / columnsY_)};
}

}  // namespace resect
