// The models of the operating room, which are part of Resect's own data.
#pragma once

#include <cstddef>
#include <string>

class SoNode;

namespace resect {

// Reads the model "table", "toolbox", "tray", "field", "hand_pen", "hand_rod" or "hand_rings" from
// Resect's own data folder. Returns the model as a scene graph with its materials. In this process
// Coin reads no other files: readModel() (inventor/reading/model_file.h) reads all other model
// files in a child process.
SoNode* readRoomModel(const std::string& name);

// Scene graph of the tool box, in which tools lie while they are not in hand (toolBoxPlace()).
// tools: number of tools. For more than four tools there is also a tray, on the other side of the
// organ. The result is meant for OperatingRoom::setToolbox().
SoNode* toolPlaces(std::size_t tools);

}  // namespace resect
