// One stretch of an OBJ file, line by line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "scene_io/obj/obj_data.h"
#include "scene_io/text/cursor.h"

namespace candela::obj {

// Statements that make table entries.
struct ElementCounts {
  std::size_t positions = 0;
  std::size_t uvs = 0;
  std::size_t normals = 0;
  std::size_t faces = 0;
};

enum class Statement : std::uint8_t {
  None,  // blank line or comment
  Position,
  Uv,
  Normal,
  Face,
  Shape,
  Material,
  Library,
  Silent,   // without meaning for a renderer: s
  LeftOut,  // anything else
};

// The statement of a line; moves `line` behind its keyword. The same function counts and parses,
// so that both see the same lines.
[[nodiscard]] Statement take_statement(text::Cursor& line, std::string_view& keyword);

[[nodiscard]] ElementCounts count_elements(std::string_view text);

// Where a stretch writes, and what stands before it.
struct ChunkTask {
  ElementCounts before;  // in the file before this stretch
  ElementCounts total;   // in the whole file
  ObjData* data = nullptr;
};

// Parses the lines of `text`, which begins at chunk.begin. Stops after Diagnostics::most_counted
// errors.
void parse_chunk(std::string_view text, const ChunkTask& task, Chunk& chunk);

}  // namespace candela::obj
