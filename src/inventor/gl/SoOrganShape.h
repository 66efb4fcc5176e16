// Inventor shape for an organ's changing surface: only changes are sent to the graphics card.
//
// It has vertex buffers of its own. update() receives changes; the next rendering uploads those
// ranges to each context that draws the shape, and draws only blocks of triangles that can lie in
// the scissor box. The field `revision` counts changes and notifies the scene. From an .iv file or
// an engine the whole surface comes through fields: see inventor/gl/SoMarchingCubes.h.
//
// Attributes seen by a shader: gl_Vertex, gl_Normal, gl_MultiTexCoord1.xyz = rest position (for
// patterns that stick to the tissue), gl_MultiTexCoord2.x = cut. In .iv files: `OrganShape {}`.
#pragma once

#include <Inventor/fields/SoMFFloat.h>
#include <Inventor/fields/SoMFInt32.h>
#include <Inventor/fields/SoMFVec3f.h>
#include <Inventor/fields/SoSFInt32.h>
#include <Inventor/nodes/SoShape.h>
#include <Inventor/nodes/SoSubNode.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "base/vec.h"
#include "geometry/aabb.h"
#include "geometry/ray.h"
#include "inventor/gl/per_context.h"
#include "inventor/gl/triangle_blocks.h"
#include "surface/surface_update.h"

namespace resect {

class SoOrganShape : public SoShape {
  SO_NODE_HEADER(SoOrganShape);

 public:
  static void initClass();
  SoOrganShape();

  // The whole surface, for files and engines; while coordIndex is empty these fields are not used.
  SoMFVec3f points;      // m
  SoMFVec3f normals;     // unit, outwards, one per point
  SoMFFloat cut;         // 0 = capsule, 1 = cut parenchyma, one per point; missing ones count as 0
  SoMFInt32 coordIndex;  // triangles: three and -1

  // Number of changes so far. Written by update().
  SoSFInt32 revision;

  // Applies changes. Ranges may extend beyond the present end: then the shape grows. For vertices
  // that only moved, points and normals are uploaded. wholeSurface() makes an update that replaces
  // everything.
  void update(const SurfaceUpdate& update);

  int vertexCount() const { return int(surface_.points.size()); }
  int triangleCount() const { return int(surface_.triangles.size()); }  // holes included

  // Bounds of all changes since the last call, before and after them; m, object space.
  Aabb takeChanged();

  // First intersection of a ray with the present surface, in object space, if any. Cost: a box test
  // per 128 triangles, and the triangles of the boxes that it meets.
  std::optional<Vec3> firstPointOn(const Ray& ray);

  // Triangles sent through the graphics pipeline at the last rendering.
  std::int64_t drawnTriangles() const { return drawnTriangles_; }
  // Sent to graphics contexts since the shape was made.
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
  void growChanged(const std::vector<Range>& vertices, const std::vector<Range>& triangles);
  std::vector<TriangleBlocks::Run> seen(SoState* state);
  void upload(ContextBuffers& buffers);

  SurfaceCopy surface_;
  PerContext<ContextBuffers> contexts_;
  std::uint64_t uploadedBytes_ = 0, uploadedVertices_ = 0;
  std::int64_t drawnTriangles_ = 0;
  TriangleBlocks blocks_;
  TriangleBlocks::Box changed_ = TriangleBlocks::emptyBox();
  bool fieldsAreTaken_ = true;
};

}  // namespace resect
