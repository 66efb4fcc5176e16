// Depth and labels of a scene of triangles, drawn on the processor without OpenGL.
//
// A z-buffer with one sample in the middle of each pixel. Depth is measured along the camera's
// axis. Triangles that reach behind the near plane are left out. Cost: 0.3 to 1 ms for 10 000
// triangles in 128 x 128 pixels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/pose.h"
#include "geometry/triangle_mesh.h"

namespace resect::python {

struct Camera {
  Pose pose;              // looks along its -Z, +Y is up; world, m
  double halfHeight = 0;  // tangent of half the angle of view along the picture's height
};

class DepthPicture {
 public:
  DepthPicture(int width, int height, const Camera& camera);

  // label: of a triangle by its first corner, if `labels` has one per point; else `label` for all.
  void draw(std::span<const Vec3f> points, std::span<const Triangle> triangles, std::uint16_t label,
            std::span<const std::uint8_t> labels = {});
  // The rectangle |x| <= halfX, |z| <= halfZ at y = 0.
  void drawTable(double halfX, double halfZ, std::uint16_t label);

  std::vector<float> depth;           // [height * width] m, top row first; infinite: nothing
  std::vector<std::uint16_t> labels;  // [height * width]; 0: nothing

 private:
  struct Seen {
    float x = 0, y = 0, inverse = 0;  // pixels; 1 / depth
  };
  Seen see(const Vec3f& point) const;
  void fill(const Seen& a, const Seen& b, const Seen& c, std::uint16_t label);

  int width_, height_;
  Eigen::Matrix3f turn_;
  Vec3f eye_;
  float scale_;  // pixels per unit of x / depth
  std::vector<Seen> seen_;
};

}  // namespace resect::python
