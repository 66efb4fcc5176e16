# Headers as others include them: <resect/organ/organ.h>, not "organ/organ.h", so that no name of ours meets one of
# theirs. Set before: resect_layers, resect_source, resect_include (below the prefix).
foreach(layer IN LISTS resect_layers)
  file(GLOB_RECURSE headers RELATIVE ${resect_source} ${resect_source}/${layer}/*.h)
  foreach(header IN LISTS headers)
    file(READ ${resect_source}/${header} text)
    string(REGEX REPLACE "#include \"([a-z_]+/[^\"]+)\"" "#include <resect/\\1>" text "${text}")
    set(installed ${CMAKE_INSTALL_PREFIX}/${resect_include}/resect/${header})
    set(there "")
    if(EXISTS "$ENV{DESTDIR}${installed}")
      file(READ "$ENV{DESTDIR}${installed}" there)
    endif()
    if(NOT there STREQUAL text)  # whoever includes it need not be compiled again
      file(WRITE "$ENV{DESTDIR}${installed}" "${text}")
    endif()
    list(APPEND CMAKE_INSTALL_MANIFEST_FILES ${installed})
  endforeach()
endforeach()
