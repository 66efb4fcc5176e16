// The operating room as one Open Inventor scene, for pictures and for the window.
//
//   root Separator
//     camera, lamps, the lamp at the eye, SoShadowMaps
//     Separator { liver, SoTransform, Separator { colour, SoShadeOnce { SoOrganShape } } ... }
//     Separator { steel, SoTransform, toolbox }
//     Separator { Separator { SoTransform, SoSwitch { blood, steel, tool } } ... }
//     BloodPool
//     Separator { cloth, table }
//     Separator { Transform, Separator { cloth, drape } Separator { fat, ... } ... }
//     Separator { room, background }
//     Separator { aids }
//     Switch { scope, mask }
//
// Here liver, steel, cloth and room are shader programs (inventor/gl/materials.h). World: m, Y up,
// the table's top at y = 0. The surgeon stands at +Z.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "geometry/pose.h"
#include "geometry/triangle_mesh.h"
#include "inventor/scene/model_nodes.h"

class SoBaseColor;
class SoCoordinate3;
class SoEventCallback;
class SoFullPath;
class SoNode;
class SoPerspectiveCamera;
class SoSeparator;
class SoShaderProgram;
class SoShapeHints;
class SoSpotLight;
class SoSwitch;
class SoTransform;

namespace resect {

class SoBloodPool;
class SoOrganShape;
class SoShadowMaps;
struct BareVessels;
struct LooseBlood;

enum class RoomView { Surgeon, Assistant, Top, Laparoscope };

constexpr const char* kRoomViewNames = "surgeon, assistant, top or laparoscope";

// Direction from the centre of a view to its camera, unit.
Vec3 towardsCamera(RoomView view);

// The view of that name, if there is one.
std::optional<RoomView> roomView(std::string_view name);

// Screen colours (sRGB) of the liver's capsule, of the gallbladder, and of a cut where no shader
// draws it.
inline const Vec3f kLiverColour{0.352f, 0.152f, 0.131f};
inline const Vec3f kGallbladderColour{0.255f, 0.300f, 0.165f};
inline const Vec3f kCutColour{0.52f, 0.13f, 0.11f};

class OperatingRoom {
 public:
  OperatingRoom();
  ~OperatingRoom();
  OperatingRoom(const OperatingRoom&) = delete;
  OperatingRoom& operator=(const OperatingRoom&) = delete;

  SoNode* root() const;
  SoPerspectiveCamera* camera() const { return camera_; }
  // The shape of an organ. The room has one organ, number 0, from the start; addOrgan() adds
  // others.
  SoOrganShape* organ(int number = 0) const {
    require(number >= 0 && number < organCount(),
            "there is no organ {} among the room's {}; number from 0", number, organCount());
    return organs_[std::size_t(number)];
  }
  int organCount() const { return int(organs_.size()); }
  // The surface of an added organ must be closed, since its back faces are not drawn.
  void addOrgan(const Vec3f& colour);

  // `model` replaces the present table, tool box or field; nullptr removes it.
  void setTable(SoNode* model);
  void setToolbox(SoNode* model, const Pose& pose = {});

  // The operative field (data/room/field.iv) round the organs, scaled to their box (world, m).
  void setField(SoNode* model, const Aabb& organs);

  // Returns the tool's number; tools are numbered from 0 in the order in which they are added. The
  // first form draws what makeToolNodes() makes, jaws included. `model` is in the tool's frame (m):
  // tip at the origin, handle along +Z.
  int addTool(const ToolModel& tool);
  int addTool(SoNode* model);
  void setToolPose(int tool, const Pose& pose);
  // From now on the tool is drawn only while its pose differs from `rest`. Without `rest` it is
  // always drawn.
  void hideAtRest(int tool, const std::optional<Pose>& rest);
  // Opens or closes the jaws of a tool that has any. `squeeze`: 0 wide open to 1 closed. Returns
  // false if nothing turned.
  bool setToolSqueeze(int tool, double squeeze);
  // Sets the distance from its tip up to which the tool is covered with blood, m.
  void setToolBlood(int tool, double reach);
  // The tool's SoTransform. If a manipulator has taken its place: the manipulator, which is an
  // SoTransform too.
  SoTransform* toolTransform(int tool) const;
  // Bounds of a tool, and of its manipulator if it has one; world, m.
  Aabb toolBounds(int tool) const;
  // Number of the tool that a path from root() leads through; -1 for none.
  int toolOfPath(const SoFullPath& path) const;

