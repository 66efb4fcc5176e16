// Do two closed bodies collide, where, and how much of one is in the other? In the three stages and
// the words of the original thesis (2004, sections 2.2.1 and 4.3).
//
//     Collider collider;
//     collider.setObject(Collider::First, organ);
//     collider.setObject(Collider::Second, tool);
//     if (collider.generateVolumeOfInterest()) {
//       collider.generateLayeredDepthImages(64);
//       collider.generateIntersectionVolume();
//       const LayeredDepthImage& ldi = collider.ldi(Collider::Intersection);
//       if (ldi.isInside(particle)) ...
//     }
//
// A stage before which an earlier one is missing is our own error and stops the program.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "collision/layered_depth_image.h"
#include "geometry/triangle_mesh.h"

namespace resect {

class Collider {
 public:
  enum ObjectId { First, Second, Intersection };

  // First or Second. The mesh is closed, oriented, looks outwards, and stands in the space that
  // both objects share, m; deforming objects are set anew each time. Clears what was generated.
  // Throws Error when a face has a corner that is none of the vertices, or a vertex is not finite.
  void setObject(ObjectId object, TriangleMesh mesh);
  // With a bounding box known beforehand; one that is too small leaves out what sticks out of it.
  void setObject(ObjectId object, const Aabb& boundingBox, std::span<const Vec3f> vertices,
                 std::span<const Triangle> faces);

  // Stage 1: the common part of the bounding boxes; false if they share no volume. Then the images
  // of the later stages are empty and those stages need not be called (but may be).
  bool generateVolumeOfInterest();
  const Aabb& volumeOfInterest() const { return volumeOfInterest_; }

  // Stage 2: the images of both objects in the volume of interest. resolution 1..4096: pixels along
  // its longer side across z; the shorter side gets as many as make the pixels about square.
  // Throws Error when an object is open. Cost: a pass over both meshes and the crossings.
  void generateLayeredDepthImages(int resolution = 64);

  // Stage 3: the common part of the images. volume() of the result is the overlap in m^3.
  void generateIntersectionVolume();

  // Valid until the next stage or setObject is called. Empty if that stage found nothing.
  const LayeredDepthImage& ldi(ObjectId object) const { return images_[object]; }

 private:
  struct Object {
    std::shared_ptr<const TriangleMesh> mesh;
    Aabb box;
  };
  void setObject(ObjectId object, TriangleMesh mesh, const Aabb& box);

  enum class Stage { None, VolumeOfInterest, Images, Intersection };
  Stage stage_ = Stage::None;
  std::array<Object, 2> objects_;
  Aabb volumeOfInterest_;
  bool overlap_ = false;
  std::array<LayeredDepthImage, 3> images_;
};

}  // namespace resect
