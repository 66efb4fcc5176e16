// Enables Coin (the Inventor library) to tessellate NURBS surfaces in a process that has no display
// and cannot open files.
#pragma once

namespace resect {

// Before Coin 4.0.0 tessellates a NURBS surface, it makes an offscreen OpenGL context, in which it
// draws nothing. Without a display, Coin crashes when it makes this context. This function gives
// Coin a dummy context instead. The function also loads the library for tessellation, so call it
// before the process enters the sandbox (formats/child/sandbox.h). Call it only in a child process
// that reads a file, since afterwards the process can no longer draw in Coin's own offscreen
// contexts.
void prepareNurbs();

}  // namespace resect
