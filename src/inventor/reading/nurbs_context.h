// Lets Coin tessellate NURBS surfaces without a display and without files.
#pragma once

namespace resect {

// Coin 4.0.0 makes an offscreen OpenGL context before it tessellates a NURBS surface, though it
// draws nothing there. Without a display it then crashes. This function gives Coin a dummy context
// instead, and loads the library that tessellates. Call it only in a child process that reads a
// file, before the sandbox is entered: afterwards the process can no longer draw through Coin's own
// offscreen contexts.
void prepareNurbs();

}  // namespace resect
