// Tissue that never moves: what the original system had. It costs nothing.
#pragma once

#include "tissue/tissue_model.h"

namespace resect {

class StillTissue : public TissueModel {
 public:
  bool moves() const override { return false; }
  void move(double, const TissueSurroundings&, TissueStep&) override {}
  void remove(std::int64_t) override {}
  void sever(std::int64_t, int) override {}
  void grip(std::int64_t, std::int32_t, const Pose&) override {}
  void release(std::int32_t) override {}
  std::int32_t gripped(std::int32_t) const override { return 0; }
  bool solid(std::int64_t) const override { return true; }
  std::uint32_t bonds(std::int64_t) const override { return 0; }
  Vec3 displacement(std::int64_t) const override { return Vec3::Zero(); }
  std::vector<std::int64_t> cellsIn(const Aabb&) const override { return {}; }
  Mat3 deformation(std::int64_t) const override { return Mat3::Identity(); }
  void place(std::span<const std::int64_t>, std::span<CellPlacement> places) const override {
    for (CellPlacement& p : places) p = {Vec3f::Zero(), Eigen::Matrix3f::Zero()};
  }
  std::uint64_t stateHash() const override { return 0; }
  std::size_t bytes() const override { return 0; }
};

}  // namespace resect
