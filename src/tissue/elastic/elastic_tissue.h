// Elastic tissue: explicit total-Lagrangian SPH on the organ's lattice.
//
// docs/methods/tissue.md derives the method. A frame is divided into substeps. A substep is shorter
// than the time in which a pressure wave passes from one cell to the next. Cost: two passes over
// the solid cells per substep. The results have the same bits at any number of threads and with any
// instruction set. `cell` is always the index of a cell in the lattice.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "tissue/attachment.h"
#include "tissue/elastic/boundary_cells.h"
#include "tissue/elastic/contact/contact.h"
#include "tissue/elastic/contact/cut_faces.h"
#include "tissue/elastic/cutting/cut_front.h"
#include "tissue/elastic/elastic_state.h"
#include "tissue/elastic/fibres.h"
#include "tissue/elastic/kernel/elastic_kernel.h"
#include "tissue/elastic/springs.h"
#include "tissue/elastic/uneven_cells.h"
#include "tissue/material.h"
#include "tissue/tissue_model.h"

namespace resect {

// How many times the substep may be halved. Tissue "explodes" when its time integration becomes
// unstable. Tissue that still explodes with the shortest substep is stopped.
inline constexpr int kMostHalvings = 6;
// How many times the substep may be divided by 1.26 because of stiff cells (StiffCells in
// kernel/elastic_kernel.h).
inline constexpr int kMostFineness = 3;

struct TissueSettings {
  Vec3 gravity = Vec3(0, -9.81, 0);  // m/s^2
  // Forces are evaluated at extrapolated positions. `damping` is the time of extrapolation as a
  // fraction of a substep, from 0 to 0.5. With 0, energy is conserved. With 0.5, the fastest waves
  // are damped most and slow motion hardly at all. Values above 0.5 would be unstable.
  double damping = 0.1;
  // Rate at which velocities decay by friction of the surroundings, 1/s; 0: no friction.
  double drag = 0;
  // Stiffness of the bonds against zero-energy modes, as a multiple of the shear modulus: alpha in
  // docs/methods/tissue.md. A zero-energy mode is a motion that does not change the cells'
  // gradients. Range: above 0, up to 3. With 1.55 the second-order error of bending and torsion
  // vanishes. With smaller values, tissue is too soft and its lattice wrinkles. With larger values,
  // tissue is too stiff.
  double penalty = 1.55;
  // Longest substep, as a fraction of the time in which a pressure wave passes from one cell to the
  // next. Range: above 0, up to 1. Beyond 0.5, tissue that is sheared or stretched as a whole may
  // become unstable (docs/methods/tissue.md).
  double stepShare = 0.5;
  // Greatest number of threads for the two passes; 0: all threads that the program may use. If
  // there are fewer idle cores than threads, the passes are slower than with one thread.
  int threads = 1;
  // false: the faces of cuts pass through each other. For measurements of what their contact takes.
  // Not kept in recordings.
  bool facesTouch = true;

  template <class Visitor>
  void visit(Visitor& v) {
    v("gravity", gravity), v("damping", damping), v("drag", drag), v("penalty", penalty);
    v("stepShare", stepShare), v("threads", threads);
  }
};

struct TissueEnergy {
  double kinetic = 0, elastic = 0, gravity = 0;  // J; `gravity`: relative to the rest position
  double total() const { return kinetic + elastic + gravity; }
};

class ElasticTissue final : public TissueModel {
 public:
  // Throws Error if the lattice's cells are not cubes, if a setting is out of range, or if no cell
  // is solid.
  ElasticTissue(const TissueCells& cells, const TissueSettings& settings);

  // Attaches the solid cells of the region by a pin or a ligament, as TissueAttachment::Kind says.
  // Returns the number of cells attached.
  std::int64_t attach(const TissueAttachment& attachment);

  struct Advance {  // as in TissueStep
    int substeps = 0;
    int retries = 0;
    bool calm = true;
  };
  // Computes a frame of `duration`, s, without obstacles and without tearing.
  Advance advance(double duration);

  void setSurface(std::span<const SurfacePatch> patches) override;
  void setCords(std::span<const TissueCord> cords) override;
  void moveHolds(const BreathMotion& motion) override { holdsMove_ = motion; }
  // The computation of a frame, as in tissue/tissue_model.h. If the tissue explodes, it is restored
  // to the beginning of the frame, and the frame is repeated with substeps of half the length.
  void beginFrame(double duration, std::span<const Obstacle> obstacles) override;
  int substepsWanted() const override;
  bool substep(int number, int count) override;
  bool startAgain(bool exploded) override;
  void endFrame(TissueStep& step) override;
  void touchOf(std::int32_t tool, TissueTouch& touch) const override;
  void pull(std::int64_t cell, const Vec3& force) override;
  void mayPull(std::int64_t cell) override;

  void sever(std::int64_t cell, int direction) override;
  void remove(std::int64_t cell) override;
  void grip(std::int64_t cell, std::int32_t tool, const Pose& pose) override;
  void release(std::int32_t tool) override;
  void settle() override;
  std::int32_t gripped(std::int32_t tool) const override;
  const TissueMaterial* material(std::int64_t cell) const override;
  void setMaterial(std::int64_t cell, const TissueMaterial& material) override;
  // Prescribes the velocity of the cell, m/s, along some axes. axes: bits of HeldAxis. If `axes` is
  // 0, the cell is released. moveHolds() replaces the prescribed velocities of all held cells.
  void hold(std::int64_t cell, int axes, const Vec3& velocity = Vec3::Zero());
  // Sets the external force on the cell, N. The force acts until it is set again.
  void setLoad(std::int64_t cell, const Vec3& force);
  void setDisplacement(std::int64_t cell, const Vec3& u);
  void setVelocity(std::int64_t cell, const Vec3& v);

