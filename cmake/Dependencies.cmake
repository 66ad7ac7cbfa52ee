# What the rooms' libraries stand on, from the distribution's packages (tools/setup installs them).
# Installed with the package too: whoever links the static libraries needs the same.
include(CMakeFindDependencyMacro)

# Ends the build, which `what` is told of; within find_package(candela) its caller is.
macro(candela_lacks what)
  if(CMAKE_FIND_PACKAGE_NAME STREQUAL "candela")
    set(candela_FOUND FALSE)
    set(candela_NOT_FOUND_MESSAGE "${what}")
    return()
  endif()
  message(FATAL_ERROR "${what}")
endmacro()

# find_package(PACKAGE [version]) of what candela cannot do without.
macro(candela_needs)
  if(CMAKE_FIND_PACKAGE_NAME STREQUAL "candela")
    find_dependency(${ARGN})
  else()
    find_package(${ARGN} REQUIRED)
  endif()
endmacro()

candela_needs(Threads)
candela_needs(fmt)
candela_needs(glm)
candela_needs(TBB)
candela_needs(ZLIB)
candela_needs(PNG)
candela_needs(JPEG)
candela_needs(yaml-cpp)

if(NOT TARGET glm::glm)
  add_library(glm::glm ALIAS glm)
endif()

# Embree 4 where the distribution has it (Debian 13, Ubuntu 24.04), else Embree 3.
# renderer/accel/embree_api.h hides the difference.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  candela_needs(embree 3.13)
endif()
if(NOT TARGET candela_embree)
  add_library(candela_embree INTERFACE IMPORTED)
  target_link_libraries(candela_embree INTERFACE embree)
  target_compile_definitions(candela_embree INTERFACE
    CANDELA_EMBREE_MAJOR=${embree_VERSION_MAJOR})
endif()

# By hand: the distribution's package of Imath names a Python binding that it does not bring.
find_path(OpenEXR_INCLUDE_DIR ImfHeader.h PATH_SUFFIXES OpenEXR)
find_path(Imath_INCLUDE_DIR ImathVec.h PATH_SUFFIXES Imath)
find_library(OpenEXR_LIBRARY OpenEXR)
find_library(Iex_LIBRARY Iex)
find_library(Imath_LIBRARY Imath)
set(candela_openexr_parts
  OpenEXR_INCLUDE_DIR Imath_INCLUDE_DIR OpenEXR_LIBRARY Iex_LIBRARY Imath_LIBRARY)
mark_as_advanced(${candela_openexr_parts})
foreach(part IN LISTS candela_openexr_parts)
  if(NOT ${part})
    candela_lacks("candela needs OpenEXR 3 with Imath, of which ${part} was not found.")
  endif()
endforeach()
if(NOT TARGET candela_openexr)
  add_library(candela_openexr INTERFACE IMPORTED)
  target_include_directories(candela_openexr SYSTEM INTERFACE
    ${OpenEXR_INCLUDE_DIR} ${Imath_INCLUDE_DIR})
  target_link_libraries(candela_openexr INTERFACE
    ${OpenEXR_LIBRARY} ${Iex_LIBRARY} ${Imath_LIBRARY})
endif()
