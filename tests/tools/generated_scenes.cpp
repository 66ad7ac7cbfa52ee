#include "tests/tools/generated_scenes.h"

#include <filesystem>

#include <fmt/format.h>

namespace candela::cli_test {

const std::vector<GeneratedScene>& generated_scenes() {
  static const std::vector<GeneratedScene> all{
      {"attic", "", 7 * 2 + 2 + 512 + 1 + 4, false},
      {"door_ajar", "gap=20", 12 * 4 + 12 + 5 * 12 + 512 + 12 + 2, false},
      {"forest", "trees=40, leaves=100", 2 * 128 * 128 + 40 * (12 + 100)},
      {"glass_and_mirrors", "balls=3", 4 + 4 + 4 + 12 + 2 + 3 * 2048},
      {"lamps", "lamps=50", 12 + 12 * 20 + 2 * 50},
      {"mis_plates", "", 12 + 4 * 2 + 4 * 128, false},
      {"shed", "", 2 + 4 * 2 + 512, false},
      {"soup", "triangles=300", 300},
      {"terrain", "triangles=200", 200, false},
      {"white_room", "", 3 * 12 + 512 + 2, false},
      {"window", "", 2 * 12 + 512 + 4, false}};
  return all;
}

bool can_generate_scenes() {
  return std::filesystem::exists(python) &&
         Program({python, "-c", "import numpy"}, ErrorStream::File).finish().exit_code == 0;
}

ProgramResult generate_scenes(const std::vector<GeneratedScene>& scenes, const std::string& out,
                              int seed) {
  std::string script = "import sys, pathlib; sys.path.insert(0, '" CANDELA_SOURCE_DIR
                       "/tools/dev')\nfrom scene_gen.generate import generate\n";
  for (const GeneratedScene& scene : scenes)
    script += fmt::format("generate('{0}', pathlib.Path('{1}/{0}'), {2}, {3})\n", scene.name, out,
                          seed, scene.parameters);
  return Program({python, "-B", "-c", script}, ErrorStream::File).finish();
}

}  // namespace candela::cli_test
