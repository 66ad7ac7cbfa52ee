#include "scene_io/lab3/fields.h"

#include <algorithm>
#include <unordered_map>

#include <fmt/format.h>

#include "renderer/base/counted.h"
#include "renderer/base/letter_case.h"
#include "renderer/base/one_of.h"
#include "scene_io/text/number.h"

namespace candela::lab3 {
namespace {

std::string found_expected(std::string_view name, const Node& node, std::string_view expected) {
  return fmt::format("{}: found {}, expected {}", name, describe(node), expected);
}

// YAML writes what is not finite with a dot.
bool is_yaml_not_finite(std::string_view word) {
  if (!word.empty() && (word.front() == '-' || word.front() == '+')) word.remove_prefix(1);
  return equal_ignoring_case(word, ".nan") || equal_ignoring_case(word, ".inf");
}

// After "found 5, expected a list of 3 numbers".
std::string example_of(const Node& node, std::size_t count, const Range& range) {
  const auto number = text::parse_double(node.text);
  if (!node.is_scalar() || !number || !range.contains(number.value)) return "";
  if (number.value == 0) return "";  // which scales and directions refuse
  std::string list = node.text;
  for (std::size_t i = 1; i < count; ++i) list += ", " + node.text;
  return fmt::format(", such as [{}]", list);
}

// After "found 'Eye:[0, 1, 2]', expected the keys of a camera".
std::string_view hint_of_missing_blank(const Node& node) {
  const bool has_colon = node.is_scalar() && node.text.find(':') != std::string::npos;
  return has_colon ? "; is a blank missing behind ':'?" : "";
}

// Equal for names that is_same_name() calls the same.
std::string plain_name(std::string_view name) {
  std::string plain;
  for (const char c : name)
    if (c != '_') plain += to_lower(c);
  return plain;
}

}  // namespace

bool is_same_name(std::string_view a, std::string_view b) {
  std::size_t i = 0;
  std::size_t j = 0;
  for (;;) {
    while (i < a.size() && a[i] == '_') ++i;
    while (j < b.size() && b[j] == '_') ++j;
    if (i == a.size() || j == b.size()) return i == a.size() && j == b.size();
    if (to_lower(a[i++]) != to_lower(b[j++])) return false;
  }
}

std::string describe(const Node& node) {
  switch (node.kind) {
    case Node::Kind::Null:
      return "nothing";
    case Node::Kind::Scalar:
      return text::quoted(node.text);
    case Node::Kind::Sequence:
      if (node.entries.empty()) return "an empty list";
      return "a list of " + counted(node.entries.size(), "value");
    case Node::Kind::Map:
      return "a map of keys";
  }
  return "";
}

std::optional<double> read_number(Reader& reader, const Node& node, std::string_view name,
                                  const Range& range) {
  const auto refuse = [&](std::string_view expected) {
    reader.error(node.offset, found_expected(name, node, expected));
    return std::nullopt;
  };
  if (!node.is_scalar()) return refuse(range.expected);
  if (is_yaml_not_finite(node.text)) return refuse("a finite number");
  const text::Number<double> number = text::parse_double(node.text);
  if (number.fault == text::NumberFault::NotFinite) return refuse("a finite number");
  if (number.fault == text::NumberFault::Malformed) return refuse(range.expected);
  if (!number || std::abs(number.value) > largest_number) return refuse("a number of at most 1e30");
  if (!range.contains(number.value)) return refuse(range.expected);
  return number.value;
}

std::optional<std::vector<double>> read_numbers(Reader& reader, const Node& node,
                                                std::string_view name, Count count,
                                                const Range& range) {
  const auto [least, most] = count;
  if (!node.is_sequence()) {
    const std::string counts =
        least == most ? fmt::format("{}", least) : fmt::format("{} or {}", least, most);
    reader.error(node.offset,
                 found_expected(name, node, fmt::format("a list of {} numbers", counts)) +
                     example_of(node, least, range));
    return std::nullopt;
  }
  if (node.entries.size() > most) {
    reader.error(node.offset, found_expected(name, node, fmt::format("at most {} numbers", most)));
    return std::nullopt;
  }
  std::vector<double> numbers;
  for (const Entry& entry : node.entries) {
    const auto number = read_number(reader, *entry.value, name, range);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<Vec3d> read_vector(Reader& reader, const Node& node, std::string_view name,
                                 const Range& range) {
  const auto numbers = read_numbers(reader, node, name, Count{3, 3}, range);
  if (!numbers) return std::nullopt;
  if (numbers->size() < 3)
    reader.warning(node.offset, fmt::format("{}: found {}, expected 3 numbers; lab3 takes 1 for "
                                            "what is missing",
                                            name, describe(node)));
  Vec3d vector{1.0};
  for (std::size_t i = 0; i < numbers->size(); ++i) vector[static_cast<int>(i)] = (*numbers)[i];
  return vector;
}

Fields::Fields(Reader& reader, const Node& node, std::string_view what, Names known, Hint hint)
    : reader_(reader), node_(node), what_(what) {
  if (!node.is_map()) {
    reader.error(node.offset, fmt::format("found {}, expected the keys of {}{}", describe(node),
                                          what, hint_of_missing_blank(node)));
    return;
  }
  std::unordered_map<std::string, const Entry*> unknown;
  for (const Entry& entry : node.entries) {
    if (reader.is_full()) return;
    const auto name = std::find_if(known.begin(), known.end(), [&](std::string_view candidate) {
      return is_same_name(candidate, entry.key);
    });
    if (name == known.end()) {
      const auto [earlier, is_new] = unknown.try_emplace(plain_name(entry.key), &entry);
      if (is_new)
        warn_of_unknown_key(entry, known, hint);
      else
        refuse_second(entry, *earlier->second);
    } else if (const Entry* earlier = find(*name)) {
      refuse_second(entry, *earlier);
    } else {
      known_.emplace_back(*name, &entry);
    }
  }
}

void Fields::refuse_second(const Entry& entry, const Entry& first) const {
  reader_.error(entry.key_offset,
                fmt::format("key {} is given twice, first in line {}", text::quoted(entry.key),
                            reader_.span(first.key_offset).line));
}

void Fields::warn_of_unknown_key(const Entry& entry, Names known, Hint hint) const {
  std::string sentence;
  if (hint && reader_.wants_warnings()) sentence = hint(entry.key);
  if (sentence.empty() && reader_.wants_warnings()) sentence = unknown_key_text(entry, known);
  reader_.warning(entry.key_offset, std::move(sentence));
}

std::string Fields::unknown_key_text(const Entry& entry, Names known) const {
  if (entry.key == "<<") return "merge keys (<<) are not read: write the keys out";
  // What stands before the first of these is a known key, and has no value.
  const auto known_before = [&](char mark) -> std::string_view {
    const std::size_t end = entry.key.find(mark);
    const std::string_view word = std::string_view(entry.key).substr(0, end);
    const bool is_known = std::any_of(known.begin(), known.end(), [&](std::string_view name) {
      return is_same_name(name, word);
    });
    return end != std::string::npos && entry.value->is_null() && is_known ? word : "";
  };
  const std::string_view before_colon = known_before(':');
  const std::string_view before_blank = known_before(' ');
  std::string hint;
  if (!before_colon.empty())
    hint = fmt::format("; is a blank missing behind '{}:'?", before_colon);
  else if (!before_blank.empty())
    hint = fmt::format("; is ':' missing behind {}?", text::quoted(before_blank));
  else
    hint = did_you_mean(entry.key, {known.begin(), known.end()});
  return fmt::format("unknown key {} in {}{}", text::quoted(entry.key), what_, hint);
}

const Entry* Fields::find(std::string_view key) const {
  for (const auto& [name, entry] : known_)
    if (name == key) return entry;
  return nullptr;
}

const Entry* Fields::last_of(Names keys) const {
  const Entry* last = nullptr;
  for (const std::string_view key : keys) {
    const Entry* entry = find(key);
    if (!entry) continue;
    if (last)
      reader_.warning(last->key_offset,
                      fmt::format("{} is overridden by {}", last->key, entry->key));
    last = entry;
  }
  return last;
}

bool Fields::has_any(Names keys) const {
  return std::any_of(keys.begin(), keys.end(), [&](std::string_view key) { return has(key); });
}

std::optional<double> Fields::number(std::string_view key, const Range& range) const {
  const Entry* entry = find(key);
  if (!entry) return std::nullopt;
  return read_number(reader_, *entry->value, key, range);
}

std::optional<std::int64_t> Fields::integer(std::string_view key, std::int64_t low,
                                            std::int64_t high, std::string_view alternative) const {
  const Entry* entry = find(key);
  if (!entry) return std::nullopt;
  const auto number = text::parse_integer(entry->value->text);
  if (entry->value->is_scalar() && number && number.value >= low && number.value <= high)
    return number.value;
  reader_.error(entry->value->offset, found_expected(key, *entry->value,
                                                     fmt::format("a whole number from {} to {}{}",
                                                                 low, high, alternative)));
  return std::nullopt;
}

std::optional<Vec3d> Fields::vector(std::string_view key, const Range& range) const {
  const Entry* entry = find(key);
  if (!entry) return std::nullopt;
  return read_vector(reader_, *entry->value, key, range);
}

std::optional<Vec3d> Fields::colour(std::string_view key, const Range& range) const {
  return colour(find(key), range);
}

std::optional<Vec3d> Fields::colour(const Entry* entry, const Range& range) const {
  if (!entry) return std::nullopt;
  const Node& node = *entry->value;
  if (node.is_scalar()) {
    const auto grey = read_number(reader_, node, entry->key, range);
    if (!grey) return std::nullopt;
    return Vec3d(*grey);
  }
  if (!node.is_sequence() || node.entries.size() != 3) {
    reader_.error(node.offset, found_expected(entry->key, node, "a number or a list of 3 numbers"));
    return std::nullopt;
  }
  return read_vector(reader_, node, entry->key, range);
}

std::optional<std::string> Fields::word(std::string_view key) const {
  const Entry* entry = find(key);
  if (!entry) return std::nullopt;
  if (entry->value->is_scalar() && !entry->value->text.empty()) return entry->value->text;
  reader_.error(entry->value->offset, found_expected(key, *entry->value, "a name"));
  return std::nullopt;
}

bool Fields::flag(std::string_view key, bool otherwise) const {
  static constexpr std::string_view words[] = {"true", "yes", "on", "false", "no", "off"};
  const Entry* entry = find(key);
  if (!entry) return otherwise;
  for (std::size_t i = 0; i < std::size(words); ++i)
    if (entry->value->is_scalar() && is_same_name(entry->value->text, words[i])) return i < 3;
  reader_.error(entry->value->offset, found_expected(key, *entry->value, "true or false"));
  return otherwise;
}

std::optional<std::size_t> Fields::choice(std::string_view key, Names words) const {
  const Entry* entry = find(key);
  if (!entry) return std::nullopt;
  const Node& node = *entry->value;
  for (std::size_t i = 0; i < words.size(); ++i)
    if (node.is_scalar() && is_same_name(node.text, words[i])) return i;
  reader_.error(
      node.offset,
      found_expected(key, node, one_of(words)) +
          (node.is_scalar() ? did_you_mean(node.text, {words.begin(), words.end()}) : ""));
  return std::nullopt;
}

const Node* list_under(Reader& reader, const Fields& fields, std::string_view key) {
  const Entry* entry = fields.find(key);
  if (!entry || entry->value->is_null()) return nullptr;
  if (entry->value->is_sequence()) return entry->value;
  reader.error(entry->value->offset, found_expected(key, *entry->value, "a list"));
  return nullptr;
}

}  // namespace candela::lab3
