#include "inventor/init.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInteraction.h>
#include <Inventor/nodekits/SoNodeKit.h>

#include <cstdlib>

#include "inventor/blood/SoBloodPool.h"
#include "inventor/blood/SoSmoke.h"
#include "inventor/gl/SoMarchingCubes.h"
#include "inventor/gl/SoOrganShape.h"
#include "inventor/gl/SoShadeOnce.h"
#include "inventor/gl/SoShadowMaps.h"

namespace resect {

void initInventor() {
  // Coin reads the variable at the first unknown type name; a model file must not be able to load a
  // library.
  ::setenv("COIN_NO_SOTYPE_DYNLOAD", "1", 1);
  SoDB::init();
  SoNodeKit::init();
  SoInteraction::init();
  SoMarchingCubes::initClass();
  SoOrganShape::initClass();
  SoShadowMaps::initClass();
  SoShadeOnce::initClass();
  SoBloodPool::initClass();
  SoSmoke::initClass();
}

}  // namespace resect
