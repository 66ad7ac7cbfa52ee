// A picture as an encoder takes it: samples as they lie in the file, and what the file tells of
// them.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "renderer/image/decode.h"

namespace candela {

// Formats hold no 64-bit integers.
using EncodableAttribute = std::pair<std::string, std::variant<std::string, double, int>>;

struct Encodable {
  ImageHeader header;  // left, top: in the full picture
  int full_width = 0;
  int full_height = 0;
  // What the file tells ("DateTime" in any format) and, but for EXR, what the writer is asked to
  // do, under OpenImageIO's names.
  std::vector<EncodableAttribute> attributes;
  // Rows from the top, interleaved, machine byte order: header.sample_count() of the header's type.
  const std::byte* samples = nullptr;
};

}  // namespace candela
