// Saves the operating room as a file that any Inventor viewer can show, and restores the camera
// from such a saved scene.
//
// The file has only node types that Inventor itself defines. It holds the camera, two lamps, the
// table, the tool box and the instruments, each with its pose, and the surface of the organs as an
// IndexedFaceSet with normals and materials, in a Separator named Organ. The cells are not saved.
// If the file is opened as an organ for another operation, new cells are made from the saved
// surface.
//
// No function of this header reads a file. To read a saved scene, call readModel()
// (inventor/reading/model_file.h): Model::places of its result holds the poses of tools and camera.
#pragma once

#include <filesystem>

#include "inventor/scene/operating_room.h"
#include "io/model.h"
#include "surface/surface_tracker.h"

namespace resect {

constexpr const char* kOrganNode = "Organ";  // name of the node that holds the organs' surface

// Writes atomically (io/atomic_file.h). Throws Error if the file cannot be written.
// organ: the present surface of the organs (LiveOperation::surface()).
void writeSceneFile(const std::filesystem::path& path, const OperatingRoom& room,
                    const SurfaceTracker::Compact& organ);

// Gives the room's camera the pose, height angle and focal distance of a saved scene. places:
// Model::places of that scene.
void setCamera(OperatingRoom& room, const ScenePlaces& places);

}  // namespace resect
