# Installs `build` below `work`, builds the project `source` against it there, renders `scene`. Then
# does without the module of codecs, which `textured_scene` needs.
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

# Other formats than OpenEXR need the module of codecs, to which run paths lead.
function(fail_for_want_of_codecs)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(status EQUAL 0 OR NOT output MATCHES "image codecs, which cannot be loaded")
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\nended with ${status}:\n${output}")
  endif()
endfunction()

run(${work}/build/consumer ${scene} ${work}/picture.png)
run(${work}/installed/bin/candela check ${textured_scene})
file(GLOB_RECURSE module ${work}/installed/*/candela_codecs.so)
file(REMOVE ${module})
fail_for_want_of_codecs(${work}/build/consumer ${scene} ${work}/again.png)
fail_for_want_of_codecs(${work}/installed/bin/candela check ${textured_scene})
fail_for_want_of_codecs(${work}/installed/bin/candela render ${scene} -o ${work}/again.png)
if(EXISTS ${work}/again.png)
  message(FATAL_ERROR "Without its module of codecs candela wrote a PNG.")
endif()
file(REMOVE_RECURSE ${work})
