# Installs `build` below `work`, builds the project `source` against it there, renders `scene`. Then
# does without the module of codecs, which `textured_scene` does not need.
cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\nended with ${status}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${work})
run(${CMAKE_COMMAND} --install ${build} --prefix ${work}/installed)
run(${CMAKE_COMMAND} -S ${source} -B ${work}/build -G ${generator}
  -D CMAKE_CXX_COMPILER=${compiler} "-DCMAKE_CXX_FLAGS=${flags}" -D CMAKE_BUILD_TYPE=Release
  -D candela_ROOT=${work}/installed)
run(${CMAKE_COMMAND} --build ${work}/build)
run(${work}/build/consumer ${scene} ${work}/picture.exr)

if(NOT output MATCHES "16384 camera rays")
  message(FATAL_ERROR "The consumer said:\n${output}")
endif()
if(NOT EXISTS ${work}/picture.exr)
  message(FATAL_ERROR "The consumer wrote no picture.")
endif()

# Found twice in one scope; where a dependency is missing whoever asked quietly goes on, and others are
# told which.
set(find ${CMAKE_COMMAND} -S ${source}/../found -G ${generator}
  -D CMAKE_CXX_COMPILER=${compiler} -D candela_ROOT=${work}/installed)
run(${find} -B ${work}/twice -D HOW=twice)
foreach(missing CMAKE_DISABLE_FIND_PACKAGE_fmt=ON Imath_LIBRARY=)
  file(REMOVE_RECURSE ${work}/quietly)
  run(${find} -B ${work}/quietly -D HOW=quietly -D ${missing})
endforeach()
execute_process(COMMAND ${find} -B ${work}/required -D HOW=required -D Imath_LIBRARY=
  RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(status EQUAL 0 OR NOT output MATCHES "of which[ \n]+Imath_LIBRARY[ \n]+was[ \n]+not[ \n]+found")
  message(FATAL_ERROR "Without Imath find_package(candela REQUIRED) ended with ${status}:\n${output}")
endif()

# Headers that once lacked an include, each alone; and none that needs an image library's.
foreach(header integrators/whitted/render_grid_tile.h renderer/image/blocked_signals.h)
  file(WRITE ${work}/alone.cpp "#include \"${header}\"\n")
  run(${compiler} -std=c++20 -fsyntax-only -I ${work}/installed/include/candela ${work}/alone.cpp)
endforeach()
file(GLOB_RECURSE unusable ${work}/installed/include/candela/*exr_slices.h)
if(unusable)
  message(FATAL_ERROR "Installed without what it includes: ${unusable}")
endif()

# Other formats than OpenEXR and PNG need the module of codecs to be written, and rare ones to be read:
# run paths lead to it.
file(WRITE ${work}/unusual.obj "mtllib unusual.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n"
  "usemtl unusual\nf 1/1 2/1 3/1\n")
file(WRITE ${work}/unusual.mtl "newmtl unusual\nmap_Kd unusual.ppm\n")
file(WRITE ${work}/unusual.ppm "P3\n1 1\n255\n1 2 3\n")
function(fail_for_want_of_codecs)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(status EQUAL 0 OR NOT output MATCHES "image codecs, which cannot be loaded")
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\nended with ${status}:\n${output}")
  endif()
endfunction()

run(${work}/build/consumer ${scene} ${work}/picture.hdr)
run(${work}/installed/bin/candela check ${work}/unusual.obj)
file(GLOB_RECURSE module ${work}/installed/*/candela_codecs.so)
file(REMOVE ${module})
fail_for_want_of_codecs(${work}/build/consumer ${scene} ${work}/again.hdr)
fail_for_want_of_codecs(${work}/installed/bin/candela check ${work}/unusual.obj)
fail_for_want_of_codecs(${work}/installed/bin/candela render ${scene} -o ${work}/again.hdr)
if(EXISTS ${work}/again.hdr)
  message(FATAL_ERROR "Without its module of codecs candela wrote an HDR.")
endif()
run(${work}/build/consumer ${scene} ${work}/again.png)
run(${work}/installed/bin/candela check ${textured_scene})
file(REMOVE_RECURSE ${work})
