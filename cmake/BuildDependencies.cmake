# What only building needs: who links the static libraries does not. Of these all but OpenImageIO,
# which the module of codecs brings along, are headers alone.

find_package(nlohmann_json REQUIRED)

find_path(XXHASH_INCLUDE_DIR xxhash.h REQUIRED)
add_library(candela_xxhash INTERFACE)
target_include_directories(candela_xxhash SYSTEM INTERFACE ${XXHASH_INCLUDE_DIR})
target_compile_definitions(candela_xxhash INTERFACE XXH_INLINE_ALL)

find_path(CLI11_INCLUDE_DIR CLI/CLI.hpp REQUIRED)
add_library(candela_cli11 INTERFACE)
target_include_directories(candela_cli11 SYSTEM INTERFACE ${CLI11_INCLUDE_DIR})

# By hand: the distribution's OpenImageIOConfig.cmake asks for Imath's Python binding, which the
# development package does not bring.
find_path(OpenImageIO_INCLUDE_DIR OpenImageIO/imageio.h REQUIRED)
find_library(OpenImageIO_LIBRARY OpenImageIO REQUIRED)
find_library(OpenImageIO_Util_LIBRARY OpenImageIO_Util REQUIRED)
mark_as_advanced(OpenImageIO_INCLUDE_DIR OpenImageIO_LIBRARY OpenImageIO_Util_LIBRARY)
add_library(candela_openimageio INTERFACE IMPORTED)
target_include_directories(candela_openimageio SYSTEM INTERFACE
  ${OpenImageIO_INCLUDE_DIR} ${Imath_INCLUDE_DIR})
target_link_libraries(candela_openimageio INTERFACE
  ${OpenImageIO_LIBRARY} ${OpenImageIO_Util_LIBRARY})
