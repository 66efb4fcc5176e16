// Couinaud's segments of a liver, and the names of the liver's vessels. Both are found from the
// portal vein and the hepatic veins alone.
//
// Couinaud (1957) divides a liver into eight segments, I to VIII. Each segment is supplied by
// branches of the portal vein, and hepatic veins run between the segments (terms: Strasberg et al.
// 2000, doi:10.1080/136518200750032032).
//
// First the liver is divided into three territories, each supplied by branches of the portal vein.
// The leftmost branch supplies the left liver. In the right liver, the rightmost branch supplies
// the posterior section (VI and VII), and the other branches supply the anterior section (V and
// VIII). The territory of a point is decided by a vote of the 12 branch ends nearest to the point;
// the vote of a nearer end counts more.
//
// Then the territories are divided into segments. In the left liver, the plane of the left hepatic
// vein separates IV from II and III. Planes at the height of the portal vein's fork separate VI
// from VII, V from VIII, and III from II. Such a plane is moved up or down until at least 30 % of
// the terminals that it divides lie on each side. The caudate lobe, I, lies round the line from the
// fork to the vena cava, behind this line.
//
// The axis of the vena cava is the line from the portal vein's fork to the point where the hepatic
// veins meet. The middle hepatic vein has a right side and a left side. The side with more
// terminals of the portal vein is taken as the right side. So right and left are exchanged in a
// mirrored liver, and in a liver whose left half is larger than its right half.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "anatomy/anatomy.h"

namespace resect {

inline constexpr int kLiverSegments = 8;

// "I" to "VIII"; empty for any other number.
std::string_view romanNumber(int segment);

class LiverSegments {
 public:
  // The result is empty if the portal vein has fewer than 20 terminals, or if the hepatic veins do
  // not have three main branches.
  static std::optional<LiverSegments> find(const Anatomy& anatomy);

  // The number, 1 to 8, of the Couinaud segment in which a point lies. place: in rest space, m.
  int at(const Vec3& place) const;
  // The name of a vessel, which says what part of the liver the vessel supplies or drains.
  // Examples: "right anterior portal vein", "portal branch of segment VI". segment: index, in the
  // anatomy, of any piece of the vessel.
  std::string nameOf(const Anatomy& anatomy, std::int32_t segment) const;
  // The Couinaud segments that a vessel supplies or drains: bit s - 1 stands for Couinaud segment
  // s. The bit is set if more than a tenth of the vessel's terminals lie in s. It is also set if
  // the vessel has more than half of all terminals that vessels of its kind have in s. A segment
  // that the vessel's parent does not supply is left out. If this leaves no segment, the vessel has
  // the set of its parent. segment: index of a piece of the vessel.
  std::uint8_t territory(std::int32_t segment) const { return territory_[std::size_t(segment)]; }

 private:
  enum class Section : std::uint8_t { Posterior, Anterior, Left };
  struct Terminal {  // an end of the portal vein
    Vec3 end = Vec3::Zero();
    Section section = Section::Left;
  };

  void setAxes(const Anatomy& anatomy, const std::vector<std::int32_t>& trunks);
  void setSections(const Anatomy& anatomy, std::int32_t fork);
  void setLevels();
  void nameVessels(const Anatomy& anatomy);
  Section sectionAt(const Vec3& place) const;
  double height(const Vec3& place) const { return (place - fork_).dot(up_); }  // above the fork, m
  // Angle about the axis of the vena cava, rad, measured from ahead_ towards left_.
  double angle(const Vec3& place) const;

  // fork_: the portal vein's fork. cava_: the point where the hepatic veins meet. Both in m.
  Vec3 fork_ = Vec3::Zero(), cava_ = Vec3::Zero();
  // Unit vectors. up_ has the direction of the vena cava's axis.
  Vec3 up_ = Vec3::Zero(), ahead_ = Vec3::Zero(), left_ = Vec3::Zero();
  std::array<double, 3> veins_{};   // angle() of the right, middle and left hepatic vein
  std::array<double, 2> levels_{};  // heights, m, of the planes: [0] right liver, [1] left liver
  std::vector<Terminal> terminals_;
  std::vector<std::uint8_t> territory_;
  // Per segment of the anatomy, the hepatic vein to which the segment belongs. 0: right; 1: middle;
  // 2: left; -1: the segment belongs to none of these three veins.
  std::vector<std::int8_t> trunk_;
};

}  // namespace resect
