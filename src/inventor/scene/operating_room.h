// The operating room as one Open Inventor scene. Pictures and the window show this scene.
//
//   root Separator
//     camera, lamps, the lamp at the eye, SoShadowMaps
//     Separator { liver, SoTransform, Separator { colour, SoShadeOnce { SoOrganShape } } ... }
//     Separator { steel, tool box and tray }
//     Separator { Separator { SoTransform, SoSwitch { blood, steel, tool } } ... }
//     SoSwitch { SoSwitch { Separator { SoTransform, hand } } ... }
//     Separator { strand, bare vessels }
//     Separator { steel, clips }
//     Separator { strand, SoSwitch { adnexa } }
//     BloodPool
//     Separator { cloth, table }
//     Separator { SoTransform, Separator { cloth, drape } Separator { fat, ... } ... }
//     Separator { drop, drops of blood }
//     Separator { room, background }
//     Separator { smoke, SoSmoke }
//     Separator { aids }
//     Switch { scope, mask }
//
// Here liver, steel, strand, cloth, fat, drop, room, smoke and scope are shader programs
// (inventor/gl/materials.h). Bare vessels, adnexa and aids are explained at setBareVessels(),
// setAdnexa() and aids(). Coordinates are in the world, m. Y is up, and the table's top is at y =
// 0. The surgeon stands at +Z.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "geometry/pose.h"
#include "geometry/triangle_mesh.h"
#include "inventor/scene/model_nodes.h"
#include "inventor/scene/surgeons_hands.h"

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
class SoTexture2Transform;
class SoTransform;

namespace resect {

class SoBloodPool;
class SoOrganShape;
struct SurfaceCopy;
class SoShadowMaps;
class SoSmoke;
struct BareVessels;
struct LooseBlood;
struct SmokeBall;

enum class RoomView { Surgeon, Assistant, Top, Laparoscope };

// Where the main surgical lamp hangs. Surgeon: on the surgeon's side. The second lamp hangs on
// another side.
enum class LampPlace { PatientsRight, PatientsLeft, Surgeon, Above };

constexpr const char* kRoomViewNames = "surgeon, assistant, top or laparoscope";

// Direction from the centre of a view to the view's camera, unit.
Vec3 towardsCamera(RoomView view);

// The view with the name `name`. Returns nothing if there is no such view.
std::optional<RoomView> roomView(std::string_view name);

// Screen colours (sRGB) of the liver's capsule and of the gallbladder. kCutColour is the colour of
// cut tissue in pictures without shaders.
inline const Vec3f kLiverColour{0.352f, 0.152f, 0.131f};
inline const Vec3f kGallbladderColour{0.262f, 0.280f, 0.225f};
inline const Vec3f kCutColour{0.52f, 0.13f, 0.11f};

class OperatingRoom {
 public:
  OperatingRoom();
  ~OperatingRoom();
  OperatingRoom(const OperatingRoom&) = delete;
  OperatingRoom& operator=(const OperatingRoom&) = delete;

  SoNode* root() const;
  SoPerspectiveCamera* camera() const { return camera_; }
  // The shape of an organ. From the start the room has one organ, which has the number 0.
  // addOrgan() adds other organs.
  SoOrganShape* organ(int number = 0) const {
    require(number >= 0 && number < organCount(),
            "there is no organ {} among the room's {}; number from 0", number, organCount());
    return organs_[std::size_t(number)];
  }
  int organCount() const { return int(organs_.size()); }
  // Adds an organ. The organ's surface must be closed, since back faces are not drawn. colour:
  // screen colour of the uncut organ (sRGB).
  void addOrgan(const Vec3f& colour);

  // The next three functions replace the table, the tool box or the operative field by `model`. If
  // `model` is null, the old table, tool box or field is removed without a replacement.
  void setTable(SoNode* model);
  void setToolbox(SoNode* model);

  // model: the operative field, that is, the opened abdomen (data/room/field.iv). It is placed
  // round the organs, and scaled to their size. organs: box of the organs; world, m.
  void setField(SoNode* model, const Aabb& organs);

