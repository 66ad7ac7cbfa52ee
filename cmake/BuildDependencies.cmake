# Header-only libraries that only building needs: nothing of them is left in the installed package.

find_package(nlohmann_json REQUIRED)

find_path(XXHASH_INCLUDE_DIR xxhash.h REQUIRED)
add_library(candela_xxhash INTERFACE)
target_include_directories(candela_xxhash SYSTEM INTERFACE ${XXHASH_INCLUDE_DIR})
target_compile_definitions(candela_xxhash INTERFACE XXH_INLINE_ALL)

find_path(CLI11_INCLUDE_DIR CLI/CLI.hpp REQUIRED)
add_library(candela_cli11 INTERFACE)
target_include_directories(candela_cli11 SYSTEM INTERFACE ${CLI11_INCLUDE_DIR})
