// How does the ever-changing surface of an organ reach the graphics card at the cost of its changes
// only?
//
// A shape with vertex buffers of its own. A program hands its geometry to setGeometry() and
// updateRange(), and the next rendering uploads the changed ranges to each context that draws the
// shape; of these triangles it draws those blocks that can lie in the part of the picture that is
// drawn (the scissor box). The field `revision` counts changes and notifies the scene. In an .iv
// file, and from an engine, the surface comes through fields, whole each time: see
// inventor/SoMarchingCubes.h.
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
#include <span>
#include <vector>

#include "base/vec.h"
#include "geometry/aabb.h"
#include "geometry/triangle_mesh.h"
#include "inventor/per_context.h"
#include "inventor/triangle_blocks.h"

namespace resect {

// One surface, or one range of it. All per-vertex spans have the length of `points`, except `rest`,
// which may be empty: then the rest position is the position.
struct OrganGeometry {
  std::span<const Vec3f> points;        // m
  std::span<const Vec3f> normals;       // unit, outwards
  std::span<const float> cut;           // 0 = capsule, 1 = cut parenchyma
  std::span<const Triangle> triangles;  // indices into the whole shape's points; {0,0,0} = a hole
  std::span<const Vec3f> rest;          // m
};

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

  // Number of changes so far. Written by the functions below.
  SoSFInt32 revision;

  // Replaces everything.
  void setGeometry(const OrganGeometry& geometry);

  // Overwrites vertices [firstVertex, +points.size()) and triangles [firstTriangle,
  // +triangles.size()); either may be empty. Ranges may reach beyond the present end: the shape
  // grows, and what lies between is holes.
  void updateRange(int firstVertex, int firstTriangle, const OrganGeometry& geometry);

  int vertexCount() const { return int(points_.size()); }
  int triangleCount() const { return int(triangles_.size()); }  // holes included

  // Where the surface has become another since the last call: before and after. m, object space.
  Aabb takeChanged();

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

  void takeFields();
  void growChanged(Range vertices, Range triangles);
  std::vector<TriangleBlocks::Run> seen(SoState* state);
  void upload(ContextBuffers& buffers);

  std::vector<Vec3f> points_, normals_, rest_;
  std::vector<float> cut_;
  std::vector<Triangle> triangles_;
  PerContext<ContextBuffers> contexts_;
  std::uint64_t uploadedBytes_ = 0, uploadedVertices_ = 0;
  std::int64_t drawnTriangles_ = 0;
  TriangleBlocks blocks_;
  TriangleBlocks::Box changed_ = TriangleBlocks::emptyBox();
  bool fieldsAreTaken_ = true;
};

}  // namespace resect
