#include "anatomy/eight_nearest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace resect {
namespace {

constexpr double kBeyond = 0.015;    // m: how far the boxes reach beyond the places
constexpr double kLeastSide = 0.01;  // m: of a box
constexpr int kMostBoxes = 24;       // along an axis

void insert(EightNearest::Eight& found, double squaredDistance, std::int32_t place) {
  if (!(squaredDistance < found.back().squaredDistance)) return;
  std::size_t k = found.size() - 1;
  for (; k > 0 && found[k - 1].squaredDistance > squaredDistance; --k) found[k] = found[k - 1];
  found[k] = {squaredDistance, place};
}

EightNearest::Eight none() {
  EightNearest::Eight found;
  found.fill({std::numeric_limits<double>::infinity(), 0});
  return found;
}

}  // namespace

EightNearest::EightNearest(std::vector<Vec3> places) : places_(std::move(places)) {
  Aabb box;
  for (const Vec3& place : places_) box.grow(place);
  begin_ = {0};
  if (places_.empty()) return;
  box = box.padded(kBeyond);
  first_ = box.min;
  side_ = std::max(kLeastSide, box.size().maxCoeff() / kMostBoxes);
  count_ = (box.size() / side_).array().ceil().cast<int>().max(1);
  std::vector<std::pair<double, std::int32_t>> far(places_.size());
  for (int b = 0; b < count_.prod(); ++b) {
    const Vec3i at(b % count_.x(), b / count_.x() % count_.y(), b / (count_.x() * count_.y()));
    const Vec3 middle = first_ + side_ * (at.cast<double>() + Vec3::Constant(0.5));
    Eight eight = none();
    for (std::size_t i = 0; i < places_.size(); ++i) {
      far[i] = {(places_[i] - middle).squaredNorm(), std::int32_t(i)};
      insert(eight, far[i].first, std::int32_t(i));
    }
    // A point of the box is at most half a diagonal from its middle. So its eighth place is at most
    // that much farther away, and is at most a diagonal farther from the middle.
    const double reach = std::sqrt(eight.back().squaredDistance) + 1.0001 * std::sqrt(3.0) * side_;
    const std::size_t start = lists_.size();
    for (const auto& [squared, place] : far)
      if (squared <= reach * reach) lists_.push_back(place);
    std::ranges::sort(std::span(lists_).subspan(start), {},
                      [&](std::int32_t place) { return far[std::size_t(place)]; });
    begin_.push_back(std::int32_t(lists_.size()));
  }
}

EightNearest::Eight EightNearest::operator()(const Vec3& point) const {
  Eight found = none();
  const Vec3 at = (point - first_) / side_;
  if ((at.array() >= 0).all() && (at.array() < count_.cast<double>().array()).all()) {
    const Vec3i box = at.cast<int>();
    const auto b = std::size_t((box.z() * count_.y() + box.y()) * count_.x() + box.x());
    for (std::int32_t k = begin_[b]; k < begin_[b + 1]; ++k) {
      const std::int32_t place = lists_[std::size_t(k)];
      insert(found, (places_[std::size_t(place)] - point).squaredNorm(), place);
    }
  } else {
    for (std::size_t i = 0; i < places_.size(); ++i)
      insert(found, (places_[i] - point).squaredNorm(), std::int32_t(i));
  }
  return found;
}

}  // namespace resect
