// Lets Coin tessellate NURBS surfaces without a display and without files.
#pragma once

namespace resect {

// Coin 4.0.0 makes an offscreen OpenGL context before it tessellates a NURBS surface, and crashes
// when there is no display, though nothing is ever drawn in that context. This supplies a dummy
// context, and loads the library that tessellates. For reading only: afterwards this process can no
// longer render through Coin's own offscreen contexts, so call it in a child process, before its
// sandbox is entered.
void prepareNurbs();

}  // namespace resect
