// How the colours of an image file are stored, by its name.
#pragma once

#include <string_view>

#include "renderer/base/letter_case.h"
#include "renderer/description/scene_description.h"

namespace candela {

// Linear in formats of floating-point numbers, sRGB in all others.
[[nodiscard]] constexpr description::Encoding encoding_of_colours(std::string_view file_name) {
  const bool is_linear = ends_ignoring_case(file_name, ".exr") ||
                         ends_ignoring_case(file_name, ".hdr") ||
                         ends_ignoring_case(file_name, ".pfm");
  return is_linear ? description::Encoding::Linear : description::Encoding::Srgb;
}

}  // namespace candela
