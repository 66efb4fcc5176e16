// Finds camera and tools in the scene graph of a saved scene, by the names that it is saved with.
#pragma once

#include <optional>
#include <string>

#include "io/model.h"

class SoNode;

namespace resect {

// What inventor/scene/scene_file.h writes: an Info node with the mark as the root's first child, a
// PerspectiveCamera and a Transform for each tool under these names.
constexpr const char* kSceneMark = "Resect operation";
constexpr const char* kCameraNode = "Camera";
std::string toolNode(int tool);  // numbered from 0

// None for a scene that Resect did not save. Numbers are as the file has them: checkModel()
// (io/model.h) refuses what is out of range. `root` must be referenced.
std::optional<ScenePlaces> findPlaces(SoNode* root);

}  // namespace resect
