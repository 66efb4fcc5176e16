// The points at which elastic tissue touches obstacles.
//
// Points are given by their positions at rest, on the surface of the tissue. Each point stands for
// a patch of the surface. The patches come from setSurface(). Removing cells and severing bonds
// bares faces of cells. Parts of the bared faces are patches too. If setSurface() was not called,
// the patches are parts of all cell faces without a neighbouring cell.
//
// A point belongs to a cell. The point follows the weighted mean of this cell and of the neighbours
// that are bonded to this cell. The weights are those of quadratic splines. With these weights, a
// force is spread equally far wherever the point lies in its cell. So tissue yields equally
// everywhere, although its cells are large.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "tissue/elastic/elastic_state.h"
#include "tissue/tissue_model.h"

namespace resect {

struct ContactPoint {
  Vec3f offset;  // rest position relative to the centre of the point's cell, m
  Vec3f normal;  // normal of the surface at rest, unit, outwards
  float area;    // area of its patch, m^2
};

// Cells are given by their index in the CellBox.
class ContactPoints {
 public:
  // As TissueModel::setSurface(). Patches of cells that are not solid are left out.
  void setSurface(const ElasticState& state, const Lattice& lattice,
                  std::span<const SurfacePatch> patches);

  // Appends the points of a cell. lips: whether to include points on the faces that cuts have
  // bared.
  void fine(const ElasticState& state, std::int32_t cell, bool lips,
            std::vector<ContactPoint>& points) const;
  // As fine(), but with fewer points: one point for each face that the removal of a cell has bared,
  // and one point for all patches of setSurface() together. Faces that cuts have bared get no
  // points.
  void coarse(const ElasticState& state, std::int32_t cell,
              std::vector<ContactPoint>& points) const;
  // Calls visit(const ContactPoint&) for the patches of setSurface() that belong to the cell.
  template <typename Visit>
  void visitPatches(std::int32_t cell, Visit visit) const {
    for (const Owned& one : patchesOf(cell)) visit(one.point);
  }
  std::size_t bytes() const {  // memory held
    return told_.capacity() * sizeof(Owned) + first_.capacity() * sizeof(std::int32_t);
  }

 private:
  struct Owned {
    std::int32_t cell;
    ContactPoint point;
  };
  std::span<const Owned> patchesOf(std::int32_t cell) const;
  void addFaces(const ElasticState& state, std::int32_t cell, int across, bool lips,
                std::vector<ContactPoint>& points) const;

  std::vector<Owned> told_;  // the patches of setSurface(), ascending by cell
  // Per cell of the box: index in told_ of the cell's first patch. If the cell has no patch:
  // kInside if the cell was solid before any cell was removed, else kOutside. Empty if setSurface()
  // was not called.
  static constexpr std::int32_t kInside = -1, kOutside = -2;
  std::vector<std::int32_t> first_;
};

// The weights of a point's cell and of its neighbours. The weights add up to 1.
struct PointWeights {
  std::int32_t count = 0;
  std::array<std::int32_t, kDirections + 1> cell;
  std::array<float, kDirections + 1> weight;
  Vec3f mean;  // weighted mean of the cells' rest positions, relative to the point's cell, m
};
PointWeights weightsAt(const ElasticState& state, std::int32_t cell, const Vec3f& offset);

}  // namespace resect
