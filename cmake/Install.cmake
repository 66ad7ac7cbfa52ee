# The library for others: find_package(candela) gives candela::renderer, ::scene_io, ::integrators.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/candela)

set_target_properties(candela_options PROPERTIES EXPORT_NAME options)
install(TARGETS candela_options candela_renderer candela_scene_io candela_integrators candela
  EXPORT candelaTargets)
# The run path of whoever links the libraries leads to the module of codecs.
install(TARGETS candela_codecs DESTINATION ${CMAKE_INSTALL_LIBDIR}/candela)
set(codecs_folder ${CMAKE_INSTALL_LIBDIR}/candela)
if(NOT IS_ABSOLUTE ${codecs_folder})
  set(codecs_folder $<INSTALL_PREFIX>/${codecs_folder})
endif()
target_link_options(candela_renderer INTERFACE
  $<INSTALL_INTERFACE:LINKER:-rpath,${codecs_folder}>)
install(EXPORT candelaTargets NAMESPACE candela:: DESTINATION ${package_folder})

# Include paths start at the root of the sources, and below include/candela. Without the headers that
# need those of an image library.
foreach(room renderer scene_io integrators)
  install(DIRECTORY ${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/candela
    FILES_MATCHING PATTERN "*.h" PATTERN openimageio EXCLUDE PATTERN exr_slices.h EXCLUDE)
endforeach()

configure_package_config_file(
  cmake/candelaConfig.cmake.in ${PROJECT_BINARY_DIR}/candelaConfig.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/candelaConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/candelaConfig.cmake ${PROJECT_BINARY_DIR}/candelaConfigVersion.cmake
  DESTINATION ${package_folder})
install(FILES cmake/Dependencies.cmake RENAME candelaDependencies.cmake
  DESTINATION ${package_folder})
# README.md's links and picture are in docs.
install(FILES LICENSE README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
