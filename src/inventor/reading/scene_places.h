// Finds the poses of camera and tools in the scene graph of a saved scene, by the names of their
// nodes.
#pragma once

#include <optional>
#include <string>

#include "io/model.h"

class SoNode;

namespace resect {

// inventor/scene/scene_file.h writes these nodes: an Info node with the text kSceneMark as the
// root's first child, a PerspectiveCamera with the name kCameraNode, and for each tool a Transform
// with the name toolNode().
constexpr const char* kSceneMark = "Resect operation";
constexpr const char* kCameraNode = "Camera";
std::string toolNode(int tool);  // tool: number of the tool, from 0

// Returns nothing if Resect did not save the scene. The numbers are those in the file; checkModel()
// (io/model.h) refuses numbers out of range. The caller must hold a reference to `root`
// (SoNode::ref()).
std::optional<ScenePlaces> findPlaces(SoNode* root);

}  // namespace resect
