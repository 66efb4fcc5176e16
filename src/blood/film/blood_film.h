// Blood as a film on the skin of one organ.
//
// Each skin cell holds a volume in whole picolitres. In a frame the wet cells are visited from the
// highest to the lowest; each gives on what its film's flow carries off, so one sweep is an
// implicit step of the kinematic wave (film flow under gravity on a slope, q = rho g h^3 sin / (3
// mu)). Dry skin is wetted only by a film thicker than its threshold, which makes rivulets. Where
// there is no lower outlet blood levels into ponds. Under overhangs it hangs until it drips.
#pragma once

#include <cstdint>
#include <vector>

#include "blood/film/blood_volume.h"
#include "blood/film/skin_cells.h"

namespace resect {

// Blood on one cell.
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

// Volumes in a film.
struct FilmVolumes {
  Picolitres liquid = 0, clotted = 0;
};

class BloodFilm {
 public:
  // Finds the organ's skin. Call once, or after the organ was restored.
  void setUp(const OperatedOrgan& organ);
  // The skin near these cells may have changed by edits. Blood on cells that have no skin any more
  // goes to a skin cell beside, or falls. Appends the faces that edits opened.
  void renew(const OperatedOrgan& organ, std::span<const std::int64_t> cells,
             std::vector<BloodDrop>& drops, std::vector<OpenedFaces>& opened);
  bool ready() const { return !skin_.empty(); }

  // Places and normals of the wet cells and those beside them. Call once a frame, after the tissue
  // has moved.
  void place(const OperatedOrgan& organ);
  // A frame of `duration`, s. What drips is appended to `drops`; what runs onto the table, where
  // the skin touches it, too: with its height 0.
  void step(double duration, bool table, std::vector<BloodDrop>& drops);

  // Call at the end of a frame: lists the wet cells as state.
  void collect();

  void add(std::int64_t cell, Picolitres volume);
  // Takes liquid from the wet cells within `radius`, m, of a place in the world: at most `most` in
  // all, each cell the same share. Returns what it took.
  Picolitres take(const Vec3& place, double radius, Picolitres most);

  // The skin cell nearest to a place of the tissue at rest, within three cells of it; -1 if none.
  // beside: cells whose centres lie on this side of the place come first; zero: no side.
  std::int64_t skinNear(const Vec3& rest, const Vec3& beside) const;
  // Where the skin of a cell is now, m, and its normal. The cell must be a skin cell.
  struct SkinPlace {
    Vec3 place, normal;
  };
  SkinPlace placeOf(const OperatedOrgan& organ, std::int64_t cell) const;

  FilmVolumes volumes() const;
  const std::vector<WetCell>& wet() const { return wet_; }  // ascending by cell
  // By SkinCells' number.
  Picolitres liquidAt(std::int32_t number) const { return liquid_[std::size_t(number)]; }
  Picolitres clottedAt(std::int32_t number) const { return clotted_[std::size_t(number)]; }
  const SkinCells& skin() const { return skin_; }
  std::size_t bytes() const;

  template <class Visitor>
  void visit(Visitor& v) {
    v("wet", wet_);
  }
  // After wet_ was loaded.
  void remake(const OperatedOrgan& organ);

 private:
  struct Spot {  // where the skin of a cell is in this frame
    Vec3f place, normal;
    float area = 0;        // m^2
    double height = 0;     // m
    double perVolume = 0;  // rise of the film's surface, m per pl; 0 where it hangs
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

  // Derived, by padded number.
  SkinCells skin_;
  std::vector<Picolitres> liquid_, clotted_;
  std::vector<std::uint8_t> listed_, outlet_, located_;
  std::vector<Spot> spots_;
  std::vector<std::int32_t> order_;  // wet cells, highest first
  std::vector<std::int32_t> ponds_, around_;
};

}  // namespace resect
