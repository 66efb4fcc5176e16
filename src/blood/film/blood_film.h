// Blood as a film on the skin of one organ.
//
// The skin consists of all free surfaces of the tissue, including those in a wound. It is divided
// into skin cells (blood/film/skin_cells.h). The volume of blood on each skin cell is a whole
// number of picolitres. In each frame the wet cells are visited from the highest to the lowest.
// From each cell, blood flows to the lower neighbours as a film flows down a slope. The flow per
// unit of width is q = rho g h^3 sin(slope) / (3 mu), with the film's thickness h, the density rho
// and the viscosity mu of blood, and gravity g. The flow out of a cell is computed implicitly. One
// pass over all wet cells is a time step of the kinematic wave equation. Dry skin is wetted only by
// a film thicker than a threshold, so blood runs in rivulets. Where a cell has no lower neighbour,
// blood gathers in level ponds. Under an overhang blood hangs until it drips.
#pragma once

#include <cstdint>
#include <vector>

#include "blood/film/blood_volume.h"
#include "blood/film/skin_cells.h"

namespace resect {

// Blood on one skin cell.
struct WetCell {
  std::int64_t cell = -1;
  Picolitres liquid = 0, clotted = 0;

  template <class Visitor>
  void visit(Visitor& v) {
    v("cell", cell), v("liquid", liquid), v("clotted", clotted);
  }
};

struct BloodDrop {
  Vec3 place = Vec3::Zero(), velocity = Vec3::Zero();  // world; m, m/s
  Picolitres volume = 0;

  template <class Visitor>
  void visit(Visitor& v) {
    v("place", place), v("velocity", velocity), v("volume", volume);
  }
};

// The volumes of all blood in a film.
struct FilmVolumes {
  Picolitres liquid = 0, clotted = 0;
};

class BloodFilm {
 public:
  // Finds the organ's skin. Call it once, and again after a saved state of the organ was restored.
  void setUp(const OperatedOrgan& organ);
  // Updates the skin near `cells`: the cells at which cuts, tears or the removal of tissue may have
  // changed the skin. If a cell no longer has skin, its blood goes to the lowest skin cell beside
  // it. If there is no skin cell beside it, the blood falls as a drop, which is appended to
  // `drops`. Appends to `opened` the faces that have become free.
  void renew(const OperatedOrgan& organ, std::span<const std::int64_t> cells,
             std::vector<BloodDrop>& drops, std::vector<OpenedFaces>& opened);
  bool ready() const { return !skin_.empty(); }

  // Computes the present position and normal of the skin at the wet cells and at the cells beside
  // them. Call it once per frame, after the tissue has moved.
  void place(const OperatedOrgan& organ);
  // Computes the flow in a frame that lasts `duration`, s. Appends to `drops` the blood that drips.
  // table: whether there is a table. Where skin touches the table, blood runs onto the table. This
  // blood is appended to `drops`, too, at height 0.
  void step(double duration, bool table, std::vector<BloodDrop>& drops);

  // Call this at the end of a frame. It writes the wet cells to wet(). Saved states contain wet().
  void collect();

  void add(std::int64_t cell, Picolitres volume);
  // Takes liquid blood from the wet cells within `radius`, m, of a point in the world: at most
  // `most` in all, and the same fraction of the blood of each cell. Returns the volume taken.
  Picolitres take(const Vec3& place, double radius, Picolitres most);

  // The skin cell nearest to a point in rest space (the coordinates of the undeformed organ, m).
  // Cells up to three cells away along each axis are considered. -1 if there is no skin cell there.
  // beside: the preferred direction from the point; zero if no direction is preferred. If the
  // direction to a cell's centre is more than 90 degrees from `beside`, the cell counts as one
  // spacing farther away.
  std::int64_t skinNear(const Vec3& rest, const Vec3& beside) const;
  // The present position (world, m) and the normal of the skin at a cell, which must be a skin
  // cell.
  struct SkinPlace {
    Vec3 place, normal;
  };
  SkinPlace placeOf(const OperatedOrgan& organ, std::int64_t cell) const;

  FilmVolumes volumes() const;
  const std::vector<WetCell>& wet() const { return wet_; }  // ascending by cell
  // The volumes of blood on the cell with this number in skin().
  Picolitres liquidAt(std::int32_t number) const { return liquid_[std::size_t(number)]; }
  Picolitres clottedAt(std::int32_t number) const { return clotted_[std::size_t(number)]; }
  const SkinCells& skin() const { return skin_; }
  std::size_t bytes() const;

  template <class Visitor>
  void visit(Visitor& v) {
    v("wet", wet_);
  }
  // Call this after a state was loaded into wet_.
  void remake(const OperatedOrgan& organ);

 private:
  struct Spot {  // the skin of a cell in this frame, world
    Vec3f place, normal;
    float area = 0;        // m^2
    double height = 0;     // m
    double perVolume = 0;  // rise of the film's surface per volume, m/pl; 0 where blood hangs
  };

  Spot spotOf(const OperatedOrgan& organ, std::int32_t number) const;
  double head(std::int32_t number) const {
    return spots_[std::size_t(number)].height +
           double(liquid_[std::size_t(number)]) * spots_[std::size_t(number)].perVolume;
  }
  void pour(std::int32_t number, Picolitres volume);
  void run(std::int32_t number, double duration, bool table, std::vector<BloodDrop>& drops);
  bool hasOutlet(std::int32_t number) const;
  void level();
  void clot(double duration);
  void settle(const OperatedOrgan& organ, std::int32_t number, std::vector<BloodDrop>& drops);

  std::vector<WetCell> wet_;  // state

  // Derived data, indexed by a cell's number in skin_.
  SkinCells skin_;
  std::vector<Picolitres> liquid_, clotted_;
  std::vector<std::uint8_t> listed_, outlet_, located_;
  std::vector<Spot> spots_;
  std::vector<std::int32_t> order_;  // wet cells, highest first
  std::vector<std::int32_t> ponds_, around_;
};

}  // namespace resect
