# Text files that are part of the program: made into one C++ source at configure time, so that the
# program finds them wherever it is installed. Editing one of them configures again.
#
# resect_embed(<target> <function> <folder> <pattern>...): adds a definition of
#   std::string_view <function>(std::string_view name)
# to the target, where `name` is the path of a file below <folder>; unknown names give "".

function(resect_embed target function folder)
  set(entries "")
  set(globs "")
  foreach(pattern ${ARGN})
    list(APPEND globs ${folder}/${pattern})
  endforeach()
  file(GLOB files CONFIGURE_DEPENDS RELATIVE ${folder} ${globs})
  foreach(name ${files})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${folder}/${name})
    file(READ ${folder}/${name} text)
    # Literals longer than 16 000 bytes are not portable; adjacent ones are joined.
    set(literals "")
    string(LENGTH "${text}" length)
    set(from 0)
    while(from LESS length)
      string(SUBSTRING "${text}" ${from} 12000 piece)
      string(APPEND literals "R\"embed(${piece})embed\"\n")
      math(EXPR from "${from} + 12000")
    endwhile()
    string(APPEND entries "  if (name == \"${name}\")\n    return std::string_view(${literals});\n")
  endforeach()
  set(source ${CMAKE_BINARY_DIR}/embedded/${function}.cpp)
  file(CONFIGURE OUTPUT ${source} @ONLY CONTENT
"// Made by CMake from ${folder}; do not edit.
#include <string_view>
namespace resect {
std::string_view @function@(std::string_view name) {
@entries@  return {};
}
}  // namespace resect
")
  target_sources(${target} PRIVATE ${source})
endfunction()
