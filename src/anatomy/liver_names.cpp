// What vessels are called, by the segments that they supply.
#include <fmt/format.h>

#include <bit>

#include "anatomy/liver_segments.h"

namespace resect {
namespace {

// A vessel supplies a segment if more than kMinor of its terminals lie there, or more than kMost of
// the segment's terminals are its own.
constexpr double kMinor = 0.1, kMost = 0.5;

constexpr std::uint8_t bits(std::initializer_list<int> segments) {
  int sum = 0;
  for (const int s : segments) sum |= 1 << (s - 1);
  return std::uint8_t(sum);
}

// What the vessels of a territory are called, the smallest territories first.
struct Part {
  std::uint8_t segments;
  const char *portal, *artery, *duct;
};
constexpr Part kParts[] = {
    {bits({6, 7}), "right posterior portal vein", "right posterior hepatic artery",
     "right posterior hepatic duct"},
    {bits({5, 8}), "right anterior portal vein", "right anterior hepatic artery",
     "right anterior hepatic duct"},
    {bits({2, 3}), "left lateral portal vein", "left lateral hepatic artery",
     "left lateral hepatic duct"},
    {bits({5, 6, 7, 8}), "right portal vein", "right hepatic artery", "right hepatic duct"},
    {bits({1, 2, 3, 4}), "left portal vein", "left hepatic artery", "left hepatic duct"},
    {0xff, "portal vein", "hepatic artery", "common hepatic duct"}};

}  // namespace

std::string_view romanNumber(int segment) {
  constexpr std::string_view kRoman[] = {"", "I", "II", "III", "IV", "V", "VI", "VII", "VIII"};
  return segment >= 1 && segment <= kLiverSegments ? kRoman[segment] : "";
}

void LiverSegments::nameVessels(const Anatomy& anatomy) {
  std::vector<std::array<std::int32_t, kLiverSegments>> ends(anatomy.segments.size());
  for (std::size_t i = anatomy.segments.size(); i-- > 0;) {
    const VesselSegment& s = anatomy.segments[i];
    if (s.leaf) ++ends[i][std::size_t(at(s.end) - 1)];
    if (s.parent < 0) continue;
    for (std::size_t k = 0; k < kLiverSegments; ++k) ends[std::size_t(s.parent)][k] += ends[i][k];
  }
  std::array<std::array<std::int32_t, kLiverSegments>, kVesselKinds> whole{};  // of each kind
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (anatomy.segments[i].parent < 0)
      for (std::size_t k = 0; k < kLiverSegments; ++k)
        whole[std::size_t(anatomy.segments[i].kind)][k] += ends[i][k];
  territory_.assign(anatomy.segments.size(), 0);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    std::int32_t all = 0;
    for (const std::int32_t n : ends[i]) all += n;
    for (std::size_t k = 0; k < kLiverSegments; ++k)
      if (ends[i][k] > kMinor * all ||
          ends[i][k] > kMost * whole[std::size_t(anatomy.segments[i].kind)][k])
        territory_[i] |= std::uint8_t(1 << k);
    // What was left out of the parent's is left out of the branch's.
    const std::int32_t parent = anatomy.segments[i].parent;
    if (parent < 0) continue;
    const std::uint8_t before = territory_[std::size_t(parent)];
    territory_[i] = territory_[i] & before ? territory_[i] & before : before;
  }
}

std::string LiverSegments::nameOf(const Anatomy& anatomy, std::int32_t segment) const {
  const VesselKind kind = anatomy.segments[std::size_t(segment)].kind;
  if (kind == VesselKind::HepaticVein) {
    constexpr const char* kSides[] = {"right", "middle", "left"};
    const int trunk = trunk_[std::size_t(segment)];
    if (trunk < 0) return "hepatic vein";
    return fmt::format("{} hepatic vein", kSides[trunk]);
  }
  const std::uint8_t own = territory_[std::size_t(segment)];
  if (std::has_single_bit(own)) {
    const std::string_view number = romanNumber(1 + std::countr_zero(own));
    return kind == VesselKind::PortalVein      ? fmt::format("portal branch of segment {}", number)
           : kind == VesselKind::HepaticArtery ? fmt::format("artery of segment {}", number)
                                               : fmt::format("bile duct of segment {}", number);
  }
  for (const Part& part : kParts)
    if ((own & ~part.segments) == 0)
      return kind == VesselKind::PortalVein      ? part.portal
             : kind == VesselKind::HepaticArtery ? part.artery
                                                 : part.duct;
  return std::string(resect::nameOf(kind));
}

}  // namespace resect
