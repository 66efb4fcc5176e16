#include "depth_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace resect::python {

namespace {
constexpr float kNear = 0.01f;  // m
}

DepthPicture::DepthPicture(int width, int height, const Camera& camera)
    : depth(std::size_t(width) * height, std::numeric_limits<float>::infinity()),
      labels(depth.size(), 0),
      width_(width),
      height_(height),
      turn_(camera.pose.rotation.conjugate().toRotationMatrix().cast<float>()),
      eye_(camera.pose.position.cast<float>()),
      scale_(float(height / 2.0 / camera.halfHeight)) {}

DepthPicture::Seen DepthPicture::see(const Vec3f& point) const {
  const Vec3f p = turn_ * (point - eye_);
  const float depth = -p.z();
  if (depth < kNear) return {};
  return {0.5f * float(width_) + scale_ * p.x() / depth,
          0.5f * float(height_) - scale_ * p.y() / depth, 1 / depth};
}

void DepthPicture::draw(std::span<const Vec3f> points, std::span<const Triangle> triangles,
                        std::uint16_t label, std::span<const std::uint8_t> pointLabels) {
  seen_.clear();
  for (const Vec3f& p : points) seen_.push_back(see(p));
  for (const Triangle& t : triangles) {
    if (t[0] == t[1]) continue;  // an unused entry
    const std::uint16_t own =
        std::uint16_t(label + (pointLabels.empty() ? 0 : pointLabels[std::size_t(t[0])]));
    fill(seen_[std::size_t(t[0])], seen_[std::size_t(t[1])], seen_[std::size_t(t[2])], own);
  }
}

void DepthPicture::drawTable(double halfX, double halfZ, std::uint16_t label) {
  const auto x = float(halfX), z = float(halfZ);
  // In small squares, so that the ones behind the camera can be left out.
  constexpr int kSquares = 12;
  std::vector<Vec3f> points;
  std::vector<Triangle> triangles;
  for (int i = 0; i <= kSquares; ++i)
    for (int k = 0; k <= kSquares; ++k)
      points.emplace_back(x * (2.f * float(i) / kSquares - 1), 0.f,
                          z * (2.f * float(k) / kSquares - 1));
  for (int i = 0; i < kSquares; ++i)
    for (int k = 0; k < kSquares; ++k) {
      const int a = i * (kSquares + 1) + k, b = a + kSquares + 1;
      triangles.push_back({a, a + 1, b + 1});
      triangles.push_back({a, b + 1, b});
    }
  draw(points, triangles, label);
}

// Rows of pixels whose middles lie in the triangle; 1 / depth is linear on the screen.
void DepthPicture::fill(const Seen& a, const Seen& b, const Seen& c, std::uint16_t label) {
  if (a.inverse == 0 || b.inverse == 0 || c.inverse == 0) return;
  const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (area == 0 || !std::isfinite(area)) return;
  const auto first = [](float low) { return std::max(0, int(std::ceil(low - 0.5f))); };
  const auto last = [](float high, int size) {
    return std::min(size - 1, int(std::floor(high - 0.5f)));
  };
  const float lowX = std::min({a.x, b.x, c.x}), highX = std::max({a.x, b.x, c.x});
  const float lowY = std::min({a.y, b.y, c.y}), highY = std::max({a.y, b.y, c.y});
  if (highX < 0 || highY < 0 || lowX > float(width_) || lowY > float(height_)) return;
  for (int y = first(std::max(lowY, -1.f)); y <= last(std::min(highY, float(height_)), height_);
       ++y)
    for (int x = first(std::max(lowX, -1.f)); x <= last(std::min(highX, float(width_)), width_);
         ++x) {
      const float px = float(x) + 0.5f, py = float(y) + 0.5f;
      const float u = ((b.x - px) * (c.y - py) - (c.x - px) * (b.y - py)) / area;
      const float v = ((c.x - px) * (a.y - py) - (a.x - px) * (c.y - py)) / area;
      const float w = 1 - u - v;
      if (u < 0 || v < 0 || w < 0) continue;
      const float depthHere = 1 / (u * a.inverse + v * b.inverse + w * c.inverse);
      const std::size_t pixel = std::size_t(y) * std::size_t(width_) + std::size_t(x);
      if (depthHere >= depth[pixel]) continue;
      depth[pixel] = depthHere;
      labels[pixel] = label;
    }
}

}  // namespace resect::python
