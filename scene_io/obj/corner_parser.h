// The corners of a face: v, v/vt, v//vn or v/vt/vn, counted from 1, or backwards from -1.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "scene_io/obj/obj_data.h"

namespace candela::obj {

// How many entries a table has in all, and above the current line.
struct TableSize {
  std::size_t total = 0;
  std::size_t above = 0;
};
struct TableSizes {
  TableSize positions, uvs, normals;
};

// A place within the word and what is wrong there.
struct CornerFault {
  std::size_t offset = 0;
  std::string message;
};

// Parses one word of a face. Returns what is wrong, or nothing and the corner.
[[nodiscard]] std::optional<CornerFault> parse_corner(std::string_view word,
                                                      const TableSizes& sizes, Corner& corner);

}  // namespace candela::obj
