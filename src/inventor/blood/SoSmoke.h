// Inventor shape that draws smoke: soft balls that hide some of what is behind them. In the scene,
// this node must come after all nodes that smoke can hide. Its shader program is that of
// RoomMaterial::Smoke (inventor/gl/materials.h).
//
// Each ball is drawn as a square. For each corner of the square, a shader gets the middle of the
// ball as gl_Vertex, the ball's radius, m, as gl_MultiTexCoord1.z, and its density as
// gl_MultiTexCoord1.w. gl_MultiTexCoord1.x and y say which corner it is; each of them is -1 or 1.
// The shape has no bounds, and cannot be picked. In an .iv file, `Smoke {}` makes a node without
// smoke.
#pragma once

#include <Inventor/fields/SoSFInt32.h>
#include <Inventor/nodes/SoShape.h>
#include <Inventor/nodes/SoSubNode.h>

#include <vector>

#include "operation/smoke/smoke_plume.h"

namespace resect {

class SoSmoke : public SoShape {
  SO_NODE_HEADER(SoSmoke);

 public:
  static void initClass();
  SoSmoke();

  SoSFInt32 revision;  // number of changes so far; set() updates it

  void set(std::vector<SmokeBall> balls);  // world, m

 protected:
  ~SoSmoke() override;
  void GLRender(SoGLRenderAction* action) override;
  void computeBBox(SoAction* action, SbBox3f& box, SbVec3f& centre) override;
  void generatePrimitives(SoAction* action) override;

 private:
  std::vector<SmokeBall> balls_;
};

}  // namespace resect
