# One set of options for all rooms.
# candela_options is part of the interface: the kernels are templates in headers, and their bits
# must not depend on who instantiates them (no contraction to fma, no errno from libm).

add_library(candela_options INTERFACE)
target_compile_features(candela_options INTERFACE cxx_std_20)
target_compile_options(candela_options INTERFACE -ffp-contract=off -fno-math-errno)

# Techniques of the innermost loops, which have no option to turn them off: built without one, a
# program is what `tools/bench before` compares with (docs/performance.md).
set(CANDELA_WITHOUT "" CACHE STRING "Techniques to build without: ggx_bounds, vector_ray_setup")
foreach(technique IN LISTS CANDELA_WITHOUT)
  if(NOT technique MATCHES "^(ggx_bounds|vector_ray_setup)$")
    message(FATAL_ERROR "CANDELA_WITHOUT has '${technique}', where ggx_bounds or vector_ray_setup "
                        "was expected")
  endif()
  string(TOUPPER ${technique} technique)
  target_compile_definitions(candela_options INTERFACE CANDELA_WITHOUT_${technique})
endforeach()

add_library(candela_warnings INTERFACE)
target_compile_options(candela_warnings INTERFACE
  -Wall -Wextra -Wconversion -Wshadow -Werror=switch $<$<BOOL:${CANDELA_WERROR}>:-Werror>)
# The kernels are compiled with everything that a sample needs inlined, which is too much for GCC's
# defaults: worth 12 % of the CPU time of the Cornell box (docs/decisions.md). A precompiled header
# would silently bring the defaults back.
file(GLOB candela_kernels ${CMAKE_CURRENT_SOURCE_DIR}/integrators/path/instances/*.cpp)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set_source_files_properties(${candela_kernels} PROPERTIES
    SKIP_PRECOMPILE_HEADERS ON COMPILE_OPTIONS
    "--param=inline-unit-growth=500;--param=large-function-growth=5000;--param=max-inline-insns-auto=200;--param=max-inline-insns-single=1000")
endif()
# Loops over lanes become vectors there; a precompiled header would undo the option.
set_source_files_properties(renderer/sampling/sampler_block.cpp PROPERTIES
  SKIP_PRECOMPILE_HEADERS ON COMPILE_OPTIONS -O3)
# There both sides of branches are calculated, which may raise floating-point exceptions that the
# branches would not have: no difference but to builds that trap them. In one place more branches
# meet than GCC takes by default.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
  set_source_files_properties(
    integrators/path/block_lanes.cpp integrators/path/camera_rays.cpp
    integrators/path/film_lanes.cpp integrators/path/reflectance_lanes.cpp
    integrators/path/plain_bsdf_lanes.cpp
    integrators/path/plain_lanes.cpp integrators/path/reuse_lanes.cpp
    integrators/path/sky_lanes.cpp
    renderer/accel/box_list.cpp
    renderer/accel/embree_block.cpp
    renderer/accel/face_hits.cpp renderer/accel/face_lanes.cpp
    renderer/accel/sphere_list.cpp
    renderer/film/alike_sums.cpp renderer/film/pair_errors.cpp
    renderer/film/pixel_planes.cpp renderer/film/robust_mean.cpp
    PROPERTIES
    SKIP_PRECOMPILE_HEADERS ON COMPILE_OPTIONS
    "-O3;-fno-trapping-math;--param=max-tree-if-conversion-phi-args=64")
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

# oneTBB's library is not instrumented, so its headers must not be either: the one file that includes
# them is compiled without ThreadSanitizer and tells it by hand who waits for whom.
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=thread")
  set_source_files_properties(renderer/base/parallel.cpp PROPERTIES
    COMPILE_OPTIONS -fno-sanitize=thread COMPILE_DEFINITIONS CANDELA_THREAD_SANITIZER
    SKIP_PRECOMPILE_HEADERS ON)
  add_link_options("LINKER:--version-script=${CMAKE_CURRENT_SOURCE_DIR}/cmake/thread_sanitizer.map")
endif()

# Invalid operations and divisions by zero in our own code end the program
# (renderer/base/floating_point_traps.h). Not with clang, which moves divisions before the tests that
# keep them from being done by zero.
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=[a-z,]*address" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU"
   AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  add_compile_definitions(CANDELA_FLOATING_POINT_TRAPS)
endif()

# The module of codecs is found by the run path of whoever opens it, which is the program; the
# sanitizers do it in the program's place, whose DT_RPATH counts there, but not its DT_RUNPATH.
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
  target_link_options(candela_options INTERFACE LINKER:--disable-new-dtags)
endif()
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=[a-z,-]*address")
  set_property(SOURCE renderer/image/codecs.cpp renderer/image/allocate_samples.cpp
    APPEND PROPERTY COMPILE_DEFINITIONS CANDELA_ADDRESS_SANITIZER)
endif()
