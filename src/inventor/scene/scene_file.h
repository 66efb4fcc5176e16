// Saves an operation as a file that any Inventor viewer shows, and reads the poses back from that
// file.
//
// The file has plain nodes only: camera, lamps, materials and transforms, and the organ as an
// IndexedFaceSet with normals, named Organ. The cells are not saved. If the file is opened for
// another operation, new cells are made from the cut surface.
#pragma once

#include <filesystem>

#include "inventor/scene/operating_room.h"
#include "io/model.h"
#include "surface/surface_tracker.h"

namespace resect {

constexpr const char* kOrganNode = "Organ";  // name of the node that holds the organ

// Writes atomically (io/atomic_file.h). Throws Error if the file cannot be written.
void writeSceneFile(const std::filesystem::path& path, const OperatingRoom& room,
                    const SurfaceTracker::Compact& organ);

// Gives the room's camera the pose, height angle and focal distance of a saved scene. The places of
// a file that writeSceneFile() wrote are in readModel(file).places (inventor/reading/model_file.h),
// read and checked as any file from outside.
void setCamera(OperatingRoom& room, const ScenePlaces& places);

}  // namespace resect
