// The keys of one map of the file: which there are, and their values as typed things.
// Letter case and underscores of keys and words do not matter. A getter of something wrong says so
// at its place and gives nothing, so that reading goes on with the default.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "renderer/math/vec.h"
#include "scene_io/lab3/reader.h"
#include "scene_io/lab3/yaml_tree.h"

namespace candela::lab3 {

using Names = std::span<const std::string_view>;

// Which numbers are right, and how to say so.
struct Range {
  double low = -1e30;
  double high = 1e30;
  bool excludes_low = false;
  bool excludes_high = false;
  std::string_view expected = "a number";  // "expected ..."

  [[nodiscard]] bool contains(double x) const {
    return (excludes_low ? x > low : x >= low) && (excludes_high ? x < high : x <= high);
  }
};
// Beyond 1e30 squares and cubes leave what float can hold after the scene is scaled to unit size.
inline constexpr double largest_number = 1e30;
inline constexpr Range any_number{};
inline constexpr Range not_negative{0, largest_number, false, false, "a number of at least 0"};
inline constexpr Range positive{0, largest_number, true, false, "a number above 0"};
inline constexpr Range zero_to_one{0, 1, false, false, "a number from 0 to 1"};

[[nodiscard]] bool is_same_name(std::string_view a, std::string_view b);

// "a list of 3 values", "'word'", "nothing", ...
[[nodiscard]] std::string describe(const Node& node);

// One number, a scalar node; `name` begins the sentence where it is wrong.
[[nodiscard]] std::optional<double> read_number(Reader& reader, const Node& node,
                                                std::string_view name, const Range& range);
// How many numbers a list should have; fewer pass, and are for the caller to tell.
struct Count {
  std::size_t least = 3;
  std::size_t most = 3;
};
// As many as are written.
[[nodiscard]] std::optional<std::vector<double>> read_numbers(Reader& reader, const Node& node,
                                                              std::string_view name, Count count,
                                                              const Range& range);
// lab3's vector: what is missing of three numbers is 1 (and a warning).
[[nodiscard]] std::optional<Vec3d> read_vector(Reader& reader, const Node& node,
                                               std::string_view name, const Range& range);

class Fields {
 public:
  // Reports keys given twice (errors) and keys not in `known` (warnings; `hint` may explain one,
  // or return "" for the ordinary sentence). `what` is "a camera" and its like. Anything but a map
  // is an error and has no keys.
  using Hint = std::string (*)(std::string_view key);
  Fields(Reader& reader, const Node& node, std::string_view what, Names known, Hint hint = nullptr);

  [[nodiscard]] std::size_t offset() const { return node_.offset; }
  [[nodiscard]] std::string_view what() const { return what_; }
  [[nodiscard]] const Entry* find(std::string_view key) const;
  [[nodiscard]] bool has(std::string_view key) const { return find(key) != nullptr; }
  // The last of `keys` that is there; a warning for each earlier one that it overrides.
  [[nodiscard]] const Entry* last_of(Names keys) const;
  [[nodiscard]] bool has_any(Names keys) const;

  [[nodiscard]] std::optional<double> number(std::string_view key, const Range& range) const;
  // `alternative` ends the sentence where the number is wrong: " or none".
  [[nodiscard]] std::optional<std::int64_t> integer(std::string_view key, std::int64_t low,
                                                    std::int64_t high,
                                                    std::string_view alternative = "") const;
  [[nodiscard]] std::optional<Vec3d> vector(std::string_view key, const Range& range) const;
  // The extension's colour: a number (grey) or a list of exactly three.
  [[nodiscard]] std::optional<Vec3d> colour(std::string_view key, const Range& range) const;
  [[nodiscard]] std::optional<Vec3d> colour(const Entry* entry, const Range& range) const;
  [[nodiscard]] std::optional<std::string> word(std::string_view key) const;
  [[nodiscard]] bool flag(std::string_view key, bool otherwise) const;
  // The index into `words`.
  [[nodiscard]] std::optional<std::size_t> choice(std::string_view key, Names words) const;

 private:
  void refuse_second(const Entry& entry, const Entry& first) const;
  void warn_of_unknown_key(const Entry& entry, Names known, Hint hint) const;
  [[nodiscard]] std::string unknown_key_text(const Entry& entry, Names known) const;

  Reader& reader_;
  const Node& node_;
  std::string_view what_;
  std::vector<std::pair<std::string_view, const Entry*>> known_;
};

// Nothing counts as a list without entries.
[[nodiscard]] inline bool is_list(const Node& node) {
  return node.is_sequence() || node.is_null();
}

// The list under `key`; null where nothing is there (or no value), or something else, an error.
[[nodiscard]] const Node* list_under(Reader& reader, const Fields& fields, std::string_view key);

// Calls `read(node)` for each entry of the list under `key`.
template <class Read>
void for_each_entry(Reader& reader, const Fields& fields, std::string_view key, Read&& read) {
  const Node* list = list_under(reader, fields, key);
  if (!list) return;
  for (const Entry& item : list->entries) {
    if (reader.is_full()) return;
    read(*item.value);
  }
}

}  // namespace candela::lab3
