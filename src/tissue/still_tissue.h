// Tissue that never moves, as in the program of the diploma thesis that Resect continues. Still
// tissue takes one byte of memory per cell.
//
// The same edits as in moving tissue are possible: cells can be removed, bonds can be severed, and
// tools can grip cells. A cutting edge meets no resistance: it cuts wherever it passes.
#pragma once

#include "sph/lattice.h"
#include "tissue/tissue_model.h"

namespace resect {

class StillTissue : public TissueModel {
 public:
  // solid: one flag per cell of the lattice, 1 where there is tissue. Throws Error if the number of
  // flags is not the number of cells.
  StillTissue(const Lattice& lattice, std::vector<std::uint8_t> solid);

  bool moves() const override { return false; }
  void beginFrame(double, std::span<const Obstacle> obstacles) override { obstacles_ = obstacles; }
  int substepsWanted() const override { return 0; }
  bool substep(int, int) override { return true; }
  bool startAgain(bool) override { return true; }
  void endFrame(TissueStep& step) override;
  void pull(std::int64_t, const Vec3&) override {}
  void mayPull(std::int64_t) override {}

  void remove(std::int64_t cell) override;
  void sever(std::int64_t cell, int direction) override;
  void grip(std::int64_t cell, std::int32_t tool, const Pose&) override;
  void release(std::int32_t tool) override;
  void settle() override {}
  const TissueMaterial* material(std::int64_t) const override { return nullptr; }
  void setMaterial(std::int64_t, const TissueMaterial&) override {}
  std::int32_t gripped(std::int32_t tool) const override;

  bool solid(std::int64_t cell) const override { return solid_[std::size_t(cell)] != 0; }
  std::uint32_t bonds(std::int64_t cell) const override;
  Vec3 displacement(std::int64_t) const override { return Vec3::Zero(); }
  Vec3 velocity(std::int64_t) const override { return Vec3::Zero(); }
  double mass(std::int64_t) const override { return 0; }
  std::vector<std::int64_t> cellsIn(const Aabb& box) const override;
  Mat3 deformation(std::int64_t) const override { return Mat3::Identity(); }
  void place(std::span<const std::int64_t>, std::span<CellPlacement> places) const override {
    for (CellPlacement& p : places) p = {Vec3f::Zero(), Eigen::Matrix3f::Zero()};
  }

  void visit(StateVisitor& visitor) override;
  void visitMade(StateVisitor& visitor) override;
  void beginRestore() override {}
  void endRestore(std::span<const std::uint8_t> alive) override;

 private:
  struct Severed {
    std::int64_t cell = 0;
    std::uint32_t directions = 0;  // bit d: the bond in direction d is severed

    template <class Visitor>
    void visit(Visitor& v) {
      v("cell", cell), v("directions", directions);
    }
  };
  struct Held {
    std::int64_t cell = 0;
    std::int32_t tool = 0;

    template <class Visitor>
    void visit(Visitor& v) {
      v("cell", cell), v("tool", tool);
    }
  };
  std::uint32_t& severedAt(std::int64_t cell);

  // State.
  std::vector<Severed> severed_;  // ascending by cell
  std::vector<Held> held_;

  // Set up once, or copied from the organ.
  std::vector<std::uint8_t> solid_;
  Lattice lattice_;
  std::span<const Obstacle> obstacles_;  // of this frame
};

}  // namespace resect
