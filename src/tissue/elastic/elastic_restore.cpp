// Saving and restoring elastic tissue.
#include <algorithm>
#include <bit>

#include "base/error.h"
#include "tissue/elastic/capsule.h"
#include "tissue/elastic/elastic_setup.h"
#include "tissue/elastic/elastic_tissue.h"

namespace resect {

void ElasticTissue::visit(StateVisitor& v) {
  state_.visit(v);
  v("fineness", fineness_), v("halvings", halvings_), v("calmFrames", calmFrames_);
  v("contacts", cutFaces_), v("fronts", fronts_), v("springs", springs_), v("fibres", fibres_);
  v("cut", cut_), v("pulled", pulled_), v("sinceTear", sinceTear_);
}

void ElasticTissue::visitMade(StateVisitor& v) {
  state_.visitMade(v);
  contacts_.visitMade(v);
  springs_.visitMade(v);
  fronts_.visitMade(v);
  v.made(lattice_, settings_, kernel_, longestSubstep_, uneven_, cords_, gripper_);
  v.made(bondsChanged_, holdsChanged_, frame_, holdsMove_, before_, kept_);
}

void ElasticTissue::beginRestore() {
  // After a state that did not fit, the derived data still belong to the cells kept before it.
  if (!before_.solid.empty()) return;
  settle();
  holdsMove_.reset();
  contacts_.forgetObstacles();
  before_ = {state_.solid,       state_.material, state_.held,     state_.loaded,
             state_.capsuleTorn, state_.bonds,    state_.materials};
}

// The numbers come from outside: everything used as an index is checked.
void ElasticTissue::checkRestored() const {
  const ElasticState& s = state_;
  const auto cells = std::size_t(s.box.size);
  const auto sized = [&](const auto& array) { return array.size() == cells; };
  const auto inBox = [&](std::int32_t i) { return s.box.inLattice(i); };
  bool fits = sized(s.solid) && sized(s.material) && sized(s.bonds) && sized(s.held) &&
              sized(s.loaded) && sized(s.capsuleTorn);
  for (int a = 0; a < 3 && fits; ++a) fits = sized(s.u[a]) && sized(s.v[a]) && sized(s.load[a]);
  std::size_t most = 0;
  for (const TissueMaterial& m : s.materials) most = std::max(most, m.branches.size());
  fits = fits && most <= kMostBranches;
  for (std::size_t k = 0; k < kMostBranches && fits; ++k)
    for (const FloatArray& component : s.relaxed[k])
      fits = fits && component.size() == (k < most ? cells : 0);
  if (fits) {
    for (std::int32_t i = 0; i < s.box.size && fits; ++i) {
      if (!s.solid[i]) {
        fits = s.bonds[i] == 0 && s.held[i] == 0 && s.loaded[i] == 0 && s.capsuleTorn[i] == 0 &&
               (s.material[i] == 0 || s.box.inLattice(i));
        continue;
      }
      fits = s.solid[i] == 1 && s.material[i] < s.materials.size() && s.box.inLattice(i) &&
             (!s.owner[i] || isParticle(s, ownerOf(s, i))) && s.held[i] <= kHeldAll &&
             s.loaded[i] <= 1 && s.capsuleTorn[i] <= 1;
      for (std::uint32_t bonds = s.bonds[i]; bonds != 0 && fits; bonds &= bonds - 1) {
        const int d = std::countr_zero(bonds);
        fits = d < kDirections && s.solid[i + s.box.step[d]];
      }
    }
  }
  for (const TissueSpring& spring : springs_.all()) fits = fits && inBox(spring.cell);
  for (const Fibre& fibre : fibres_) fits = fits && inBox(fibre.a) && inBox(fibre.b);
  for (const auto* list : {&cut_, &pulled_})
    for (const std::int32_t i : *list) fits = fits && inBox(i);
  fits = fits && cutFaces_.fit(s.box.size) && fronts_.fit() && halvings_ >= 0 &&
         halvings_ <= kMostHalvings && fineness_ >= 0 && fineness_ <= kMostFineness &&
         sinceTear_ >= 0;
  if (!fits)
    throw error(
        "the state does not fit the organ's tissue; restore it into the operation that it "
        "was saved from");
}

void ElasticTissue::endRestore(std::span<const std::uint8_t>) {
  checkRestored();
  for (const TissueMaterial& material : state_.materials) checkMaterial(material);
  chooseSubstep();
  const auto sameMaterial = [&](std::int32_t i) {
    return !state_.solid[i] || !before_.solid[i] ||
           before_.materials[before_.material[i]] == state_.materials[state_.material[i]];
  };
  std::vector<std::int32_t> changed, held;
  for (std::int32_t i = 0; i < state_.box.size; ++i) {
    const bool same = sameMaterial(i);
    if (!same || before_.solid[i] != state_.solid[i] || before_.material[i] != state_.material[i] ||
        before_.bonds[i] != state_.bonds[i] || before_.capsuleTorn[i] != state_.capsuleTorn[i])
      changed.push_back(i);
    if (!same)  // a cell's gradient depends on what it is bonded to
      for (int d = 0; d < kDirections; ++d)
        if (state_.bonds[i] >> d & 1) changed.push_back(i + state_.box.step[d]);
    if (before_.held[i] != state_.held[i] || before_.loaded[i] != state_.loaded[i])
      held.push_back(i);
  }
  before_ = {};
  allocateBranches(state_);
  remakeCells(state_, changed);
  refreshCells(state_, changed);
  remakeCapsule(state_, changed);
  retractCapsule(state_, changed);
  refreshChunks(state_, held);
  fibres_ = findFibres(state_, fibres_);
  uneven_ = findUnevenBonds(state_);
  std::ranges::fill(gripper_, -1);
  for (const TissueSpring& spring : springs_.all())
    if (spring.tool >= 0) gripper_[spring.cell] = spring.tool;
  bondsChanged_.clear();
  holdsChanged_.clear();
}

}  // namespace resect
