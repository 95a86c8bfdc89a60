# trocar_module(NAME [DEPS module…] [USES target…] [PUBLIC_USES target…])
#
# Makes the static library trocar_NAME from every source file of engine/NAME. DEPS are modules above it in
# engine/CMakeLists.txt: one that is not yet defined is refused, so a cycle cannot be written. USES are libraries of
# others, private to the module. tools/check_includes.py reads the same lines.
set_property(GLOBAL PROPERTY TROCAR_MODULES "")

function(trocar_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "DEPS;USES;PUBLIC_USES")
  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp"
       "${CMAKE_CURRENT_SOURCE_DIR}/${name}/*/*.cpp")
  list(FILTER sources EXCLUDE REGEX "/plugin/")
  if(sources)
    add_library(trocar_${name} STATIC ${sources})
    set(kind PUBLIC)
    target_link_libraries(trocar_${name} PRIVATE ${arg_USES})
  else()
    add_library(trocar_${name} INTERFACE)
    set(kind INTERFACE)
  endif()
  target_link_libraries(trocar_${name} ${kind} trocar_flags fmt::fmt tl::expected ${arg_PUBLIC_USES})
  foreach(dep IN LISTS arg_DEPS)
    if(NOT TARGET trocar_${dep})
      message(FATAL_ERROR "engine/${name} may not depend on ${dep}: it is not defined above it")
    endif()
    target_link_libraries(trocar_${name} ${kind} trocar_${dep})
  endforeach()
  set_property(GLOBAL APPEND PROPERTY TROCAR_MODULES "${name}")
endfunction()
