// Saves an operation as a file that any Inventor viewer shows, and reads its poses back.
//
// The file has plain nodes only: camera, lamps, materials, transforms, and the organ as an
// IndexedFaceSet with normals, named Organ. The cells are not saved: who operates on the file again
// gets new cells, made from the cut surface.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "inventor/scene/operating_room.h"
#include "surface/surface_tracker.h"

namespace resect {

constexpr const char* kOrganNode = "Organ";  // name of the file's part that is the organ

// Writes atomically (io/atomic_file.h); throws Error in one sentence if that fails.
void writeSceneFile(const std::filesystem::path& path, const OperatingRoom& room,
                    const SurfaceTracker::Compact& organ);

struct ScenePlaces {
  std::vector<Pose> tools;  // in the order of the saved room
  Pose camera;
  double heightAngle = 0;    // rad
  double focalDistance = 0;  // m
};

// Tools and camera of a file that writeSceneFile() wrote; nothing for other files. Reads in this
// process, not in a child: so call readModel() first, which rejects harmful files.
std::optional<ScenePlaces> readScenePlaces(const std::filesystem::path& path);
// Gives the room's camera the saved pose and angle.
void setCamera(OperatingRoom& room, const ScenePlaces& places);

}  // namespace resect