  // Adds a tool and returns its number. Tools are numbered from 0, in the order in which they are
  // added. The first function draws the nodes that makeToolNodes() makes, with jaws that can open.
  // The second function draws `model`, which is in the tool's frame, m: the tip is at the origin,
  // and the handle lies along +Z.
  int addTool(const ToolModel& tool);
  int addTool(SoNode* model);
  void setToolPose(int tool, const Pose& pose);
  // From now on the tool is drawn only while its pose differs from `rest`. If `rest` is empty, the
  // tool is always drawn.
  void hideAtRest(int tool, const std::optional<Pose>& rest);
  // Opens or closes the jaws of a tool. squeeze: 0 for wide open, 1 for closed, or a value in
  // between. Returns whether a jaw has turned. A tool without jaws does not change.
  bool setToolSqueeze(int tool, double squeeze);
  // Shows or hides the hands that hold the tools (inventor/scene/surgeons_hands.h). At first they
  // are hidden. Hands are seen only in the operative field, and not by the laparoscope. May throw
  // Error, now or later, if a model of a hand cannot be read.
  void showHands(bool shown);
  // Bounds of the hand that holds a tool; world, m. Empty if no hand is seen there.
  Aabb handBounds(int tool) const;
  // Sets how much of a tool is covered with blood. reach: the blood covers the tool from the tip up
  // to this distance from the tip, m.
  void setToolBlood(int tool, double reach);
  // The tool's SoTransform. If a manipulator has replaced it, the result is the manipulator, which
  // is an SoTransform, too.
  SoTransform* toolTransform(int tool) const;
  // Bounds of a tool; world, m. If the tool has a manipulator, the bounds include the manipulator.
  Aabb toolBounds(int tool) const;
  // Number of the tool through which a path from root() leads; -1 if the path leads through no
  // tool.
  int toolOfPath(const SoFullPath& path) const;

  // Shows a mesh as the first organ. The organ is drawn uncut, with smooth normals
  // (geometry/normals.h). For an organ that changes, call update() of organ() instead.
  void setOrgan(const TriangleMesh& mesh, const Vec3f& colour = kLiverColour);
  // Shows the blood on the table and in the air. If `blood` is null, there is no such blood.
  void setLooseBlood(const LooseBlood* blood);
  // Shows the bare vessels, round which the tissue has been removed. If `vessels` is null, no bare
  // vessels are shown.
  void setBareVessels(const BareVessels* vessels);
  // Shows the structures that hang on the organ (operation/adnexa/adnexa.h). They are shown only if
  // the room has an operative field, and cast no shadow. If `adnexa` is null, none are shown.
  void setAdnexa(const SurfaceCopy* adnexa);
  // Shows smoke: the balls that smokeBalls() makes. Smoke casts no shadow.
  void setSmoke(std::vector<SmokeBall> smoke);
  void setOrganColour(const Vec3f& colour);  // sets the colour of the first organ
  void setOrganPose(const Pose& pose);       // of all organs, and of the meshes of addTissue()

  // Shows another mesh, such as vessels or the gallbladder, together with the organs. The mesh has
  // the coordinate frame of the organs.
  void addTissue(const TriangleMesh& mesh, const Vec3f& colour);

  // Adds a callback in front of all nodes that handle events. So the callback gets each event
  // first.
  void addListener(SoEventCallback* listener);
  void removeListener(SoEventCallback* listener);

  // The models and lamps that are needed to write the room to a file. A null pointer means that
  // there is no model.
  SoNode* tableModel() const;
  SoNode* toolboxModel() const;
  int toolCount() const;
  SoNode* toolModel(int tool) const;
  const SoSpotLight* lamp(int which) const { return lamps_[which]; }  // which: 0 or 1

  // Draggers and markers, which help the operator but are not part of a real room. They cast no
  // shadows and are drawn without shaders.
  SoSeparator* aids() const { return aids_; }

  // Call this after a change of organs, tools or tool box. box: contains the change; world, m. The
  // next picture redraws the shadows inside all boxes that were given since the last picture. It
  // redraws all shadows if one of these boxes was empty, or if something has changed and no box was
  // given.
  void changedIn(const Aabb& box);

