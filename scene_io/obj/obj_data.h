// What the lines of an OBJ file say, before meshes are made of it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "renderer/base/diagnostic.h"
#include "renderer/math/vec.h"
#include "scene_io/text/source.h"

namespace candela::obj {

// Indices from 0 into ObjData's tables; -1 where the file gives none.
struct Corner {
  std::int32_t position = -1;
  std::int32_t uv = -1;
  std::int32_t normal = -1;
  friend bool operator==(const Corner&, const Corner&) = default;
};

// Corners one after another. What no corner of the table has takes no memory.
class CornerTable {
 public:
  [[nodiscard]] std::size_t size() const { return positions_.size(); }
  [[nodiscard]] Corner operator[](std::size_t i) const {
    return {positions_[i], uvs_.empty() ? -1 : uvs_[i], normals_.empty() ? -1 : normals_[i]};
  }
  void reserve(std::size_t count) { positions_.reserve(count); }
  void push_back(const Corner& corner) {
    append(uvs_, corner.uv);
    append(normals_, corner.normal);
    positions_.push_back(corner.position);
  }
  // Takes the last ones away again.
  void shorten_to(std::size_t count) {
    positions_.resize(count);
    uvs_.resize(std::min(uvs_.size(), count));
    normals_.resize(std::min(normals_.size(), count));
  }

 private:
  // Before positions_ grows.
  void append(std::vector<std::int32_t>& indices, std::int32_t index) const {
    if (indices.empty()) {
      if (index < 0) return;
      indices.reserve(positions_.capacity());
      indices.resize(positions_.size(), -1);
    }
    indices.push_back(index);
  }

  std::vector<std::int32_t> positions_;
  std::vector<std::int32_t> uvs_;      // empty, or as many
  std::vector<std::int32_t> normals_;  // likewise
};

struct Face {
  std::uint32_t corner_count = 0;
  std::uint32_t offset = 0;  // of its line, from the chunk's begin
};

// `usemtl`, or a `g` or `o`, between two faces.
struct Switch {
  enum class Kind : std::uint8_t { Shape, Material };
  Kind kind = Kind::Shape;
  std::uint32_t face = 0;    // the first one behind it
  std::uint32_t corner = 0;  // that face's first
  std::string_view name;     // a material's
};

// Something to say about a place; lines are counted only if it is said.
struct Finding {
  Severity severity = Severity::Error;
  std::size_t offset = 0;
  std::string message;
};

// A kind of statement that is left out, where it first occurs.
struct LeftOut {
  std::string_view keyword;
  std::size_t offset = 0;
};

struct MtlReference {
  std::string_view names;  // the rest of the line
  std::size_t offset = 0;
};

// The faces of one stretch of the file, in order.
struct Chunk {
  std::size_t begin = 0;  // offset in the text
  std::vector<Face> faces;
  CornerTable corners;  // of all faces
  std::vector<Switch> switches;
  std::vector<MtlReference> libraries;
  std::vector<LeftOut> left_out;  // one a keyword
  std::vector<Finding> findings;  // the first that are wrong
  std::size_t error_count = 0;    // all of them
};

struct ObjData {
  std::vector<Vec3d> positions;
  std::vector<Vec2f> uvs;
  std::vector<Vec3f> normals;  // as in the file, but scaled where float would lose them
  std::vector<Chunk> chunks;   // in the order of the file
};

// Reads all lines, in parallel. Views into `source.text` stay in the result; all its indices are
// valid, also after errors.
[[nodiscard]] ObjData parse_lines(const text::Source& source, Diagnostics& diagnostics);

}  // namespace candela::obj
