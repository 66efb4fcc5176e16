// Lets Coin tessellate NURBS surfaces without a display, in a process that cannot open files.
#pragma once

namespace resect {

// Coin 4.0.0 makes an offscreen OpenGL context before it tessellates a NURBS surface, although it
// draws nothing in that context. If there is no display, Coin then crashes. This function gives
// Coin a dummy context instead. It also loads the library that tessellates, so it must be called
// before the sandbox is entered. Call it only in a child process that reads a file: afterwards the
// process can no longer draw in Coin's own offscreen contexts.
void prepareNurbs();

}  // namespace resect
