// The way of an instrument: its motion in an organ's own coordinates. A scenario that uses ways
// fits any organ. A way is a list of keys (keyframes); a key tells where the instrument is at one
// time. When the organ is loaded, placeWays() (operation/way/place_ways.h) converts the way to keys
// in world coordinates (ToolKey). docs/scenarios.md, "Ways in the organ's coordinates", describes
// ways in files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"

namespace resect {

struct WayKey {
  // The time at which the key is reached. time: s from the start. speed: speed of the tip on the
  // way from the previous key, m/s. wait: s after the previous key; used only if neither `time` nor
  // `speed` is given.
  std::optional<double> time, speed;
  double wait = 0;

  // Position of the tool's tip relative to the organ. The organ is at rest and has the pose in
  // which it lies in the room.
  enum class Place {
    Same,      // as at the previous key
    Box,       // `place`, in fractions of the organ's box
    Landmark,  // the organ's landmark with the name `landmark`
    Over       // over the organ: place.x as a fraction of its box; place.z as a fraction of the
               // organ's extent from back to front at that x (operation/way/organ_section.h)
  };
  Place kind = Place::Same;
  Vec3 place = Vec3::Zero();
  std::string landmark;
  // If given, determines the height of the tip: `depth` is the depth of the tip below the organ's
  // top at this place. It is negative above the top. The unit of `depth` is 1 m or, if `share` is
  // true, the organ's greatest height in its section at this x (OrganSection::tallest()).
  std::optional<double> depth;
  bool share = false;
  // Both are added to the position last, along the axes of the world. offset: in m. cells: in sides
  // of the organ's cells.
  Vec3 offset = Vec3::Zero(), cells = Vec3::Zero();

  std::optional<Eigen::Quaterniond> rotation;  // in the world; none: as at the previous key
  double squeeze = 0, pedal = 0;               // as in ToolKey
};

struct OrganWay {
  std::string organ;         // the organ's name in the scenario; "": the first organ
  std::vector<WayKey> keys;  // the first key has a time and a place
};

}  // namespace resect
