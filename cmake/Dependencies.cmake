# What the rooms' libraries stand on, from the distribution's packages (tools/setup installs them).
# Installed with the package too: whoever links the static libraries needs the same.

find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(glm REQUIRED)
find_package(TBB REQUIRED)
find_package(ZLIB REQUIRED)
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED)
find_package(yaml-cpp REQUIRED)

if(NOT TARGET glm::glm)
  add_library(glm::glm ALIAS glm)
endif()

# Embree 4 where the distribution has it (Debian 13, Ubuntu 24.04), else Embree 3.
# renderer/accel/embree_api.h hides the difference.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3.13 REQUIRED)
endif()
add_library(candela_embree INTERFACE IMPORTED)
target_link_libraries(candela_embree INTERFACE embree)
target_compile_definitions(candela_embree INTERFACE CANDELA_EMBREE_MAJOR=${embree_VERSION_MAJOR})

# By hand: the distribution's package of Imath names a Python binding that it does not bring.
find_path(OpenEXR_INCLUDE_DIR ImfHeader.h PATH_SUFFIXES OpenEXR REQUIRED)
find_path(Imath_INCLUDE_DIR ImathVec.h PATH_SUFFIXES Imath REQUIRED)
find_library(OpenEXR_LIBRARY OpenEXR REQUIRED)
find_library(Iex_LIBRARY Iex REQUIRED)
find_library(Imath_LIBRARY Imath REQUIRED)
mark_as_advanced(
  OpenEXR_INCLUDE_DIR Imath_INCLUDE_DIR OpenEXR_LIBRARY Iex_LIBRARY Imath_LIBRARY)
add_library(candela_openexr INTERFACE IMPORTED)
target_include_directories(candela_openexr SYSTEM INTERFACE
  ${OpenEXR_INCLUDE_DIR} ${Imath_INCLUDE_DIR})
target_link_libraries(candela_openexr INTERFACE
  ${OpenEXR_LIBRARY} ${Iex_LIBRARY} ${Imath_LIBRARY})