  const SoShadowMaps& shadows() const { return *shadows_; }
  // texels: number of texels along each side of the shadow maps. With fewer texels drawing is
  // faster.
  void setShadowResolution(int texels);
  void holdShadows(bool held);  // true: shadows are not redrawn until holdShadows(false)

  // Aims lamps and shadows at a box; world, m. Call this once per scene, and again when the organ's
  // pose has been set. Do not call it in every frame, since the light would flicker.
  void lightUp(const Aabb& box);
  // Moves the lamps. At first the main lamp hangs at the patient's right. The next picture shows
  // the new shadows.
  void moveLamp(LampPlace place);

  // Aims the camera at a box. The picture contains the whole box, except in the view of the
  // laparoscope: there, corners of the box may be outside the picture. box: world, m. aspect:
  // width / height of the picture.
  void look(RoomView view, const Aabb& box, double aspect);
  // Aims the camera at the middle of a box. The camera is at the least distance at which all
  // corners of the box are in the picture. box, aspect: as in look().
  void frame(RoomView view, const Aabb& box, double aspect);
  // Aims the camera at `centre` (world, m). The distance of the camera is such that the silhouette
  // of an object fills the fraction `share` of the picture. silhouette: area of this silhouette in
  // the view, m^2.
  void closeUp(RoomView view, const Vec3& centre, double silhouette, double share, double aspect);
  // Moves the camera so that the picture contains the whole box. The camera keeps its direction.
  // box, aspect: as in look().
  void viewAll(const Aabb& box, double aspect);
  bool throughScope() const;  // whether the picture is round, as that of a laparoscope

 private:
  void requireTool(int tool) const;
  void followTools();
  SoTexture2Transform* toolBlood(int tool) const;  // x: `reach` of setToolBlood()
  void followHand(int tool, const Pose& pose, bool toolShown);
  bool handsAreSeen() const;
  void updateHands();  // after a change of what handsAreSeen() depends on
  void place(RoomView view, const Vec3& target, double distance);
  void setLights(RoomView view);

  SoSeparator* root_;
  SoPerspectiveCamera* camera_;
  SoSpotLight* lamps_[2];
  LampPlace lampPlace_ = LampPlace::PatientsRight;
  Aabb lit_;           // the box of the last lightUp()
  SoSpotLight* head_;  // the light at the eye
  SoSwitch* scope_;    // the mask round a laparoscope's picture
  SoShadowMaps* shadows_;
  SoSeparator* casters_;
  SoSeparator* table_;
  SoSeparator* field_;
  // The opened abdominal wall, and the abdominal wall as a laparoscope sees it.
  SoSwitch *fieldWall_, *fieldDome_;
  SoOrganShape* bare_;
  SoSeparator* clips_;
  SoSwitch* adnexaShown_;
  SoOrganShape* adnexa_;
  SoSmoke* smoke_;
  SoBloodPool* pool_;
  SoCoordinate3* drops_;
  SoSeparator* toolbox_;
  SoSeparator* tools_;
  // For each tool: a transform and the tool's model. These nodes do not include manipulators, since
  // manipulators cast no shadow.
  SoSeparator* toolShadows_;
  std::vector<std::vector<ToolNodes::Jaw>> jaws_;  // the jaws of each tool
  // A switch for each tool. Its hand is read when it is first seen.
  SoSwitch* handsShown_;
  bool handsWanted_ = false;
  std::vector<std::optional<HandGrip>> grips_;  // how each tool is held
  std::vector<std::optional<Pose>> hiddenAt_;   // for each tool: `rest` of hideAtRest()
  SoSeparator* tissue_;
  SoTransform* organPose_;
  SoBaseColor* organColour_;
  SoShapeHints* organHints_;
  std::vector<SoOrganShape*> organs_;
  SoShaderProgram* steel_;
  SoSeparator* aids_;
};

// setPose() sets the position and rotation of an Inventor transform, and keeps the transform's
// scale. getPose() returns position and rotation, and ignores the scale.
void setPose(SoTransform* transform, const Pose& pose);
Pose getPose(const SoTransform& transform);

}  // namespace resect
