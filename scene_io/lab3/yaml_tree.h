// A YAML text as a tree whose every node knows its place. The only include of yaml-cpp is in the
// .cpp: its events are taken, not its nodes, since those keep the first of duplicate keys silently
// and lose places.
//
// What comes out is bounded: the depth, the number of nodes, and the number of nodes after aliases
// are followed (so a "billion laughs" file is refused, not expanded).
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/diagnostic.h"
#include "scene_io/text/source.h"

namespace candela::lab3 {

inline constexpr std::size_t max_yaml_bytes = std::size_t{16} << 20;
inline constexpr std::size_t max_yaml_line_bytes = std::size_t{1} << 16;
inline constexpr std::size_t max_yaml_nodes = std::size_t{1} << 20;
inline constexpr std::size_t max_yaml_depth = 32;

struct Node;

struct Entry {
  std::string key;             // of a map; empty in a sequence
  std::size_t key_offset = 0;  // in bytes from the text's begin
  const Node* value = nullptr;
};

struct Node {
  enum class Kind : std::uint8_t { Null, Scalar, Sequence, Map };

  Kind kind = Kind::Null;
  std::size_t offset = 0;          // in bytes from the text's begin
  std::string text;                // of a scalar, quotes and escapes resolved
  std::vector<Entry> entries;      // of a sequence or a map, in the order of the text
  std::size_t expanded_nodes = 1;  // with all below, an alias counted as what it stands for
  std::size_t height = 1;          // levels, likewise

  [[nodiscard]] bool is_null() const { return kind == Kind::Null; }
  [[nodiscard]] bool is_scalar() const { return kind == Kind::Scalar; }
  [[nodiscard]] bool is_sequence() const { return kind == Kind::Sequence; }
  [[nodiscard]] bool is_map() const { return kind == Kind::Map; }
};

struct Document {
  std::deque<Node> nodes;  // addresses stay
  const Node* root = nullptr;
};

// The first document of the text; a second one is warned of. No value: it is not YAML or beyond the
// limits, and one error says why (YAML leaves no statement to recover at).
[[nodiscard]] std::optional<Document> parse_yaml(const text::Source& source,
                                                 Diagnostics& diagnostics);

}  // namespace candela::lab3
