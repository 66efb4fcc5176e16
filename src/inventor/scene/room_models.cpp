#include "inventor/scene/room_models.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoTransform.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "base/error.h"
#include "inventor/init.h"
#include "inventor/scene/operating_room.h"
#include "io/data_folder.h"
#include "operation/room.h"

namespace resect {

SoNode* readRoomModel(const std::string& name) {
  constexpr std::string_view kNames[] = {"table",    "toolbox",  "tray",      "field",
                                         "hand_pen", "hand_rod", "hand_rings"};
  require(std::ranges::find(kNames, name) != std::end(kNames),
          "there is no model \"{}\" of the room; use table, toolbox, tray, field, hand_pen, "
          "hand_rod or hand_rings",
          name);
  initInventor();
  const std::filesystem::path path = dataFolder() / "room" / (name + ".iv");
  SoInput input;
  SoSeparator* root = input.openFile(path.c_str(), TRUE) ? SoDB::readAll(&input) : nullptr;
  if (!root)
    throw error("cannot read {} as an Inventor file; install Resect's data again", path.string());
  return root;
}

SoNode* toolPlaces(std::size_t tools) {
  auto* places = new SoSeparator;
  const auto put = [&](const std::string& model, const Pose& pose) {
    auto* placed = new SoSeparator;
    auto* transform = new SoTransform;
    setPose(transform, pose);
    placed->addChild(transform);
    placed->addChild(readRoomModel(model));
    places->addChild(placed);
  };
  put("toolbox", toolBoxPose());
  if (tools > kToolBoxPlaces) put("tray", trayPose());
  return places;
}

}  // namespace resect