  bool moves() const override { return true; }
  Vec3 displacement(std::int64_t cell) const override;
  std::vector<std::int64_t> cellsIn(const Aabb& box) const override;
  Vec3 velocity(std::int64_t cell) const override;
  // Boundary cells (boundary_cells.h) are not told: for them solid() is false and bonds() is 0.
  bool solid(std::int64_t cell) const override {
    return isParticle(state_, state_.box.fromLattice(cell));
  }
  std::uint32_t bonds(std::int64_t cell) const override {
    return particleBonds(state_, state_.box.fromLattice(cell));
  }
  double mass(std::int64_t cell) const override;       // kg
  Mat3 deformation(std::int64_t cell) const override;  // F; identity for a cell without F
  Mat3 stress(std::int64_t cell) const;                // first Piola-Kirchhoff stress, Pa
  Vec3 elasticForce(std::int64_t cell) const;          // as the last stress pass computed it, N
  TissueEnergy energy();
  // The cutting edges that are near tissue, and the work of all edges in the last frame.
  std::span<const CutFront> fronts() const { return fronts_.fronts(); }
  CutWork cutWork() const { return fronts_.work(); }
  void place(std::span<const std::int64_t> cells, std::span<CellPlacement> places) const override;
  void visit(StateVisitor& visitor) override;
  void visitMade(StateVisitor& visitor) override;
  void beginRestore() override;
  void endRestore(std::span<const std::uint8_t> alive) override;
  double longestSubstep() const { return longestSubstep_; }  // s, not shortened for stiff cells
  double presentSubstep() const;                             // the longest substep at present, s

  const Lattice& lattice() const { return lattice_; }
  const TissueSettings& settings() const { return settings_; }
  const ElasticState& state() const { return state_; }
  void useKernel(const ElasticKernel& kernel) { kernel_ = &kernel; }

  // Computes the forces at the present displacements without moving any cell. elasticForce() then
  // returns these forces.
  void evaluateForces();
  // Sets all velocities to 0, except the prescribed velocities of held cells.
  void stopMotion();

 private:
  // Data of a frame between beginFrame() and endFrame().
  struct Frame {
    double duration = 0;
    std::span<const Obstacle> obstacles;
    SubstepConstants constants;
    StiffCells stiff;  // result of the last count of stiff cells
    std::int32_t substeps = 0, retries = 0;
    bool calm = true;
  };
  // Copies of arrays of the state from before a restore. They show which cells the restore changed.
  struct Before {
    AlignedArray<std::uint8_t> solid, material, held, loaded, capsuleTorn;
    AlignedArray<std::uint32_t> bonds;
    std::vector<TissueMaterial> materials;
  };

  std::int64_t pin(const TissueAttachment& region);
  void tie(std::int64_t cell, double stiffness, double damping);
  void removeOne(std::int32_t cell);
  void loosen(std::span<const std::int32_t> cells);
  void findTears(std::span<const std::int32_t> letGo, std::vector<TissueBond>& torn);
  void forChunks(const RangeBody& pass) const;
  StiffCells stressPass(const SubstepConstants& constants);
  bool motionPass(const SubstepConstants& constants);
  SubstepConstants constants(double dt) const;
  void chooseSubstep();
  void chooseFineness();
  void lookAhead(float time);
  void clearPulls();
  void carryHeld(double before, double after, double dt);
  RestTissue rest() const { return {state_, lattice_, contacts_.points()}; }
  void limitCords();
  void keepState();
  void restoreState();
  void checkRestored() const;

  // State.
  ElasticState state_;
  int fineness_ = 0;    // for stiff cells: how many times substeps are divided by kFinerBy
  int halvings_ = 0;    // how many times the substep is halved at present
  int calmFrames_ = 0;  // number of calm frames since `halvings_` last changed
  CutFaces cutFaces_;
  CutFronts fronts_;
  TissueSprings springs_;
  std::vector<Fibre> fibres_;
  std::vector<std::int32_t> cut_;     // indices of both cells of each severed bond
  std::vector<std::int32_t> pulled_;  // cells that joints may pull, ascending
  // Time that cracks may still use to advance, s; at most the time in which a crack advances by two
  // cells.
  double sinceTear_ = 0;

  // Data that are set up once, and derived data.
  Lattice lattice_;
  TissueSettings settings_;
  const ElasticKernel* kernel_;
  double longestSubstep_ = 0;
  std::vector<UnevenBond> uneven_;
  std::vector<Cord> cords_;
  std::vector<std::int32_t> gripper_;  // per cell of state_.box: number of its tool, or -1
  std::vector<std::int32_t> bondsChanged_, holdsChanged_;  // cells that settle() will update
  TissueContacts contacts_;
  Frame frame_;
  std::optional<BreathMotion> holdsMove_;  // motion of attachments in this frame, if they move
  Before before_;
  FloatArray kept_;  // u, v and the branches of all chunks at the beginning of the frame
};

}  // namespace resect
