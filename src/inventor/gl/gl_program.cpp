#define GL_GLEXT_PROTOTYPES
#include "inventor/gl/gl_program.h"

#include <GL/glext.h>
#include <Inventor/errors/SoDebugError.h>

#include <iterator>
#include <string>
#include <utility>

#include "inventor/gl/materials.h"

namespace resect {

GLuint makeProgram(std::initializer_list<std::string_view> vertexFiles,
                   std::initializer_list<std::string_view> fragmentFiles) {
  const GLuint program = glCreateProgram();
  char log[2000] = "";
  for (const auto& [files, stage] :
       {std::pair(vertexFiles, GL_VERTEX_SHADER), std::pair(fragmentFiles, GL_FRAGMENT_SHADER)}) {
    const std::string source = shaderSource(files);
    const char* text = source.c_str();
    const GLuint shader = glCreateShader(GLenum(stage));
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    glAttachShader(program, shader);
    glDeleteShader(shader);
  }
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked) return program;
  if (log[0] == '\0') glGetProgramInfoLog(program, sizeof log, nullptr, log);
  SoDebugError::post("makeProgram", "GLSL shader %s: %s",
                     std::string(*std::prev(fragmentFiles.end())).c_str(), log);
  glDeleteProgram(program);
  return 0;
}

}  // namespace resect
