// Saves an operation as an Inventor file that any Inventor viewer shows, and reads it back.
//
// Plain nodes only: camera, lamps, materials, transforms, and the organ as an IndexedFaceSet with
// normals, named Organ. Reading it back makes new cells of the cut surface.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "inventor/scene/operating_room.h"
#include "surface/surface_tracker.h"

namespace resect {

constexpr const char* kOrganNode = "Organ";  // the part of the file that is the organ

// Writes atomically; an Error in one sentence when that fails.
void writeSceneFile(const std::filesystem::path& path, const OperatingRoom& room,
                    const SurfaceTracker::Compact& organ);

struct ScenePlaces {
  std::vector<Pose> tools;  // in the order of the room that was written
  Pose camera;
  double heightAngle = 0;    // rad
  double focalDistance = 0;  // m
};

// Tools and camera of a file that writeSceneFile wrote; none for other files. Reads in this
// process, so call readModel first, which rejects harmful files.
std::optional<ScenePlaces> readScenePlaces(const std::filesystem::path& path);
void setCamera(OperatingRoom& room, const ScenePlaces& places);

}  // namespace resect
