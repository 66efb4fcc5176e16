// Saves the operating room as a file that any Inventor viewer can show. Also restores the camera
// from such a file, after the file has been read.
//
// The file contains only node types that Inventor itself defines. It contains the camera, two
// lamps, the table, the tool box and the tools, with their poses. The surface of the organs is an
// IndexedFaceSet with normals and materials, in a Separator with the name Organ. The cells are not
// saved. If the file is opened as an organ for another operation, new cells are made from the saved
// surface.
//
// No function of this header reads a file. To read a saved scene, call readModel()
// (inventor/reading/model_file.h). The poses of tools and camera are in the field Model::places of
// the result.
#pragma once

#include <filesystem>

#include "inventor/scene/operating_room.h"
#include "io/model.h"
#include "surface/surface_tracker.h"

namespace resect {

constexpr const char* kOrganNode = "Organ";  // name of the node that holds the organs' surface

// Saves the room. The file is written atomically (io/output/atomic_file.h). organ: the present
// surface of the organs (LiveOperation::surface()). Throws Error if the file cannot be written.
void writeSceneFile(const std::filesystem::path& path, const OperatingRoom& room,
                    const SurfaceTracker::Compact& organ);

// Gives the room's camera the pose, height angle and focal distance that the camera has in a saved
// scene. places: Model::places of that scene.
void setCamera(OperatingRoom& room, const ScenePlaces& places);

}  // namespace resect
