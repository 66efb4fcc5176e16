// Inventor shape for an organ's changing surface: only changes are sent to the graphics card.
//
// The shape has its own vertex buffers. update() receives changes. When a graphics context next
// renders the shape, the changed ranges are uploaded to it. Each rendering draws only blocks of
// triangles that may lie in the view, or in the scissor box if one is set. The field `revision`
// counts changes and notifies the scene. An .iv file or an engine sets the whole surface through
// fields (example: inventor/gl/SoMarchingCubes.h).
//
// Attributes for shaders: gl_Vertex, gl_Normal, gl_MultiTexCoord1.xyz = rest position (for patterns
// that move with the tissue), gl_MultiTexCoord2.x = cut share. In .iv files: `OrganShape {}`.
#pragma once

#include <Inventor/fields/SoMFFloat.h>
#include <Inventor/fields/SoMFInt32.h>
#include <Inventor/fields/SoMFVec3f.h>
#include <Inventor/fields/SoSFInt32.h>
#include <Inventor/nodes/SoShape.h>
#include <Inventor/nodes/SoSubNode.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/vec.h"
#include "geometry/aabb.h"
#include "inventor/gl/per_context.h"
#include "inventor/gl/surface_ray.h"
#include "inventor/gl/triangle_blocks.h"
#include "surface/surface_update.h"

namespace resect {

class SoOrganShape : public SoShape {
  SO_NODE_HEADER(SoOrganShape);

 public:
  static void initClass();
  SoOrganShape();

  // Files and engines set these fields to define the whole surface. As long as none of them is set,
  // the surface comes from update() alone.
  SoMFVec3f points;      // m
  SoMFVec3f normals;     // unit, outwards, one per point
  SoMFFloat cut;         // cut share per point: 0 capsule, 1 cut parenchyma, -1 capsule at the
                         // rim of a cut; missing values are 0
  SoMFInt32 coordIndex;  // triangles: three indices, then -1

  // Number of changes so far. update() writes it.
  SoSFInt32 revision;

  // Applies changes. If a range extends beyond the end of the shape's arrays, they grow. For
  // vertices that only moved, only points and normals are uploaded. wholeSurface()
  // (surface_update.h) makes an update that replaces everything.
  void update(const SurfaceUpdate& update);

  int vertexCount() const { return int(surface_.points.size()); }
  int triangleCount() const { return int(surface_.triangles.size()); }  // see drawnTriangles()

  // Binds the textures of blood, heat, structures and vessels for a program that draws this shape
  // in another way (SoShadeOnce). The context and the program must be current.
  void bindInside(std::uint32_t context, unsigned program);

  // Boxes, in object space, m, round what has changed since the last call of this function.
  // Together they contain the changed parts at their former and at their present positions.
  std::vector<Aabb> takeChanged();
  // The highest speed of a vertex among those that update() moved since the last call of this
  // function, m/s. A vertex's speed is the distance by which an update moves it, divided by the
  // time since its previous update. Infinite if the surface changed in another way.
  double takeSpeed() { return std::exchange(speed_, 0.0); }

  // The first point, in object space, where a ray meets the present surface; none if there is no
  // such point.
  std::optional<SurfacePoint> firstPointOn(const Ray& ray);
  // A copy of the present surface, on which points along rays can be found later.
  std::pair<SurfaceCopy, TriangleBlocks> snapshot();

  // Triangles drawn at the last rendering, unused elements of the array included. (An unused
  // element is the triangle (0, 0, 0); see surface/surface_tracker.h.)
  std::int64_t drawnTriangles() const { return drawnTriangles_; }
  // Bytes and vertices uploaded to all graphics contexts together since the shape was made.
  std::uint64_t uploadedBytes() const { return uploadedBytes_; }
  std::uint64_t uploadedVertices() const { return uploadedVertices_; }

 protected:
  ~SoOrganShape() override;
  void GLRender(SoGLRenderAction* action) override;
  void computeBBox(SoAction* action, SbBox3f& box, SbVec3f& centre) override;
  void generatePrimitives(SoAction* action) override;
  void notify(SoNotList* list) override;

 private:
  struct Range {
    std::size_t begin = 0, end = 0;
  };
  struct ContextBuffers;

  static void merge(std::vector<Range>& ranges);
  void takeFields();
  void refreshBlocks();
  void noteSpeed(const SurfaceUpdate& update);
  void addChanged(const TriangleBlocks::Box& box);
  void growChanged(const std::vector<Range>& vertices, const std::vector<Range>& triangles);
  std::vector<TriangleBlocks::Run> seen(SoState* state);
  void upload(ContextBuffers& buffers);

  SurfaceCopy surface_;
  std::shared_ptr<const TissueMap> blood_, heat_, structures_;
  std::shared_ptr<const VesselPicture> vessels_;
  PerContext<ContextBuffers> contexts_;
  std::uint64_t uploadedBytes_ = 0, uploadedVertices_ = 0;
  std::int64_t drawnTriangles_ = 0;
  TriangleBlocks blocks_;
  // For takeChanged(): boxes of single changes, and boxes of all blocks, used when most of the
  // surface moved.
  std::vector<TriangleBlocks::Box> changedPlaces_, changedBlocks_;
  double speed_ = 0;  // m/s, see takeSpeed()
  std::vector<double>
      moved_;  // per 64 vertices: when the first of them moved last, steady clock, s
  bool fieldsAreTaken_ = true;
};

}  // namespace resect
