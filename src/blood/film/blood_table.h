// Blood on the table: a puddle on a grid.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "blood/film/blood_volume.h"

namespace resect {

struct TablePatch {  // of the table, kTableCell wide
  std::int32_t number = 0;
  Picolitres volume = 0;

  template <class Visitor>
  void visit(Visitor& v) {
    v("number", number), v("volume", volume);
  }
};

inline constexpr double kTableCell = 0.005;  // m
inline constexpr int kTableCells = 200;      // along x and z; the table's middle is the origin

class BloodTable {
 public:
  // False if the place is beside the table: then nothing is added.
  bool add(const Vec3& place, Picolitres volume);
  // A frame: puddles level, and spread over dry cloth where they are deep enough.
  void step();
  // Takes blood within `radius`, m, of a place in the world, at most `most`. Returns what it took.
  Picolitres take(const Vec3& place, double radius, Picolitres most);

  Picolitres volume() const;
  const std::vector<TablePatch>& wet() const { return wet_; }  // ascending by number
  static bool has(std::int32_t number);       // whether there is a patch of that number
  static Vec3 middleOf(std::int32_t number);  // of a patch, m
  std::size_t bytes() const {
    return wet_.capacity() * sizeof(TablePatch) + 8 * volumes_.capacity();
  }

  template <class Visitor>
  void visit(Visitor& v) {
    v("wet", wet_);
  }
  void remake();  // after wet_ was loaded

 private:
  void list();

  std::vector<TablePatch> wet_;      // state
  std::vector<Picolitres> volumes_;  // derived: by number; empty until blood falls
};

}  // namespace resect
