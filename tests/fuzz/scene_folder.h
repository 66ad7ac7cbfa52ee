// A folder with the small files that fuzzed scenes may name: triangle.obj, triangle.ply, with.obj
// (materials red, blue of with.mtl), picture.png, sky.hdr.
#pragma once

#include <string>

namespace candela::fuzz {

// With '/' at its end. Made on the first call, gone when the program ends in good order.
[[nodiscard]] const std::string& scene_folder();

}  // namespace candela::fuzz
