// Changes to the vessels of an organ during an operation: cuts, clips and seals, and the functions
// that make these changes.
//
// Cuts are computed with 19 lines in each vessel, parallel to its axis: the filaments. One filament
// runs in the middle, six run at half the vessel's radius, and twelve at 0.87 of the radius. Each
// filament stands for the same share of the cross-section. A cut through only some of the filaments
// opens only a part of the wall. If more than nine tenths of a vessel's filaments are cut, the
// vessel is severed and has two open ends.
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
inline constexpr double kSevered = 0.9;  // share of cut filaments above which a vessel is severed

// The two ends of a severed vessel: towards the root, and away from it. An injury that does not
// sever the vessel is a hole in the wall and has only the first end.
enum class VesselEnd : std::uint8_t { Root, Far };

// A segment that was cut.
struct VesselInjury {
  std::int32_t segment = -1;
  std::uint32_t cut = 0;    // bit f: filament f is cut
  double from = 1, to = 0;  // the wall is open between these fractions of the segment's length
  std::uint8_t sealed = 0;  // bit 0: end towards the root is sealed; bit 1: far end is sealed
  // Per VesselEnd: flow out of this end in the last frame, m^3/s. Negative: air is drawn in.
  double flow[2] = {0, 0};
  double bled = 0;  // blood that has flowed out of this injury so far, m^3

  double share() const { return double(std::popcount(cut)) / kFilaments; }
  bool severed() const { return share() > kSevered; }
  bool isSealed(VesselEnd end) const { return sealed >> int(end) & 1; }

  template <class Visitor>
  void visit(Visitor& v) {
    v("segment", segment), v("cut", cut), v("from", from), v("to", to), v("sealed", sealed);
    v("flowRoot", flow[0]), v("flowFar", flow[1]), v("bled", bled);
  }
};

// A clip, which closes a segment at one position. Heat that welds the vessel's walls together has
// the same effect.
struct VesselClip {
  std::int32_t segment = -1;
  double share = 0;  // position, as a fraction of the segment's length
  bool byHeat = false;

  template <class Visitor>
  void visit(Visitor& v) {
    v("segment", segment), v("share", share), v("byHeat", byHeat);
  }
};

// A segment that lies in tissue which has been separated from the body, the main part of the organ.
struct SegmentPart {
  std::int32_t segment = -1;
  std::int32_t part = kCrumb;  // number of the separated piece, from 1 on; or kCrumb

  static constexpr std::int32_t kCrumb = -1;  // the segment lies in a tiny piece or in no tissue

  template <class Visitor>
  void visit(Visitor& v) {
    v("segment", segment), v("part", part);
  }
};

struct VesselState {
  std::vector<VesselInjury> injuries;  // ascending by segment
  std::vector<VesselClip> clips;       // ascending by segment and share
  std::vector<std::int32_t> bared;     // segments with a bare piece (not in tissue); ascending
  std::vector<SegmentPart> apart;      // ascending by segment
  bool inflowClamped = false;          // portal vein and artery are closed outside the organ
  double clampedTime = 0;              // total time with the inflow clamped, s

  const VesselInjury* injury(std::int32_t segment) const;
  // clipped(injury, end): whether a clip closes this end of an injured vessel. clipped(segment):
  // whether the segment has any clip.
  bool clipped(const VesselInjury& injury, VesselEnd end) const;
  bool clipped(std::int32_t segment) const;
  void addClip(const VesselClip& clip);

  template <class Visitor>
  void visit(Visitor& v) {
    v("injuries", injuries), v("clips", clips), v("bared", bared), v("apart", apart);
    v("inflowClamped", inflowClamped), v("clampedTime", clampedTime);
  }
};

// Start and end of a filament (0 to kFilaments - 1) of a segment, rest space, m.
struct Filament {
  Vec3 start, end;
};
Filament filamentOf(const VesselSegment& segment, int filament);

// The next three functions cut the filaments that cross a blade, a box or a face. Blade, box and
// face are in rest space, m. If a segment loses a filament that was whole before, the function
// appends this segment to `cut`. Cost: proportional to the number of segments near the blade, box
// or face.
void cutVessels(const Anatomy& anatomy, const VesselIndex& index, const SweptBlade& blade,
                VesselState& state, std::vector<std::int32_t>& cut);
// Of the vessels in the box, cuts the vessels with a radius below `spared`, m. The wider vessels
// become bare in the box.
void cutVessels(const Anatomy& anatomy, const VesselIndex& index, const Aabb& box, double spared,
                VesselState& state, std::vector<std::int32_t>& cut);

// face: the face along which tissue tore. Of the vessels that cross the face, cuts the vessels with
// a radius below `spared`, m. The wider vessels become bare at the face.
void tearVessels(const Anatomy& anatomy, const VesselIndex& index, const SweptBlade& face,
                 double spared, VesselState& state, std::vector<std::int32_t>& cut);

// Cuts all filaments of a segment at a fraction `share` of its length.
void divideVessel(std::int32_t segment, double share, VesselState& state,
                  std::vector<std::int32_t>& cut);

// Radius of the widest vessel that heat seals, m: bipolar sealing devices are approved for vessels
// of up to 7 mm diameter.
inline constexpr double kWidestSealed = 0.0035;

// Seals vessels at places where tissue is coagulated all round the lumen. Vessels wider than
// kWidestSealed are never sealed. Open ends of injured vessels are sealed inside and outside the
// box. Other vessels are closed by heat (VesselClip::byHeat) only inside the box, which is in rest
// space. coagulated: the coagulated share, 0 to 1, of the tissue at a point in rest space.
void sealVessels(const Anatomy& anatomy, const VesselIndex& index, const Aabb& box,
                 const std::function<double(const Vec3&)>& coagulated, VesselState& state);

}  // namespace resect
