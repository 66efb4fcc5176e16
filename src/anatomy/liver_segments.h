// Couinaud's segments of a liver and the names of its vessels, found from its portal vein and
// hepatic veins alone.
//
// Couinaud (1957) divides a liver into segments that branches of the portal vein supply, with
// hepatic veins between them (terms: Strasberg et al. 2000, doi:10.1080/136518200750032032). First
// the liver is divided into three territories, each supplied by branches of the portal vein. The
// leftmost branch supplies the left liver. In the right liver, the rightmost branch supplies the
// posterior section (VI, VII), the other branches the anterior section (V, VIII). A point belongs
// to the territory that gets most votes of the 12 nearest branch ends; nearer ends count more. The
// plane of the left hepatic vein divides the left liver into IV and II with III. Planes at the
// height of the portal vein's fork divide VI from VII, V from VIII, and III from II; a plane is
// moved up or down until at least 30 % of the terminals that it divides lie on each side. The
// caudate, I, lies round the line from the fork to the vena cava, behind that line.
//
// The axis of the vena cava is the line from the portal vein's fork to the point where the hepatic
// veins meet. The right is the side of the middle hepatic vein with more terminals of the portal
// vein. So left and right are exchanged for a liver whose left half is the larger one, and for a
// mirrored liver.
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
  // Empty unless the portal vein has at least 20 terminals and the hepatic veins have three main
  // branches.
  static std::optional<LiverSegments> find(const Anatomy& anatomy);

  // The number, 1 to 8, of Couinaud's segment in which a point in rest space lies.
  int at(const Vec3& place) const;
  // The name of a vessel by what it supplies or drains, such as "right anterior portal vein" or
  // "portal branch of segment VI". segment: index in the anatomy, of any piece of the vessel.
  std::string nameOf(const Anatomy& anatomy, std::int32_t segment) const;
  // Bit s - 1: the vessel supplies or drains Couinaud's segment s. It does so if more than a tenth
  // of its terminals lie there, or if more than half of the segment's terminals are its own. The
  // set is never larger than that of the vessel's parent.
  std::uint8_t territory(std::int32_t segment) const { return territory_[std::size_t(segment)]; }

 private:
  enum class Section : std::uint8_t { Posterior, Anterior, Left };
  struct Terminal {  // of the portal vein
    Vec3 end = Vec3::Zero();
    Section section = Section::Left;
  };

  void setAxes(const Anatomy& anatomy, const std::vector<std::int32_t>& trunks);
  void setSections(const Anatomy& anatomy, std::int32_t fork);
  void setLevels();
  void nameVessels(const Anatomy& anatomy);
  Section sectionAt(const Vec3& place) const;
  double height(const Vec3& place) const { return (place - fork_).dot(up_); }  // above the fork, m
  double angle(const Vec3& place) const;  // about the axis of the cava, rad, from ahead_ to left_

  Vec3 fork_ = Vec3::Zero(), cava_ = Vec3::Zero();  // the fork; the hepatic veins' meeting point; m
  Vec3 up_ = Vec3::Zero(), ahead_ = Vec3::Zero(), left_ = Vec3::Zero();  // unit; up_: cava's axis
  std::array<double, 3> veins_{};   // angle() of the right, middle and left hepatic vein
  std::array<double, 2> levels_{};  // heights, m, of the planes: [0] right liver, [1] left liver
  std::vector<Terminal> terminals_;
  std::vector<std::uint8_t> territory_;
  std::vector<std::int8_t> trunk_;  // of hepatic veins: 0 right, 1 middle, 2 left; else -1
};

}  // namespace resect
