// The surface of an organ, kept up to date with the organ's edits. The tracker also lists which
// ranges of the surface's arrays the last update changed.
//
// The method is incremental marching cubes (Lorensen and Cline 1987) over the bricks of a colour
// field, its blocks of 4 x 4 x 4 nodes. The wound is the set of all incisions of the organ. The
// mesh depends on the field, the iso level and the wound alone. So after any edits mesh() equals,
// bit for bit, the mesh that a rebuild from scratch gives. The mesh is closed and oriented
// outwards. The cost of an update depends on the number of touched bricks, not on the size of the
// organ.
//
// Incisions are meshed in the same bricks (wound/wound_brick.h). An incision removes nothing. Its
// two cut faces, the lips, coincide until the tissue moves. Bricks without cuts are meshed by
// marching cubes as usual.
//
// points(), normals(), cut() and triangles() are arrays for viewers. Each brick owns a range of the
// vertices and a range of the triangles. The sizes of ranges are rounded up
// (surface/range_allocator.h), so the arrays have unused elements ("holes"). A brick keeps its
// ranges as long as their rounded sizes stay the same. An unused triangle is (0, 0, 0). changes()
// lists the ranges that a viewer must copy again. The cut share of a vertex goes from 0 on the
// original surface to 1 on cut faces (isosurface/brick_look.h). Only pictures need normals and cut
// shares, so these are computed only when updateLook() is called.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "base/raw_array.h"
#include "collision/columns.h"
#include "geometry/triangle_mesh.h"
#include "isosurface/brick_mesher.h"
#include "isosurface/cell_triangles.h"
#include "sph/colour_field.h"
#include "surface/index_range.h"
#include "surface/range_allocator.h"
#include "wound/wound_brick.h"

namespace resect {

struct FieldAndSurface;

class SurfaceTracker {
 public:
  // Meshes the whole field. iso: in [kMinIso, kMaxIso]. wound: null for an organ without incisions.
  SurfaceTracker(const ColourField& field, float iso, const Wound* wound = nullptr);

  // Meshes some bricks again. touched: the bricks that field.update() returned.
  void update(const ColourField& field, std::span<const std::int64_t> touched);
  // As above, for an organ with incisions. severed: the bricks that wound.severed.update()
  // returned. After a call with a wound, all later calls need the wound too, until a state is
  // restored.
  void update(const ColourField& field, std::span<const std::int64_t> touched, const Wound& wound,
              std::span<const TouchedBrick> severed);
  // As above, after a state was restored: every brick near the wound, and near the wound that the
  // surface showed before, is meshed again. wound: null if the organ has no incisions now.
  void updateRestored(const ColourField& field, std::span<const std::int64_t> touched,
                      const Wound* wound);
  // Sets another iso level and meshes everything again.
  void setIso(const ColourField& field, float iso, const Wound* wound = nullptr);
  float iso() const { return iso_; }

  // Computes normals() and cut() for the bricks that were meshed since updateLook() was last
  // called.
  void updateLook(const ColourField& field);

  std::span<const Vec3f> points() const { return points_; }  // rest space, m
  // normals() and cut() throw Error if the surface has changed since the last updateLook().
  std::span<const Vec3f> normals() const;  // unit, outwards
  // The cut shares, 0 to 1; kRimShare where a cut meets the surface.
  std::span<const float> cut() const;
  std::span<const Triangle> triangles() const { return triangles_; }
  std::int64_t triangleCount() const { return triangleCount_; }  // holes not counted

  // Calls visit(first, bindings) for each brick near the wound. `first` is the index of the brick's
  // first vertex. `bindings` has, for each vertex of the brick in order, the particles with which
  // the vertex moves. A vertex of any other brick moves with all particles at the corners of the
  // lattice cube that contains the vertex (wound/vertex_binding.h).
  template <typename Visit>
  void visitBindings(Visit visit) const {
    for (const std::int32_t record : recordOf_)
      if (bricks_[std::size_t(record)].wound != kNone) {
        const BrickMesh& mesh = bricks_[std::size_t(record)];
        visit(mesh.firstVertex,
              std::span<const VertexBinding>(wounds_[std::size_t(mesh.wound)].bindings));
      }
  }

  // Calls visit(triangle) for each triangle of the bricks that meet the box. The box is in rest
  // space, m, and may be infinite.
  template <typename Visit>
  void visitTriangles(const ColourField& field, const Aabb& box, Visit visit) const {
    const IndexBox bricks = field.bricksIn(box);
    for (std::int32_t i = 0; i < std::int32_t(bricks.count()); ++i) {
      const BrickMesh& mesh = meshOf(field.brickIndex(bricks.coordinates(i)));
      for (std::int32_t t = 0; t < mesh.triangles; ++t)
        visit(triangles_[std::size_t(mesh.firstTriangle + t)]);
    }
  }

