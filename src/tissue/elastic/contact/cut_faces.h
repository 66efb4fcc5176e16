// Keeps the two faces of a cut from passing through each other. A cut severs bonds, each of which
// connected two neighbouring cells. The two cells at the ends of each cut bond are pushed apart
// like inelastic balls.
#pragma once

#include <vector>

#include "tissue/elastic/elastic_state.h"

namespace resect {

// Cells are given by their index in the CellBox.
class CutFaces {
 public:
  // Call when the bond from `cell` in `direction` is cut. From then on, the two cells at the ends
  // of the bond are pushed apart when their distance is less than a minimum. The minimum is nine
  // tenths of their rest distance, or their distance at the time of the cut if this distance is
  // smaller.
  void keepApart(const ElasticState& state, std::int32_t cell, int direction);
  // Forgets all cut bonds that end at the cell.
  void forgetCell(std::int32_t cell);
  // Whether the ends of all cut bonds are valid indices in a box of `cells` cells.
  bool fit(std::int32_t cells) const;

  // Pushes the ends of cut bonds apart. Call after each substep. lookAhead:
  // SubstepConstants::lookAhead.
  void push(ElasticState& state, double lookAhead) const;

  template <class Visitor>
  void visit(Visitor& v) {
    v("cut", cut_);
  }

 private:
  // The two ends of a cut bond.
  struct CutPair {
    std::int32_t a = 0, b = 0;
    float distance = 0;          // minimum distance, see keepApart(), m
    Vec3f rest = Vec3f::Zero();  // from a to b at rest, m

    template <class Visitor>
    void visit(Visitor& v) {
      v("a", a), v("b", b), v("distance", distance), v("rest", rest);
    }
  };
  std::vector<CutPair> cut_;
};

}  // namespace resect
