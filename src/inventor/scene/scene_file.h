// Saves an operation as a file that any Inventor viewer shows, and reads the poses back from that
// file.
//
// The file has plain nodes only: camera, lamps, materials and transforms, and the organ as an
// IndexedFaceSet with normals, named Organ. The cells are not saved. If the file is opened for
// another operation, new cells are made from the cut surface.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "inventor/scene/operating_room.h"
#include "surface/surface_tracker.h"

namespace resect {

constexpr const char* kOrganNode = "Organ";  // name of the node that holds the organ

// Writes atomically (io/atomic_file.h). Throws Error if the file cannot be written.
void writeSceneFile(const std::filesystem::path& path, const OperatingRoom& room,
                    const SurfaceTracker::Compact& organ);

struct ScenePlaces {
  std::vector<Pose> tools;  // one per tool, in the order of the saved room
  Pose camera;
  double heightAngle = 0;    // of the camera's view, rad
  double focalDistance = 0;  // from the camera to its point of interest, m
};

// Tools and camera of a file that writeSceneFile() wrote; nullopt for any other file. The file is
// read in this process, not in a child. So call readModel() first, which rejects harmful files.
std::optional<ScenePlaces> readScenePlaces(const std::filesystem::path& path);
// Gives the room's camera the saved pose, height angle and focal distance.
void setCamera(OperatingRoom& room, const ScenePlaces& places);

}  // namespace resect
