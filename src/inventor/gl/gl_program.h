// How do files of data/shaders become a program of OpenGL, outside of Coin's scene graph?
#pragma once

#include <GL/gl.h>

#include <initializer_list>
#include <string_view>

namespace resect {

// Compiles and links in the current context. 0 when that fails; Coin's error handler is then told
// why. Throws Error when a file cannot be read.
GLuint makeProgram(std::initializer_list<std::string_view> vertexFiles,
                   std::initializer_list<std::string_view> fragmentFiles);

}  // namespace resect
