# One layer = one folder in src/ with all its sub-folders, one static library resect_<layer>, one test executable
# test_<layer>.
# Which layer may include which is written once, in tools/layers.txt, and checked by a test.

# Two thirds of compiling a file is reading headers: Eigen and the standard ones, and in the upper layers the simulation.
# They are read once for each of four groups: the core below operation/, the layers from there on, the program with its
# window (Qt asks for options of its own in all that uses it), and the tests.
function(resect_precompile target)
  set(headers ${PROJECT_SOURCE_DIR}/src)
  if(target STREQUAL "resect_base")
    target_precompile_headers(${target} PRIVATE ${headers}/base/precompiled.h)
  elseif(target STREQUAL "resect_operation")
    target_precompile_headers(${target} PRIVATE ${headers}/operation/precompiled.h)
  elseif(target STREQUAL "resect_app")
    target_precompile_headers(${target} PRIVATE ${headers}/app/precompiled.h)
  elseif(target STREQUAL "test_base")
    target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/test/support/precompiled.h)
  elseif(target MATCHES "^(resect_(haptics|io|formats|record|skills|inventor)|bench_.*)$")
    target_precompile_headers(${target} REUSE_FROM resect_operation)
  elseif(target MATCHES "^(resect|test_app)$")
    target_precompile_headers(${target} REUSE_FROM resect_app)
  elseif(target MATCHES "^test_")
    target_precompile_headers(${target} REUSE_FROM test_base)
  else()
    target_precompile_headers(${target} REUSE_FROM resect_base)
  endif()
endfunction()

function(resect_layer name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.h)
  add_library(resect_${name} STATIC ${sources} ${headers})
  target_include_directories(resect_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                             $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(resect_${name} PUBLIC ${ARGN})
  resect_precompile(resect_${name})
endfunction()

# For the sanitizers: readers are given files that ask for more memory than there is, which is bad_alloc and no
# finding; what was freed is kept for a while, but not so much that it looks like growth; libraries keep some
# memory until the end.
set(RESECT_TEST_ENVIRONMENT ASAN_OPTIONS=allocator_may_return_null=1:quarantine_size_mb=16
    LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/test/library_leaks.txt:print_suppressions=0)

# How many times as long a test may take: under a sanitizer everything is some ten times slower.
if(RESECT_SANITIZE)
  set(RESECT_PATIENCE 8)
else()
  set(RESECT_PATIENCE 1)
endif()
list(APPEND RESECT_TEST_ENVIRONMENT RESECT_PATIENCE=${RESECT_PATIENCE})
math(EXPR RESECT_TEST_SECONDS "900 * ${RESECT_PATIENCE}")

function(resect_layer_test name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/test/${name}/*_test.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(test_${name} ${PROJECT_SOURCE_DIR}/test/support/doctest_main.cpp ${sources})
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/test)
  target_link_libraries(test_${name} PRIVATE resect_${name} resect_test_support ${ARGN})
  resect_precompile(test_${name})
  add_test(NAME ${name} COMMAND test_${name} WORKING_DIRECTORY ${PROJECT_BINARY_DIR})
  set_tests_properties(${name} PROPERTIES TIMEOUT ${RESECT_TEST_SECONDS} ENVIRONMENT "${RESECT_TEST_ENVIRONMENT}")
endfunction()
