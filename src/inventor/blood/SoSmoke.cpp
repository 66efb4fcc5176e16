#define GL_GLEXT_PROTOTYPES
#include "inventor/blood/SoSmoke.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/bundles/SoMaterialBundle.h>
#include <Inventor/elements/SoGLCacheContextElement.h>

#include <utility>

namespace resect {

SO_NODE_SOURCE(SoSmoke);

void SoSmoke::initClass() {
  if (classTypeId != SoType::badType()) return;
  // Not SO_NODE_INIT_CLASS: it would keep the So in the name that files use.
  PRIVATE_COMMON_INIT_CODE(SoSmoke, "Smoke", &SoSmoke::createInstance, SoShape);
}

SoSmoke::SoSmoke() {
  SO_NODE_CONSTRUCTOR(SoSmoke);
  SO_NODE_ADD_FIELD(revision, (0));
}

SoSmoke::~SoSmoke() = default;

void SoSmoke::set(std::vector<SmokeBall> balls) {
  if (balls.empty() && balls_.empty()) return;
  balls_ = std::move(balls);
  revision = revision.getValue() + 1;
}

// All balls have one colour, so their order does not matter.
void SoSmoke::GLRender(SoGLRenderAction* action) {
  SoGLCacheContextElement::shouldAutoCache(action->getState(),
                                           SoGLCacheContextElement::DONT_AUTO_CACHE);
  if (balls_.empty() || !shouldGLRender(action)) return;
  SoMaterialBundle material(action);
  material.sendFirst();
  glPushAttrib(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_ENABLE_BIT);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glBegin(GL_QUADS);
  for (const SmokeBall& ball : balls_)
    for (const auto& [x, y] :
         {std::pair(-1.0f, -1.0f), {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
      glMultiTexCoord4f(GL_TEXTURE1, x, y, ball.radius, ball.density);
      glVertex3fv(ball.centre.data());
    }
  glEnd();
  glPopAttrib();
}

void SoSmoke::computeBBox(SoAction*, SbBox3f& box, SbVec3f&) { box.makeEmpty(); }

void SoSmoke::generatePrimitives(SoAction*) {}

}  // namespace resect
