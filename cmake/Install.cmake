# The library for others: find_package(candela) gives candela::renderer, ::scene_io, ::integrators.
include(CMakePackageConfigHelpers)
