// The operating room as one Open Inventor scene, for pictures and for the window.
//
//   root Separator
//     camera, lamps, SoShadowMaps
//     Separator { cloth  | table }
//     Separator { steel  | toolbox }
//     Separator { Separator { SoTransform | Separator { steel | tool } } ... }
//     Separator { liver  | SoTransform, Separator { colour, SoOrganShape } ... }
//     Separator { room   | background }
//     Separator { aids }
//
// World: m, Y up, table top at y = 0. The surgeon stands at +Z.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "geometry/pose.h"
#include "geometry/triangle_mesh.h"

class SoBaseColor;
class SoEventCallback;
class SoFullPath;
class SoNode;
class SoPerspectiveCamera;
class SoSeparator;
class SoShaderProgram;
class SoShapeHints;
class SoSpotLight;
class SoTransform;

namespace resect {

class SoOrganShape;
class SoShadowMaps;

enum class RoomView { Surgeon, Assistant, Top, Laparoscope };

constexpr const char* kRoomViewNames = "surgeon, assistant, top or laparoscope";

// The view of that name, if there is one.
std::optional<RoomView> roomView(std::string_view name);

// Screen colour (sRGB) of the capsule.
inline const Vec3f kLiverColour{0.352f, 0.152f, 0.131f};

inline const Vec3f kGallbladderColour{0.255f, 0.300f, 0.165f};

class OperatingRoom {
 public:
  OperatingRoom();
  ~OperatingRoom();
  OperatingRoom(const OperatingRoom&) = delete;
  OperatingRoom& operator=(const OperatingRoom&) = delete;

  SoNode* root() const;
  SoPerspectiveCamera* camera() const { return camera_; }
  // The first organ, or one that was added.
  SoOrganShape* organ(int number = 0) const {
    require(number >= 0 && number < organCount(),
            "there is no organ {} among the room's {}; number from 0", number, organCount());
    return organs_[std::size_t(number)];
  }
  int organCount() const { return int(organs_.size()); }
  void addOrgan(const Vec3f& colour);

  // Table, tool box: replaced by `model`; nullptr = none.
  void setTable(SoNode* model);
  void setToolbox(SoNode* model, const Pose& pose = {});

  // Tools are numbered in the order they are added. `model` in the tool's frame: tip at the
  // origin, handle along +Z, m.
  int addTool(SoNode* model);
  void setToolPose(int tool, const Pose& pose);
  // Of a tool with jaws, 0 wide open to 1 closed: turns those SoTransforms in its model whose names
  // begin with "Jaw" from where the model has them to no rotation. False: nothing turned.
  bool setToolSqueeze(int tool, double squeeze);
  // The transform, or the manipulator in its place, which is an SoTransform too.
  SoTransform* toolTransform(int tool) const;
  // Bounds of a tool and its manipulator, world, m.
  Aabb toolBounds(int tool) const;
  // The tool on a path from root(); -1 for none.
  int toolOfPath(const SoFullPath& path) const;

  // The whole organ, with smooth normals of its own and no cut. For changing organs use organ(),
  // which must then be closed.
  void setOrgan(const TriangleMesh& mesh, const Vec3f& colour = kLiverColour);
  void setOrganColour(const Vec3f& colour);  // of the first one
  void setOrganPose(const Pose& pose);

  // More tissue beside the organ, in the same frame: vessels, gallbladder.
  void addTissue(const TriangleMesh& mesh, const Vec3f& colour);

  // Adds a callback before all nodes that handle events.
  void addListener(SoEventCallback* listener);
  void removeListener(SoEventCallback* listener);

  // Models and poses, for writing the room to a file. Models may be null.
  SoNode* tableModel() const;
  SoNode* toolboxModel() const;
  Pose toolboxPose() const;
  int toolCount() const;
  SoNode* toolModel(int tool) const;
  const SoSpotLight* lamp(int which) const { return lamps_[which]; }  // 0 or 1

  // Aids for the operator that are not part of a real room: draggers, markers. Without shadows and
  // shaders.
  SoSeparator* aids() const { return aids_; }

  // Organ, tools and tool box have changed only in these boxes, world, m, since the last picture;
  // an empty box, or no call: anywhere. Shadows are redrawn only there.
  void changedIn(const Aabb& box);

  const SoShadowMaps& shadows() const { return *shadows_; }
  // Texels along each side of the shadow maps: fewer are faster.
  void setShadowResolution(int texels);
  void holdShadows(bool held);  // while held they are not redrawn

  // Aims lamps and shadows at the box, world, m. Call it once per scene, or when the organ is
  // moved; not per frame, else the light flickers.
  void lightUp(const Aabb& box);

  // Aims the camera at the box so that all of it is seen in a picture of this width / height.
  void look(RoomView view, const Aabb& box, double aspect);
  // The same, as near as all corners of the box allow, with the box in the middle.
  void frame(RoomView view, const Aabb& box, double aspect);
  // Shows all of the box, keeping the camera's direction.
  void viewAll(const Aabb& box, double aspect);

 private:
  void requireTool(int tool) const;
  struct Jaw {
    SoTransform* transform;
    Eigen::Quaternionf open;
  };
  void place(RoomView view, const Vec3& target, double distance);

  SoSeparator* root_;
  SoPerspectiveCamera* camera_;
  SoSpotLight* lamps_[2];
  SoShadowMaps* shadows_;
  SoSeparator* casters_;
  SoSeparator* table_;
  SoSeparator* toolbox_;
  SoTransform* toolboxPose_;
  SoSeparator* tools_;
  std::vector<std::vector<Jaw>> jaws_;  // of each tool
  SoSeparator* tissue_;
  SoTransform* organPose_;
  SoBaseColor* organColour_;
  SoShapeHints* organHints_;
  std::vector<SoOrganShape*> organs_;
  SoShaderProgram* steel_;
  SoSeparator* aids_;
};

// Position and rotation of an Inventor transform; its scale is kept, respectively ignored.
void setPose(SoTransform* transform, const Pose& pose);
Pose getPose(const SoTransform& transform);

}  // namespace resect
