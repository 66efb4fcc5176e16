#include "inventor/reading/nurbs_context.h"

#include <Inventor/C/glue/gl.h>

namespace resect {
namespace {

void* create(unsigned int, unsigned int) {
  static char anything = 0;
  return &anything;
}
SbBool makeCurrent(void*) { return TRUE; }
void ignore(void*) {}

}  // namespace

void pretendOffscreenContext() {
  static cc_glglue_offscreen_cb_functions callbacks{create, makeCurrent, ignore, ignore};
  cc_glglue_context_set_offscreen_cb_functions(&callbacks);
}

}  // namespace resect
