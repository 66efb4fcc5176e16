// OpenGL programs from files of data/shaders, outside of Coin's scene graph.
#pragma once

#include <GL/gl.h>

#include <initializer_list>
#include <string_view>

namespace resect {

// Compiles and links in the current context. Returns 0 on failure, with the reason reported to
// Coin's error handler. Throws Error when a file cannot be read.
GLuint makeProgram(std::initializer_list<std::string_view> vertexFiles,
                   std::initializer_list<std::string_view> fragmentFiles);

}  // namespace resect
