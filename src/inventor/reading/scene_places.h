// Finds the poses of camera and tools in the scene graph of a saved scene. The nodes with these
// poses are found by their names.
#pragma once

#include <optional>
#include <string>

#include "io/model.h"

class SoNode;

namespace resect {

// writeSceneFile() (inventor/scene/scene_file.h) writes these nodes: as the first child of the root
// an Info node with the text kSceneMark, then a PerspectiveCamera with the name kCameraNode, and
// for each tool a Transform with the name toolNode().
constexpr const char* kSceneMark = "Resect operation";
constexpr const char* kCameraNode = "Camera";
std::string toolNode(int tool);  // name of the node of a tool; tool: its number, from 0

// Returns nothing if the scene lacks the Info node or the camera that is described above. Such a
// scene was not saved by Resect. The numbers in the result are not checked; checkModel()
// (io/model.h) refuses numbers out of range. The caller must hold a reference to `root`
// (SoNode::ref()).
std::optional<ScenePlaces> findPlaces(SoNode* root);

}  // namespace resect
