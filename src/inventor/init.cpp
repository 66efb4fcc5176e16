#include "inventor/init.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInteraction.h>
#include <Inventor/nodekits/SoNodeKit.h>

#include <cstdlib>

#include "inventor/SoMarchingCubes.h"
#include "inventor/SoOrganShape.h"
#include "inventor/SoShadeOnce.h"
#include "inventor/SoShadowMaps.h"

namespace resect {

void initInventor() {
  // Coin reads the variable when the first unknown type name is met; a model file must not be able
  // to name a library that is then run.
  ::setenv("COIN_NO_SOTYPE_DYNLOAD", "1", 1);
  SoDB::init();
  SoNodeKit::init();
  SoInteraction::init();
  SoMarchingCubes::initClass();
  SoOrganShape::initClass();
  SoShadowMaps::initClass();
  SoShadeOnce::initClass();
}

}  // namespace resect
