// A number for what a scene is made of: the contents of every file that it reads.
#pragma once

#include <string>

#include "renderer/description/scene_description.h"

namespace candela::cli {

// 32 hexadecimal digits over the contents of all files, images included, in the order in which the
// scene names them, and nothing else: the names of files and folders do not count. A file that
// cannot be read counts as absent. (xxHash: XXH3, 128 bits.)
[[nodiscard]] std::string scene_hash(const description::SceneDescription& description);

}  // namespace candela::cli
