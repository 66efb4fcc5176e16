#include "inventor/reading/nurbs_context.h"

#include <Inventor/C/glue/gl.h>
#include <dlfcn.h>

namespace resect {
namespace {

void* create(unsigned int, unsigned int) {
  static char anything = 0;
  return &anything;
}
SbBool makeCurrent(void*) { return TRUE; }
void ignore(void*) {}

}  // namespace

void prepareNurbs() {
  static cc_glglue_offscreen_cb_functions callbacks{create, makeCurrent, ignore, ignore};
  cc_glglue_context_set_offscreen_cb_functions(&callbacks);
  // Coin opens it by this name at the first NURBS, when there is no file system any more; what is
  // loaded already is found. Without it there are no NURBS.
  ::dlopen("libGLU.so.1", RTLD_LAZY | RTLD_GLOBAL);
}

}  // namespace resect
