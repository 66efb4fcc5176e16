// Couinaud's segments of a liver, and the names of the liver's vessels. Both are found from the
// portal vein and the hepatic veins alone.
//
// Couinaud (1957) divides a liver into eight segments, I to VIII. Each segment is supplied by
// branches of the portal vein, and hepatic veins run between the segments (terms: Strasberg et al.
// 2000, doi:10.1080/136518200750032032).
//
// Method: the terminals of the portal vein (the ends of its tree) are divided among the eight
// segments. Each terminal stands for the same volume of the liver. Segment I, the caudate lobe,
// gets the terminals that are nearest to a certain line. This line runs a little behind the place
// where the portal vein begins and the place where the hepatic veins meet.
//
// Three half-planes divide the other terminals into four sections. The half-planes begin at an axis
// near the vena cava, and run near the right, the middle and the left hepatic vein. Planes at right
// angles to the axis then divide three of the sections: VII is above VI, VIII above V, and II above
// III. The fourth section is segment IV. Each border is placed by the vessels near it and by the
// usual volumes of the parts on both sides (liver_borders.h).
//
// At the end, borders are moved so that they cut fewer branches of the portal vein: if nearly all
// terminals of a branch are in one segment, this segment gets the whole branch.
//
// The segment of any other point is found from the terminals of the portal vein near this point.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "anatomy/anatomy.h"
#include "anatomy/eight_nearest.h"
#include "anatomy/liver_frame.h"

namespace resect {

inline constexpr int kLiverSegments = 8;

// "I" to "VIII"; empty for any other number.
std::string_view romanNumber(int segment);

class LiverSegments {
 public:
  // The result is empty if LiverFrame::find() finds no frame (anatomy/liver_frame.h). Cost: 30 ms
  // for 1000 terminals.
  static std::optional<LiverSegments> find(const Anatomy& anatomy);

  // The number, 1 to 8, of the Couinaud segment in which a point lies. place: in rest space, m. The
  // eight nearest terminals of the portal vein vote; a nearer terminal has a larger weight.
  int at(const Vec3& place) const;
  // The name of a vessel, which says what part of the liver the vessel supplies or drains.
  // Examples: "right anterior portal vein", "portal branch of segment VI". segment: index, in the
  // anatomy, of any piece of the vessel.
  std::string nameOf(const Anatomy& anatomy, std::int32_t segment) const;
  // The Couinaud segments that a vessel supplies or drains: bit s - 1 stands for Couinaud segment
  // s. The bit is set if more than a tenth of the vessel's terminals belong to s. The bit is also
  // set if the vessel has more than half of all terminals that vessels of its kind have in s. A
  // terminal of a vessel other than the portal vein belongs to the same Couinaud segment as the
  // nearest terminal of the portal vein. segment: index of a piece of the vessel.
  std::uint8_t territory(std::int32_t segment) const { return territory_[std::size_t(segment)]; }
  // The directions from which the segments were found.
  const LiverFrame& frame() const { return frame_; }

 private:
  struct Terminal {  // an end of the portal vein
    Vec3 end = Vec3::Zero();
    std::int32_t vessel = 0;  // index of the vessel's piece in the anatomy
    int segment = 0;          // 1 to 8; 0: none yet
  };

  void takeCaudate();
  void divide(const Anatomy& anatomy);
  void followBranches(const Anatomy& anatomy);
  void nameVessels(const Anatomy& anatomy);
  int nearestSegment(const Vec3& place) const;

  LiverFrame frame_;
  std::vector<Terminal> terminals_;
  EightNearest nearest_;  // of the terminals' ends
  std::vector<std::uint8_t> territory_;
  // For each piece of a vessel in the anatomy, the hepatic vein to which the piece belongs. 0:
  // right; 1: middle; 2: left; -1: none of these three veins.
  std::vector<std::int8_t> trunk_;
};

}  // namespace resect
