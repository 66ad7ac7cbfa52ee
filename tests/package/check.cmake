# Installs `build` below `work`, builds the project `source` against it there, renders `scene`.
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

# Other formats than OpenEXR need the module of codecs, which the consumer's run path leads to.
run(${work}/build/consumer ${scene} ${work}/picture.png)
file(GLOB_RECURSE module ${work}/installed/*/candela_codecs.so)
file(REMOVE ${module})
execute_process(COMMAND ${work}/build/consumer ${scene} ${work}/again.png
  RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(status EQUAL 0 OR EXISTS ${work}/again.png OR NOT output MATCHES "image codecs, which cannot be loaded")
  message(FATAL_ERROR "Without its module of codecs the consumer ended with ${status}:\n${output}")
endif()
file(REMOVE_RECURSE ${work})
