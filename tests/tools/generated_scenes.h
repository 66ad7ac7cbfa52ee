// Small ones of the scenes that tools/scene_gen makes.
#pragma once

#include <string>
#include <vector>

#include "tests/tools/run_program.h"

namespace candela::cli_test {

inline constexpr const char* python = "/usr/bin/python3";  // Debian's, as in tools/scene_gen

struct GeneratedScene {
  std::string name;
  std::string parameters;       // as Python takes them
  std::uint64_t triangles = 0;  // as seen, instances counted
  bool is_random = true;
};

[[nodiscard]] const std::vector<GeneratedScene>& generated_scenes();

// Whether Debian's python3-numpy is installed, which the generator needs.
[[nodiscard]] bool can_generate_scenes();

// All these in one process; each in a folder of its own name below `out`, which has it as
// NAME.yaml.
[[nodiscard]] ProgramResult generate_scenes(const std::vector<GeneratedScene>& scenes,
                                            const std::string& out, int seed);

}  // namespace candela::cli_test
