// Inventor shape for an organ's surface, which changes often. Only changes are sent to the graphics
// card.
//
// The shape has its own vertex buffers in each graphics context. update() receives changes. The
// next time that a context renders the shape, the changed ranges are uploaded to that context. Each
// rendering draws only blocks of triangles that may lie in the view. If a scissor box is set, it
// draws only blocks that may lie in this box. The field `revision` counts the changes, so each
// change notifies the scene. An .iv file or an engine sets the whole surface through fields;
// inventor/gl/SoMarchingCubes.h has an example.
//
// A shader gets the present position of a vertex as gl_Vertex, its normal as gl_Normal, its rest
// position as gl_MultiTexCoord1.xyz, and its cut share as gl_MultiTexCoord2.x. The rest position is
// the position before the operation; with it, shaders draw patterns that move with the tissue. The
// cut share is explained at the field `cut`. In .iv files the node is written `OrganShape {}`.
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

  // Files and engines define the whole surface by these four fields. As long as none of these
  // fields is set, the surface comes from update() alone.
  SoMFVec3f points;   // m
  SoMFVec3f normals;  // for each point a unit normal, which faces outwards
  // For each point its cut share: 0 on the capsule (the organ's outer skin), 1 on a cut face of the
  // inner tissue. The value -1 means that the point is on the capsule at the rim of a cut. Missing
  // values count as 0.
  SoMFFloat cut;
  SoMFInt32 coordIndex;  // for each triangle three indices of points, then -1

  // Number of changes so far. update() increases it.
  SoSFInt32 revision;

  // Applies changes. If a range extends beyond the end of the shape's arrays, the arrays grow. For
  // vertices that have only moved, only points and normals are uploaded. wholeSurface()
  // (surface/surface_update.h) makes an update that replaces everything.
  void update(const SurfaceUpdate& update);

  // Shows another organ's blood on this shape, which hangs on that organ: where the blood is, is
  // told by the shape's points at rest. The other shape must live as long as this one.
  void showBloodOf(const SoOrganShape& organ) { bloodOf_ = &organ; }

  int vertexCount() const { return int(surface_.points.size()); }
  // Number of triangles, unused elements of the array included (see drawnTriangles()).
  int triangleCount() const { return int(surface_.triangles.size()); }

  // Binds the textures of blood, heat, structures and vessels for a shader program that draws this
  // shape without calling GLRender() (SoShadeOnce). The context and the program must be current.
  void bindInside(std::uint32_t context, unsigned program);

  // Boxes round everything that has changed since the last call of this function; in object space,
  // m. The boxes contain the changed parts at their former positions and at their present
  // positions.
  std::vector<Aabb> takeChanged();
  // The highest speed of the vertices that update() has moved since the last call of this function,
  // m/s. Only every 64th of these vertices is examined. The speed of a vertex is the distance by
  // which an update moved it, divided by the time since it was last examined. The result is
  // infinite if the surface got new vertices or triangles.
  double takeSpeed() { return std::exchange(speed_, 0.0); }

  // The first point at which a ray meets the present surface. Ray and point are in object space.
  // Returns nothing if the ray does not meet the surface.
  std::optional<OrganPoint> firstPointOn(const Ray& ray);
  // A copy of the present surface. firstPointOn() (inventor/gl/surface_ray.h) can later find points
  // of this copy.
  std::pair<SurfaceCopy, TriangleBlocks> snapshot();

  // Number of triangles that the last rendering drew, unused elements of the array included. (An
  // unused element is the triangle (0, 0, 0); see surface/surface_tracker.h.)
  std::int64_t drawnTriangles() const { return drawnTriangles_; }
  // Numbers of bytes and vertices that have been uploaded since the shape was made. Uploads to all
  // graphics contexts are added.
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
  const SoOrganShape* bloodOf_ = this;  // see showBloodOf()
  PerContext<ContextBuffers> contexts_;
  std::uint64_t uploadedBytes_ = 0, uploadedVertices_ = 0;
  std::int64_t drawnTriangles_ = 0;
  TriangleBlocks blocks_;
  // For takeChanged(). changedPlaces_: boxes of single changes. changedBlocks_: boxes of all
  // blocks; they are used for a change that moves more than half of the vertices.
  std::vector<TriangleBlocks::Box> changedPlaces_, changedBlocks_;
  double speed_ = 0;  // m/s, see takeSpeed()
  // For every 64 vertices: the time at which one of them was last examined for takeSpeed(); steady
  // clock, s.
  std::vector<double> moved_;
  bool fieldsAreTaken_ = true;
};

}  // namespace resect
