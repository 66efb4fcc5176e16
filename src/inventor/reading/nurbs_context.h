// Lets Coin tessellate NURBS surfaces without a display.
#pragma once

namespace resect {

// Coin 4.0.0 makes an offscreen OpenGL context before it tessellates a NURBS surface, and crashes
// when there is no display, though nothing is ever drawn in that context. This supplies a dummy
// context. For reading only: afterwards this process can no longer render through Coin's own
// offscreen contexts, so call it in a child process.
void pretendOffscreenContext();

}  // namespace resect
