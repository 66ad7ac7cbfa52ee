#include "scene_io/lab3/read_lab3.h"
#include "tests/fuzz/check_scene.h"
#include "tests/fuzz/readers.h"
#include "tests/fuzz/scene_folder.h"

namespace candela::fuzz {

std::string try_lab3(std::string_view bytes) {
  LoadOptions options;
  options.use_mtl_materials = bytes.size() % 2 == 0;
  const auto read = lab3::parse_lab3(scene_folder() + "scene.yaml", bytes, options);
  return fault_of_scene(read);
}

}  // namespace candela::fuzz