  // Calls visit(triangle, lip) for each triangle of a brick. lip: true for a triangle of a lip,
  // false for a triangle of the organ's outer surface.
  template <typename Visit>
  void visitBrick(std::int64_t brick, Visit visit) const {
    const BrickMesh& mesh = meshOf(brick);
    const Triangle* triangle = triangles_.data() + mesh.firstTriangle;
    if (mesh.wound == kNone) {
      for (std::int32_t t = 0; t < mesh.triangles; ++t) visit(triangle[t], false);
      return;
    }
    // The triangles of the wound come last (drawTriangles()).
    const auto& wound = wounds_[std::size_t(mesh.wound)].triangles;
    const std::int32_t plain = mesh.triangles - std::int32_t(wound.size());
    for (std::int32_t t = 0; t < mesh.triangles; ++t)
      visit(triangle[t], t >= plain && wound[std::size_t(t - plain)].lip);
  }

  // What the last call of an update function or of setIso() changed: some ranges of vertices and of
  // triangles, or everything.
  struct Changes {
    std::vector<IndexRange> vertices, triangles;
    std::int64_t bricks = 0;  // number of bricks that were meshed
    bool everything = false;  // true: the arrays were made anew; no ranges are listed
    // Number of the present version of the arrays, so that a viewer can tell whether its copy is
    // out of date. It grows by 1 with each update. When the arrays are made anew, it becomes a
    // number that no surface of this process had before.
    std::uint64_t number = 0;
  };
  const Changes& changes() const { return changes_; }

  // The surface without holes, in the order of the bricks. It depends on the present field, iso
  // level and wound alone, not on the history of edits.
  TriangleMesh mesh() const { return mesh(points_); }
  // The triangles of mesh() with other vertex positions. points: one position for each vertex of
  // the arrays, holes included.
  TriangleMesh mesh(std::span<const Vec3f> points) const;
  // mesh() together with the normal and the cut share of each point. updateLook() must have been
  // called after the last change of the surface.
  struct Compact {
    TriangleMesh mesh;
    std::vector<Vec3f> normals;
    std::vector<float> cut;
  };
  Compact compact() const { return compact(points_, normals()); }
  Compact compact(std::span<const Vec3f> points, std::span<const Vec3f> normals) const;
  // For each point of mesh(), a node of the grid that lies in the same piece of tissue.
  std::vector<Vec3i> anchorNodes(const ColourField& field) const;

  // A mesh in rest space with all triangles that the wanted columns of a grid can meet, at any
  // depth. Triangles elsewhere may be missing. wanted: one flag per column of the grid. The cost
  // depends on the number of bricks that the wanted columns pass through.
  TriangleMesh meshOver(const ColourField& field, const ColumnGrid& grid,
                        std::span<const std::uint8_t> wanted) const;

  std::size_t bytes() const;

 private:
  static constexpr std::int32_t kNone = -1;
  // The first two entries of bricks_ stand for all bricks without a mesh: entry kOutside for bricks
  // outside tissue, entry kInside for bricks inside tissue. So the mask of a neighbouring brick's
  // inside nodes can be read without a test whether that brick has a mesh.
  static constexpr std::int32_t kOutside = 0, kInside = 1, kFirstOwn = 2;
  struct BrickMesh {
    BrickSigns signs;
    std::int32_t firstVertex = 0, vertices = 0;
    std::int32_t firstTriangle = 0, triangles = 0;
    std::int16_t wholeTriangles = 0;  // number of triangles if no cell were cut
    bool drawAgain = false;           // whether the brick is listed in retriangulate_
    std::int32_t wound = kNone;       // index into wounds_
  };
  // A brick and its seven upper neighbours, numbered as in cornerMasks().
  struct Above {
    std::array<const BrickMesh*, 8> mesh;
    std::array<std::uint64_t, 8> inside;
  };

