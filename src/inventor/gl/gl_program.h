// Makes OpenGL shader programs from files in data/shaders. These programs are used without a scene
// node.
#pragma once

#include <GL/gl.h>

#include <initializer_list>
#include <string_view>

namespace resect {

// Compiles and links a program in the current context. The vertex shader consists of all
// vertexFiles, one after the other, and the fragment shader of all fragmentFiles. If the program
// cannot be compiled or linked, returns 0 and reports the reason to Coin's error handler. Throws
// Error if a file cannot be read.
GLuint makeProgram(std::initializer_list<std::string_view> vertexFiles,
                   std::initializer_list<std::string_view> fragmentFiles);

}  // namespace resect
