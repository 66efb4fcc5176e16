// Blood on the table, which is covered with cloth. The blood forms puddles on a grid of square
// patches.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "blood/film/blood_volume.h"

namespace resect {

struct TablePatch {  // a square of the table with the side kTableCell
  std::int32_t number = 0;
  Picolitres volume = 0;

  template <class Visitor>
  void visit(Visitor& v) {
    v("number", number), v("volume", volume);
  }
};

inline constexpr double kTableCell = 0.005;  // m
inline constexpr int kTableCells = 200;      // patches along x and z; the origin is in the middle

class BloodTable {
 public:
  // Adds blood at a point in the world. Returns false, and adds nothing, if the point is not on the
  // table.
  bool add(const Vec3& place, Picolitres volume);
  // Computes a frame: the puddles level out, and deep puddles spread over dry cloth beside them.
  void step();
  // Takes blood from the patches whose middles are within `radius`, m, of a point in the world.
  // Takes at most the volume `most` in all. Returns the volume taken.
  Picolitres take(const Vec3& place, double radius, Picolitres most);

  Picolitres volume() const;
  const std::vector<TablePatch>& wet() const { return wet_; }  // ascending by number
  static bool has(std::int32_t number);       // whether there is a patch of that number
  static Vec3 middleOf(std::int32_t number);  // middle of the patch, world, m
  std::size_t bytes() const {
    return wet_.capacity() * sizeof(TablePatch) + 8 * volumes_.capacity();
  }

  template <class Visitor>
  void visit(Visitor& v) {
    v("wet", wet_);
  }
  void remake();  // to be called after a state was loaded into wet_

 private:
  void list();

  std::vector<TablePatch> wet_;      // state
  std::vector<Picolitres> volumes_;  // derived: volume per patch; empty until blood falls
};

}  // namespace resect
