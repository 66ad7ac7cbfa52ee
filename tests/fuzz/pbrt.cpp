#include "scene_io/pbrt/read_pbrt.h"
#include "tests/fuzz/check_scene.h"
#include "tests/fuzz/readers.h"
#include "tests/fuzz/scene_folder.h"

namespace candela::fuzz {

std::string try_pbrt(std::string_view bytes) {
  const auto read = pbrt::parse_pbrt(scene_folder() + "scene.pbrt", std::string(bytes));
  return fault_of_scene(read);
}

}  // namespace candela::fuzz
