// The way of an instrument in an organ's own coordinates, so that one scenario fits any organ.
// placeWays() (operation/way/place_ways.h) makes keys in the world of it, once the organ is there.
// docs/scenarios.md, "Ways in the organ's coordinates", lists the keys with which files give one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"

namespace resect {

struct WayKey {
  // When the key is reached: at this time, s from the start; or with this speed of the tip, m/s,
  // from the key before; or, if neither is given, so many seconds after the key before.
  std::optional<double> time, speed;
  double wait = 0;

  // Where the tool's tip is, with the organ at rest as it lies in the room.
  enum class Place {
    Same,      // where it was at the key before
    Box,       // `place`, in fractions of the organ's box
    Landmark,  // the organ's landmark of that name
    Over       // over the organ: place.x of its box from left to right, and there place.z of its
               // own extent from back to front (operation/way/organ_section.h)
  };
  Place kind = Place::Same;
  Vec3 place = Vec3::Zero();
  std::string landmark;
  // If given, it replaces the height: depth below the organ's top there, m, negative above it; or,
  // if `share`, as a share of the organ's greatest height in the upright plane there.
  std::optional<double> depth;
  bool share = false;
  // Added last: metres, and sides of the organ's cells, along the axes of the room.
  Vec3 offset = Vec3::Zero(), cells = Vec3::Zero();

  std::optional<Eigen::Quaterniond> rotation;  // none: as at the key before
  double squeeze = 0, pedal = 0;               // as in ToolKey
};

struct OrganWay {
  std::string organ;         // its name in the scenario; "": the first
  std::vector<WayKey> keys;  // the first one has a time and a place
};

}  // namespace resect