  bool hasMesh(std::int64_t brick) const { return recordOf_[std::size_t(brick)] >= kFirstOwn; }
  const BrickMesh& meshOf(std::int64_t brick) const {
    return bricks_[std::size_t(recordOf_[std::size_t(brick)])];
  }
  BrickMesh& meshOf(std::int64_t brick) {
    return bricks_[std::size_t(recordOf_[std::size_t(brick)])];
  }
  static std::int32_t recordWithoutMesh(std::int32_t slot) {
    return slot == ColourField::kFull ? kInside : kOutside;
  }
  friend FieldAndSurface buildFieldAndSurface(const Discretization&, int, float);
  SurfaceTracker() = default;
  // The stages of meshing the whole surface.
  void meshAll(const ColourField& field, const RangeBody* evaluate, const Wound* wound);
  RawArray<std::int32_t> numberRecords(const ColourField& field, const Wound* wound);
  void clear(const ColourField& field, std::size_t bricks);
  void tellInside(const ColourField& field, std::span<const std::int32_t> bricks, std::size_t begin,
                  std::size_t end);
  void placeAll(const ColourField& field, std::span<const std::int32_t> bricks, std::size_t begin,
                std::size_t end, std::vector<std::int32_t>& surfaced);
  // The stages of meshing some bricks again.
  void remesh(const ColourField& field, std::span<const std::int64_t> bricks, const Wound* wound);
  void findInside(const ColourField& field, std::span<const std::int64_t> bricks,
                  const Wound* wound);
  void findCrossings(const ColourField& field, std::span<const std::int64_t> bricks);
  bool findCrossings(const ColourField& field, std::int64_t brick);
  void meshWounds(const ColourField& field, const Wound& wound);
  void placeVertices(const ColourField& field, std::span<const std::int64_t> bricks);
  void writeVertices(const ColourField& field, const NodeGrid& grid, std::int64_t brick);
  void requireLook() const;
  void lookIsDue(std::span<const std::int64_t> bricks);
  void writeLook(const ColourField& field, const NodeGrid& grid, std::int64_t brick);
  // Calls visit(vertex, twin) for each vertex in the order of mesh(). twin: whether the vertex is
  // the twin of the previous vertex, at the same position.
  template <typename Visit>
  void visitVertices(Visit visit) const;
  void placeTriangles(const ColourField& field);
  std::int32_t vertexCountOf(const BrickMesh& mesh) const;
  std::int32_t triangleCountOf(const ColourField& field, std::int64_t brick) const;

  void takeRecord(std::int64_t brick);
  void takeWound(BrickMesh& mesh);
  void dropWound(BrickMesh& mesh);
  bool looksFar(std::int64_t brick) const {
    const std::int32_t wound = meshOf(brick).wound;
    return wound == kNone || wounds_[std::size_t(wound)].looksFar;
  }
  void dropRecord(std::int64_t brick);
  Above above(const ColourField& field, std::int64_t brick) const;
  void drawTriangles(const ColourField& field, std::int64_t brick);
  void drawWound(const Above& around, const BrickWound& wound, const EdgeTable& table,
                 Triangle* out) const;
  std::uint64_t woundCells(const BrickMesh& mesh) const {
    return mesh.wound == kNone ? 0 : wounds_[std::size_t(mesh.wound)].cells;
  }

  float iso_ = 50;
  // Per brick: index into bricks_. Some further entries follow, so that the entry of a brick above
  // the last one can be read too.
  RawArray<std::int32_t> recordOf_;
  std::vector<BrickMesh> bricks_;
  std::vector<std::int32_t> freeRecords_;
  std::vector<BrickWound> wounds_;
  std::vector<std::int32_t> freeWounds_;
  RangeAllocator vertexSpace_, triangleSpace_;
  RawArray<Vec3f> points_, normals_;
  RawArray<float> cut_;
  RawArray<std::uint8_t> edges_;  // per marching cubes vertex: its edge (CrossedEdges)
  RawArray<Triangle> triangles_;
  std::int64_t triangleCount_ = 0;
  Changes changes_;
  std::vector<std::int64_t> lookDue_;  // bricks meshed since the last updateLook()
  bool allLookDue_ = true;             // true: all bricks are due, and lookDue_ is empty
  // Work lists, kept so that a steady update allocates nothing.
  std::vector<std::uint64_t> newInside_;
  std::vector<std::uint8_t> renumbered_;
  std::vector<std::int64_t> retriangulate_, withWound_, woundBricks_;
};

// Builds field and surface together. The result has the same bits as if field and surface were
// built one after the other. Building them together is faster, since bricks are meshed while their
// nodes are still in the cache. refine: as for ColourField. iso: as for SurfaceTracker.
struct FieldAndSurface {
  ColourField field;
  SurfaceTracker surface;
};
FieldAndSurface buildFieldAndSurface(const Discretization& cells, int refine, float iso);

}  // namespace resect
