#include "io/scenario/region_reader.h"

namespace resect {
namespace {

constexpr double kSmallestRadius = 1e-6, kLargestRadius = 10;  // m
constexpr double kDeepest = 10;                                // m

// depth = [from, to].
void readDepth(const TomlTable& t, Region& region) {
  const std::vector<double> range = t.numbers("depth", 0, kDeepest);
  if (range.size() != 2 || range[0] > range[1])
    t.complain("depth", "is not two depths [from, to] in m, the lesser first");
  region.shallowest = range[0];
  region.deepest = range[1];
}

}  // namespace

Aabb readBox(const TomlTable& t, const std::string& key, const std::string& advice) {
  const std::vector<Vec3> corners = t.points(key);
  if (corners.size() != 2) t.complain(key, "is missing or not two corners; give " + advice);
  return {corners[0].cwiseMin(corners[1]), corners[0].cwiseMax(corners[1])};
}

Region readRegion(const TomlTable& t) {
  Region region;
  const bool box = t.has("box"), centre = t.has("centre"), at = t.has("at"), deep = t.has("depth");
  if (box + centre + at > 1)
    t.complain(at ? "at" : "centre",
               "comes beside another place; keep one of box, centre with radius, at with radius");
  const std::string frame = t.text("frame", "world");
  if (frame != "world" && frame != "organ")
    t.complain("frame", "is \"" + frame + "\"; use \"world\" or \"organ\"");
  if (t.has("frame") && !box && !centre)
    t.complain("frame", "says what box or centre are in, and there is none; leave it out");
  region.frame = frame == "organ" ? Region::Frame::Organ : Region::Frame::World;
  if (centre || at) {
    region.shape = Region::Shape::Ball;
    if (centre) region.centre = t.vec3("centre");
    if (at) region.landmark = t.text("at");
    if (at && region.landmark.empty()) t.complain("at", "is empty; name a landmark of the organ");
    region.radius = t.number("radius", kSmallestRadius, kLargestRadius);
  } else if (t.has("radius")) {
    t.complain("radius", "belongs to a ball; give its centre, or the landmark that it is at");
  } else if (box || !deep) {
    region.box = readBox(t, "box", "box = [[x, y, z], [x, y, z]], or centre and radius");
  } else {
    region.shape = Region::Shape::Whole;
  }
  if (deep) readDepth(t, region);
  return region;
}

std::vector<Landmark> readLandmarks(const TomlTable& t) {
  std::vector<Landmark> landmarks;
  if (const auto places = t.table("landmark"))
    for (const std::string& name : places->keys()) {
      if (name.empty()) places->complain(name, "is a place without a name; name it");
      landmarks.push_back({name, places->vec3(name)});
    }
  return landmarks;
}

}  // namespace resect
