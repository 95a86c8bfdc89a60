# How everything is compiled: language, warnings, sanitizers, and the flags that keep floating point repeatable.
include(GNUInstallDirs)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")

option(TROCAR_BUILD_TESTS "Build the tests" ON)
option(TROCAR_BUILD_BENCHMARKS "Build trocar-bench" ON)
option(TROCAR_BUILD_WINDOW "Build the window program (needs GLFW)" ON)
option(TROCAR_BUILD_FUZZERS "Build the fuzz targets (needs clang)" OFF)
option(TROCAR_WERROR "Treat warnings as errors" ON)
set(TROCAR_SANITIZE "" CACHE STRING "Sanitizers, comma separated: address,undefined or thread")

find_program(TROCAR_CCACHE ccache)
if(TROCAR_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${TROCAR_CCACHE}")
endif()

# Everything of ours is compiled through this target; a library of others never is.
add_library(trocar_flags INTERFACE)
target_include_directories(trocar_flags INTERFACE "${CMAKE_SOURCE_DIR}")
target_compile_options(trocar_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
                       -Woverloaded-virtual -Wnull-dereference -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 reports these inside Eigen and the standard library at -O2; clang-tidy covers our own code.
  target_compile_options(trocar_flags INTERFACE -Wno-maybe-uninitialized -Wno-null-dereference
                         -Wno-array-bounds -Wno-stringop-overflow -Wno-restrict -Wno-psabi)
endif()
if(CMAKE_UNITY_BUILD)
  # Several files are compiled as one, so g++ takes what is private to a file for part of a header.
  target_compile_options(trocar_flags INTERFACE -Wno-subobject-linkage)
endif()
if(TROCAR_WERROR)
  target_compile_options(trocar_flags INTERFACE -Werror)
endif()
if(TROCAR_SANITIZE)
  target_compile_options(trocar_flags INTERFACE "-fsanitize=${TROCAR_SANITIZE}" -fno-omit-frame-pointer -g1)
  target_link_options(trocar_flags INTERFACE "-fsanitize=${TROCAR_SANITIZE}")
  if(TROCAR_SANITIZE MATCHES "address.*undefined" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # With g++ these cost more than half of the build. The address sanitizer sees null and too small objects itself;
    # alignment is checked by the fuzz preset, with clang.
    target_compile_options(trocar_flags INTERFACE -fno-sanitize=null,alignment,object-size)
  endif()
endif()
