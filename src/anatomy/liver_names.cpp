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
struct NamedPart {
  std::uint8_t segments;
  const char *portal, *artery, *duct;
};
constexpr NamedPart kParts[] = {
    {bits({6, 7}), "right posterior portal vein", "right posterior hepatic artery",
     "right posterior hepatic duct"},
    {bits({5, 8}), "right anterior portal vein", "right anterior hepatic artery",
     "right anterior hepatic duct"},
    {bits({2, 3}), "left lateral portal vein", "left lateral hepatic artery",
     "left lateral hepatic duct"},
    {bits({5, 6, 7, 8}), "right portal vein", "right hepatic artery", "right hepatic duct"},
    {bits({1, 2, 3, 4}), "left portal vein", "left hepatic artery", "left hepatic duct"}};

// Of a vessel that supplies parts of both halves of the liver, at most so many segments are listed;
// one with more is the stem.
constexpr int kListed = 3;

const char* mainStem(VesselKind kind) {
  return kind == VesselKind::PortalVein      ? "portal vein"
         : kind == VesselKind::HepaticArtery ? "hepatic artery"
                                             : "common hepatic duct";
}

// "IV, VIII"
std::string numbersOf(std::uint8_t segments) {
  std::string list;
  for (int s = 1; s <= kLiverSegments; ++s)
    if (segments & 1 << (s - 1))
      list += fmt::format("{}{}", list.empty() ? "" : ", ", romanNumber(s));
  return list;
}

}  // namespace

std::string_view romanNumber(int segment) {
  constexpr std::string_view kRoman[] = {"", "I", "II", "III", "IV", "V", "VI", "VII", "VIII"};
  return segment >= 1 && segment <= kLiverSegments ? kRoman[segment] : "";
}

void LiverSegments::nameVessels(const Anatomy& anatomy) {
  trunk_.assign(anatomy.segments.size(), -1);
  for (std::size_t k = 0; k < 3; ++k) trunk_[std::size_t(frame_.trunks[k])] = std::int8_t(k);
  for (std::size_t i = 0; i < trunk_.size(); ++i)
    if (const std::int32_t parent = anatomy.segments[i].parent; trunk_[i] < 0 && parent >= 0)
      trunk_[i] = trunk_[std::size_t(parent)];
  std::vector<std::array<std::int32_t, kLiverSegments>> ends(anatomy.segments.size());
  for (std::size_t i = anatomy.segments.size(); i-- > 0;) {
    const VesselSegment& s = anatomy.segments[i];
    if (s.leaf) ++ends[i][std::size_t(nearestSegment(s.end) - 1)];
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
    const VesselSegment& s = anatomy.segments[i];
    if (all == 0) {  // a branch without terminals: as its parent
      if (s.parent >= 0) territory_[i] = territory_[std::size_t(s.parent)];
      continue;
    }
    for (std::size_t k = 0; k < kLiverSegments; ++k)
      if (ends[i][k] > kMinor * all || ends[i][k] > kMost * whole[std::size_t(s.kind)][k])
        territory_[i] |= std::uint8_t(1 << k);
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
  if (own == 0) return mainStem(kind);
  for (const NamedPart& part : kParts)
    if ((own & ~part.segments) == 0)
      return kind == VesselKind::PortalVein      ? part.portal
             : kind == VesselKind::HepaticArtery ? part.artery
                                                 : part.duct;
  if (std::popcount(own) > kListed) return mainStem(kind);
  const std::string numbers = numbersOf(own);
  return kind == VesselKind::PortalVein      ? fmt::format("portal branch of segments {}", numbers)
         : kind == VesselKind::HepaticArtery ? fmt::format("artery of segments {}", numbers)
                                             : fmt::format("bile duct of segments {}", numbers);
}

}  // namespace resect
