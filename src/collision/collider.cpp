#include "collision/collider.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/assert.h"
#include "base/error.h"

namespace resect {
namespace {

constexpr const char* kNames[2] = {"the first object", "the second object"};
constexpr int kFinest = 4096;

}  // namespace

void Collider::setObject(ObjectId object, TriangleMesh mesh) {
  const Aabb box = bounds(mesh);
  setObject(object, std::move(mesh), box);
}

void Collider::setObject(ObjectId object, const Aabb& boundingBox, std::span<const Vec3f> vertices,
                         std::span<const Triangle> faces) {
  TriangleMesh mesh;
  mesh.points.reserve(vertices.size());
  for (const Vec3f& v : vertices) mesh.points.push_back(v.cast<double>());
  mesh.triangles.assign(faces.begin(), faces.end());
  setObject(object, std::move(mesh), boundingBox);
}

void Collider::setObject(ObjectId object, TriangleMesh mesh, const Aabb& box) {
  RESECT_ASSERT(object == First || object == Second);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    if (!mesh.points[i].allFinite())
      throw error("vertex {} of {} is not finite; check its coordinates", i, kNames[object]);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::int32_t corner : mesh.triangles[t])
      if (corner < 0 || std::size_t(corner) >= mesh.points.size())
        throw error("face {} of {} refers to vertex {} of {}; check its indices", t, kNames[object],
                    corner, mesh.points.size());
  objects_[object] = {std::make_shared<const TriangleMesh>(std::move(mesh)), box};
  stage_ = Stage::None;
  images_ = {};
}

bool Collider::generateVolumeOfInterest() {
  RESECT_ASSERT(objects_[First].mesh && objects_[Second].mesh);
  volumeOfInterest_ = intersection(objects_[First].box, objects_[Second].box);
  overlap_ = (volumeOfInterest_.size().array() > 0).all();
  images_ = {};
  stage_ = Stage::VolumeOfInterest;
  return overlap_;
}

void Collider::generateLayeredDepthImages(int resolution) {
  RESECT_ASSERT(stage_ >= Stage::VolumeOfInterest);
  if (resolution < 1 || resolution > kFinest)
    throw usageError("the resolution of depth images must be 1 to {}, not {}", kFinest, resolution);
  images_ = {};
  if (overlap_) {
    const Vec3 size = volumeOfInterest_.size();
    const double pitch = std::max(size.x(), size.y()) / resolution;
    const auto pixels = [&](double side) {
      return std::clamp(int(std::lround(side / pitch)), 1, resolution);
    };
    for (const ObjectId object : {First, Second})
      images_[object] =
          LayeredDepthImage::ofMesh(objects_[object].mesh, volumeOfInterest_, pixels(size.x()),
                                    pixels(size.y()), kNames[object]);
  }
  stage_ = Stage::Images;
}

void Collider::generateIntersectionVolume() {
  RESECT_ASSERT(stage_ >= Stage::Images);
  images_[Intersection] = overlap_
                              ? LayeredDepthImage::intersection(images_[First], images_[Second])
                              : LayeredDepthImage{};
  stage_ = Stage::Intersection;
}

}  // namespace resect
