// Couinaud's segments of a liver, and the names of its vessels, from its portal vein and hepatic
// veins alone.
//
// Couinaud (1957) divides a liver by the portal vein's branches, and hepatic veins run between them
// (terms: Strasberg et al. 2000, doi:10.1080/136518200750032032). Three territories of the portal
// vein come first: the left liver is that of the leftmost main branch; of the right liver, the
// posterior section (VI, VII) is that of its rightmost branch, the anterior section (V, VIII) the
// rest. A place belongs to the territory of the branches that end nearest to it. The left liver is
// parted by the plane of the left hepatic vein: IV, and II with III. A plane level with the portal
// vein's fork parts VII from VI, VIII from V, and II from III. The caudate, I, lies round the way
// from the fork to the vena cava, behind the fork.
//
// The axis of the vena cava leads from the portal vein's fork to where the hepatic veins meet.
// Right is the side of the middle hepatic vein with more terminals of the portal vein. So a liver
// whose left half is the larger one gets its sides wrong; so does a mirrored one.
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
  // Nothing unless the portal vein has twenty terminals and the hepatic veins three main branches.
  static std::optional<LiverSegments> find(const Anatomy& anatomy);

  // 1 to 8: the segment in which a place of the tissue at rest lies.
  int at(const Vec3& place) const;
  // A vessel's name by what it supplies or drains, such as "right anterior portal vein" or "portal
  // branch of segment VI". segment: index in the anatomy.
  std::string nameOf(const Anatomy& anatomy, std::int32_t segment) const;
  // Bit s - 1: the vessel supplies or drains segment s; those that make less than a tenth of it are
  // left out.
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
  double height(const Vec3& place) const { return (place - fork_).dot(up_); }  // over the fork, m
  double angle(const Vec3& place) const;  // about the cava's axis, from the middle to the left, rad

  Vec3 fork_ = Vec3::Zero(), cava_ = Vec3::Zero();  // of the portal vein; where hepatic veins meet
  Vec3 up_ = Vec3::Zero(), ahead_ = Vec3::Zero(), left_ = Vec3::Zero();  // unit
  std::array<double, 3> veins_{};   // angles of the right, middle and left hepatic vein
  std::array<double, 2> levels_{};  // heights that part VI from VII, V from VIII and II from III
  std::vector<Terminal> terminals_;
  std::vector<std::uint8_t> territory_;
  std::vector<std::int8_t> trunk_;  // of hepatic veins: 0 right, 1 middle, 2 left; else -1
};

}  // namespace resect
