#define GL_GLEXT_PROTOTYPES
#include "inventor/gl_program.h"

#include <GL/glext.h>
#include <Inventor/errors/SoDebugError.h>

#include <string>
#include <utility>

#include "inventor/materials.h"

namespace resect {

GLuint makeProgram(const char* vertexFile, const char* fragmentFile) {
  const GLuint program = glCreateProgram();
  char log[2000] = "";
  for (const auto& [file, stage] :
       {std::pair(vertexFile, GL_VERTEX_SHADER), std::pair(fragmentFile, GL_FRAGMENT_SHADER)}) {
    const std::string source = shaderSource({file});
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
  SoDebugError::post("makeProgram", "GLSL shader %s: %s", fragmentFile, log);
  glDeleteProgram(program);
  return 0;
}

}  // namespace resect