  // Shows a mesh as the first organ, uncut, with smooth normals (geometry/normals.h). For an organ
  // that changes, update organ() instead.
  void setOrgan(const TriangleMesh& mesh, const Vec3f& colour = kLiverColour);
  // Shows the blood on the table and in the air. Null: no blood.
  void setLooseBlood(const LooseBlood* blood);
  // Shows the bare vessels. Null: no vessels.
  void setBareVessels(const BareVessels* vessels);
  void setOrganColour(const Vec3f& colour);  // of the first organ
  void setOrganPose(const Pose& pose);       // of all organs and tissues

  // Shows another mesh beside the organs, in their coordinate frame: vessels, gallbladder.
  void addTissue(const TriangleMesh& mesh, const Vec3f& colour);

  // Adds a callback in front of all nodes that handle events, so that it gets each event first.
  void addListener(SoEventCallback* listener);
  void removeListener(SoEventCallback* listener);

  // Models and poses, for writing the room to a file. A null pointer: there is no model.
  SoNode* tableModel() const;
  SoNode* toolboxModel() const;
  Pose toolboxPose() const;
  int toolCount() const;
  SoNode* toolModel(int tool) const;
  const SoSpotLight* lamp(int which) const { return lamps_[which]; }  // which: 0 or 1

  // Aids for the operator that are not part of a real room: draggers, markers. They cast no shadows
  // and are drawn without shaders.
  SoSeparator* aids() const { return aids_; }

  // Call after a change of organs, tools or tool box. `box`: contains the change, world, m. The
  // next picture redraws the shadows inside all boxes given since the last picture. If a box was
  // empty, or something changed without a call of changedIn(), it redraws all shadows.
  void changedIn(const Aabb& box);

  const SoShadowMaps& shadows() const { return *shadows_; }
  // Texels along each side of the shadow maps: fewer are faster.
  void setShadowResolution(int texels);
  void holdShadows(bool held);  // true: drawn shadows are kept until holdShadows(false)

  // Aims lamps and shadows at the box, world, m. Call it once per scene and when the organ's pose
  // is set, but not in every frame: the light would flicker.
  void lightUp(const Aabb& box);

  // Aims the camera at the box (world, m), so that all of it is in a picture. `aspect`: the
  // picture's width / height.
  void look(RoomView view, const Aabb& box, double aspect);
  // As look(), but the middle of the box is in the middle of the picture, and the camera is as near
  // as it can be with all corners of the box in the picture.
  void frame(RoomView view, const Aabb& box, double aspect);
  // Aims the camera at `centre` (world, m) and places it so that an object whose silhouette in this
  // view has the area `silhouette`, m^2, fills the fraction `share` of the picture.
  void closeUp(RoomView view, const Vec3& centre, double silhouette, double share, double aspect);
  // Moves the camera so that all of the box is in a picture. The camera's direction stays.
  void viewAll(const Aabb& box, double aspect);
  bool throughScope() const;  // whether the picture is the round one of a laparoscope

 private:
  void requireTool(int tool) const;
  void followTools();
  void place(RoomView view, const Vec3& target, double distance);
  void setLights(RoomView view);

  SoSeparator* root_;
  SoPerspectiveCamera* camera_;
  SoSpotLight* lamps_[2];
  SoSpotLight* head_;  // at the eye
  SoSwitch* scope_;    // the mask round a laparoscope's picture
  SoShadowMaps* shadows_;
  SoSeparator* casters_;
  SoSeparator* table_;
  SoSeparator* field_;
  SoSwitch *fieldWall_, *fieldDome_;  // the opened wall, and the wall as a laparoscope sees it
  SoSeparator* bare_;
  SoBloodPool* pool_;
  SoCoordinate3* drops_;
  SoSeparator* toolbox_;
  SoTransform* toolboxPose_;
  SoSeparator* tools_;
  // Per tool: its transform and its model. Manipulators are left out, since they cast no shadow.
  SoSeparator* toolShadows_;
  std::vector<std::vector<ToolNodes::Jaw>> jaws_;  // per tool
  std::vector<std::optional<Pose>> hiddenAt_;      // per tool: `rest` of hideAtRest()
  SoSeparator* tissue_;
  SoTransform* organPose_;
  SoBaseColor* organColour_;
  SoShapeHints* organHints_;
  std::vector<SoOrganShape*> organs_;
  SoShaderProgram* steel_;
  SoSeparator* aids_;
};

// setPose() sets the position and rotation of an Inventor transform and keeps its scale. getPose()
// returns position and rotation and ignores the scale.
void setPose(SoTransform* transform, const Pose& pose);
Pose getPose(const SoTransform& transform);

}  // namespace resect
