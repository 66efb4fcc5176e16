// Bleeding during an operation. Blood flows out of cut vessels and cut tissue, over the organs, in
// drops through the air, and onto the table. An account, the ledger, is exact to the picolitre: the
// volume that flowed out equals the sum of the volumes in all places.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "blood/film/blood_film.h"
#include "blood/film/blood_table.h"
#include "blood/flow/vessel_flow.h"
#include "organ/edit.h"

namespace resect {

// The volume of blood that flowed out, and where it is now: bled = film + clotted + drops + pools +
// sucked + absorbed + lost.
struct BloodLedger {
  Picolitres bled = 0;      // flowed out of vessels and cut tissue
  Picolitres film = 0;      // liquid blood on organs
  Picolitres clotted = 0;   // clotted blood on organs
  Picolitres drops = 0;     // in the air
  Picolitres pools = 0;     // on the table
  Picolitres sucked = 0;    // removed by suction
  Picolitres absorbed = 0;  // soaked up by gauze
  Picolitres lost = 0;      // fell past the table, or fell where there is no table

  Picolitres found() const { return film + clotted + drops + pools + sucked + absorbed + lost; }
};

// An open end of a vessel. Blood flows out of the end, or air is drawn into it.
struct BleedingEnd {
  std::int32_t organ = 0, segment = -1;
  VesselEnd end = VesselEnd::Root;
  Vec3 place = Vec3::Zero();  // world, m
  double flow = 0;            // out of the end, m^3/s; negative: air is drawn in
  double radius = 0;          // of the vessel, m
};

struct BloodReport {
  BloodLedger ledger;
  double rate = 0;                // flow out of vessels and tissue, mean over the frame, m^3/s
  double airRate = 0;             // flow of air drawn into open hepatic veins, m^3/s
  std::vector<BleedingEnd> ends;  // ends out of which blood flows now, sorted by organ and segment
};

// Grade of bleeding for a rate in m^3/s: from 0 (none) to 4 (life-threatening), on the VIBe scale
// (Lewis et al. 2017).
int bleedingGrade(double rate);

class Bleeding {
 public:
  Bleeding() = default;
  // Organs without vessels (anatomy/anatomy.h) do not bleed.
  explicit Bleeding(std::span<const OperatedOrgan> organs, const Circulation& circulation = {});
  bool any() const { return any_; }

  // Computes the bleeding in a frame that lasts `duration`, s. To be called after the tissue has
  // moved. organs: the organs that the constructor got; the flows out of their injured vessels are
  // updated. edits: all edits applied in the frame. time: simulated time at the end of the frame,
  // s. table: whether there is a table. `report` is overwritten.
  void step(std::span<OperatedOrgan> organs, std::span<const TissueEdit> edits, double duration,
            double time, bool table, BloodReport& report);

  const BloodFilm& film(std::size_t organ) const { return organs_[organ].film; }
  const std::vector<BloodDrop>& drops() const { return drops_; }
  const BloodTable& table() const { return table_; }
  BloodLedger ledger() const;
  double air() const { return air_; }  // volume of air drawn into hepatic veins so far, m^3
  std::size_t bytes() const;

  template <class Visitor>
  void visit(Visitor& v) {
    v.fixed("organs", organs_), v("drops", drops_), v("table", table_);
    v("bled", bled_), v("sucked", sucked_), v("absorbed", absorbed_), v("lost", lost_),
        v("air", air_);
  }
  void remake(std::span<const OperatedOrgan> organs);  // after a state was loaded

 private:
  // A cell with cut faces out of which blood oozes.
  struct Oozing {
    std::int64_t cell = -1;
    double area = 0;   // of the cut faces, m^2
    double since = 0;  // simulated time at which the faces were cut, s
    // Part of the tissue to which the cell belongs. 0: the body; otherwise the number of a
    // separated piece, as in SegmentPart.
    std::int32_t part = 0;

    template <class Visitor>
    void visit(Visitor& v) {
      v("cell", cell), v("area", area), v("since", since), v("part", part);
    }
  };
  struct OrganBlood {
    BloodFilm film;
    std::vector<Oozing> oozing;
    // Pressures in the sinusoids (the capillaries of the liver), Pa. The index is Oozing::part.
    // Pieces in which no vessel ends may be missing at the end.
    std::vector<double> sinusoids;
    // An edit may divide tissue into parts. The search for parts is delayed until some frames after
    // the edit. unsought: number of frames since the edit; 0: no search is due.
    std::int32_t unsought = 0;
    VesselFlow flow;  // set up once

    template <class Visitor>
    void visit(Visitor& v) {
      v("film", film), v("oozing", oozing), v("pressures", sinusoids);
      v("unsought", unsought);
    }
  };

  void follow(OrganBlood& blood, OperatedOrgan& organ, std::int32_t number,
              std::span<const TissueEdit> edits, double time);
  void bleed(OrganBlood& blood, OperatedOrgan& organ, std::int32_t number, double duration,
             double time, BloodReport& report);
  void bleedFrom(OrganBlood& blood, const OperatedOrgan& organ, const VesselInjury& injury, int end,
                 std::int64_t cell, double duration, double time, Picolitres volume);
  void ooze(OrganBlood& blood, const OperatedOrgan& organ, double duration, double time);
  Picolitres take(const Vec3& place, double radius, Picolitres most);
  double pressureAt(const Vec3& place) const;
  double pressureOutside(const Vec3& place, double level) const;
  void fly(std::span<const OperatedOrgan> organs, double duration, bool table);
  void shed(OrganBlood& blood, std::int64_t cell, Picolitres volume);

  std::vector<OrganBlood> organs_;
  std::vector<BloodDrop> drops_;
  BloodTable table_;
  Picolitres bled_ = 0, sucked_ = 0, absorbed_ = 0, lost_ = 0;
  double air_ = 0;
  bool any_ = false;
  Circulation circulation_;
  std::vector<Press> pressing_;  // Press edits of this frame
};

}  // namespace resect
