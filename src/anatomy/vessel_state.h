// What an operation does to vessels: cuts, clips and seals, and the functions that cut.
//
// A vessel is cut as 19 filaments along its axis: one in the middle, six at half its radius and
// twelve at 0.87 of it, each for the same area. So a cut may open a part of the wall only; a vessel
// with more than nine tenths cut is severed, and has two open ends.
#pragma once

#include <bit>
#include <cstdint>
#include <functional>
#include <vector>

#include "anatomy/anatomy.h"
#include "anatomy/vessel_index.h"
#include "collision/swept_blade.h"

namespace resect {

inline constexpr int kFilaments = 19;
inline constexpr double kSevered = 0.9;  // open share from which a vessel is severed

// The ends of a severed vessel: towards the root, and away from it. A hole in the wall has the
// first one only.
enum class VesselEnd : std::uint8_t { Root, Far };

// A segment that was cut.
struct VesselInjury {
  std::int32_t segment = -1;
  std::uint32_t cut = 0;    // bit f: filament f is cut
  double from = 1, to = 0;  // shares of its length between which the wall is gone
  std::uint8_t sealed = 0;  // bit 0: the end at the root, bit 1: the far end
  double flow[2] = {0, 0};  // out of the ends in the last frame, m^3/s
  double bled = 0;          // since it was cut, m^3

  double share() const { return double(std::popcount(cut)) / kFilaments; }
  bool severed() const { return share() > kSevered; }
  bool isSealed(VesselEnd end) const { return sealed >> int(end) & 1; }

  template <class Visitor>
  void visit(Visitor& v) {
    v("segment", segment), v("cut", cut), v("from", from), v("to", to), v("sealed", sealed);
    v("flowRoot", flow[0]), v("flowFar", flow[1]), v("bled", bled);
  }
};

// A clip closes a segment at one place; so does heat that welds its walls together.
struct VesselClip {
  std::int32_t segment = -1;
  double share = 0;  // of the segment's length
  bool byHeat = false;

  template <class Visitor>
  void visit(Visitor& v) {
    v("segment", segment), v("share", share), v("byHeat", byHeat);
  }
};

// A segment that ends in another part of the organ's tissue than the body.
struct SegmentPart {
  std::int32_t segment = -1;
  std::int32_t part = kCrumb;  // from 1 on: a piece

  static constexpr std::int32_t kCrumb = -1;  // the tissue there is gone, or no piece

  template <class Visitor>
  void visit(Visitor& v) {
    v("segment", segment), v("part", part);
  }
};

struct VesselState {
  std::vector<VesselInjury> injuries;  // ascending by segment
  std::vector<VesselClip> clips;       // ascending by segment and share
  std::vector<std::int32_t> bared;     // segments of which tissue was taken away, ascending
  std::vector<SegmentPart> apart;      // ascending by segment
  bool inflowClamped = false;          // portal vein and artery are closed before the organ
  double clampedTime = 0;              // for which they were closed so far, s

  const VesselInjury* injury(std::int32_t segment) const;
  // Whether an end of an injured vessel is closed by a clip.
  bool clipped(const VesselInjury& injury, VesselEnd end) const;
  bool clipped(std::int32_t segment) const;
  void addClip(const VesselClip& clip);

  template <class Visitor>
  void visit(Visitor& v) {
    v("injuries", injuries), v("clips", clips), v("bared", bared), v("apart", apart);
    v("inflowClamped", inflowClamped), v("clampedTime", clampedTime);
  }
};

// Where a filament (0 to kFilaments - 1) of a segment begins and ends.
struct Filament {
  Vec3 start, end;
};
Filament filamentOf(const VesselSegment& segment, int filament);

// Each of these cuts what it meets, and appends the segments of which it cut a filament. The place
// of blade, box or face is that of the tissue at rest. Cost: the segments near it.
void cutVessels(const Anatomy& anatomy, const VesselIndex& index, const SweptBlade& blade,
                VesselState& state, std::vector<std::int32_t>& cut);
// Vessels thinner than `spared`, m of radius, are cut where they run in the box; the others are
// bared there.
void cutVessels(const Anatomy& anatomy, const VesselIndex& index, const Aabb& box, double spared,
                VesselState& state, std::vector<std::int32_t>& cut);

// A face along which tissue tore: cuts vessels thinner than `spared`, m of radius, that cross it;
// the others are bared there.
void tearVessels(const Anatomy& anatomy, const VesselIndex& index, const SweptBlade& face,
                 double spared, VesselState& state, std::vector<std::int32_t>& cut);

// Cuts through a segment at a share of its length.
void divideVessel(std::int32_t segment, double share, VesselState& state,
                  std::vector<std::int32_t>& cut);

// Radius of the widest vessel that heat seals, m: bipolar sealing is approved for up to 7 mm.
inline constexpr double kWidestSealed = 0.0035;

// Closes vessels where tissue is coagulated all round their lumen: ends that are open, and whole
// vessels in a box at rest. coagulated: the share, 0 to 1, at a place at rest.
void sealVessels(const Anatomy& anatomy, const VesselIndex& index, const Aabb& box,
                 const std::function<double(const Vec3&)>& coagulated, VesselState& state);

}  // namespace resect
