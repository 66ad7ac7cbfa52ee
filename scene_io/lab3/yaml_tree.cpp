#include "scene_io/lab3/yaml_tree.h"

#include <algorithm>
#include <istream>
#include <new>
#include <streambuf>
#include <unordered_map>

#include <fmt/format.h>
#include <yaml-cpp/emitterstyle.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include "scene_io/text/line_begins.h"

namespace candela::lab3 {
namespace {

// Thrown through yaml-cpp's parser to stop it.
struct Refusal {
  std::size_t offset = 0;
  std::string message;
};
struct SecondDocument {
  std::size_t offset = 0;
};

// yaml-cpp's marks hold line and column (bytes) from 0; its position counts otherwise where line
// ends are foreign.
class LineTable {
 public:
  explicit LineTable(std::string_view text) : text_(text), begins_(text) {}
  [[nodiscard]] std::size_t offset(const YAML::Mark& mark) const {
    if (mark.line < 0) return 0;
    const std::size_t line = std::min(static_cast<std::size_t>(mark.line), begins_.count() - 1);
    const std::size_t end = line + 1 < begins_.count() ? begins_[line + 1] - 1 : text_.size();
    return std::min(begins_[line] + static_cast<std::size_t>(std::max(mark.column, 0)), end);
  }
  // The '-' of an empty entry of a list, behind which only blanks and comments stand before
  // `offset`.
  [[nodiscard]] std::size_t dash_before(std::size_t offset) const {
    for (std::size_t end = offset; end > 0;) {
      const std::size_t begin = text_.rfind('\n', end - 1) + 1;  // npos + 1 is 0
      const std::string_view line = text_.substr(begin, end - begin);
      const std::size_t dash = line.substr(0, line.find_first_not_of(" \t-")).rfind('-');
      if (dash != std::string_view::npos) return begin + dash;
      end = begin == 0 ? 0 : begin - 1;
    }
    return offset;
  }
  // Where a value stands whose tags and anchors (!!str, &a) begin at `offset`.
  [[nodiscard]] std::size_t behind_properties(std::size_t offset) const {
    while (offset < text_.size() && (text_[offset] == '!' || text_[offset] == '&')) {
      offset = std::min(text_.find_first_of(" \t\r\n", offset), text_.size());
      offset = std::min(text_.find_first_not_of(" \t\r\n", offset), text_.size());
    }
    return offset;
  }
  // Whether a quote that nothing closes begins at `offset`.
  [[nodiscard]] bool has_unclosed_quote(std::size_t offset) const {
    offset = behind_properties(offset);
    const char quote = offset < text_.size() ? text_[offset] : '\0';
    if (quote != '"' && quote != '\'') return false;
    const std::string_view escape = quote == '"' ? "\\" : "''";
    for (std::size_t i = offset + 1; i < text_.size(); ++i) {
      if (text_.substr(i).starts_with(escape))
        ++i;
      else if (text_[i] == quote)
        return false;
    }
    return true;
  }

 private:
  std::string_view text_;
  text::LineBegins begins_;
};

// A stream over memory that is not copied.
class ViewBuffer : public std::streambuf {
 public:
  explicit ViewBuffer(std::string_view text) {
    char* begin = const_cast<char*>(text.data());  // get area only: never written
    setg(begin, begin, begin + text.size());
  }
};

std::size_t saturated_sum(std::size_t a, std::size_t b) {
  return std::min(a + b, 2 * max_yaml_nodes);  // neither exceeds the bound: no overflow
}

class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(const LineTable& lines, Document& document) : lines_(lines), document_(document) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (document_.root) throw SecondDocument{lines_.offset(mark)};
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    Node& node = add(Node::Kind::Null, mark, anchor);
    // The mark is that of what follows; the place of a value that is not there is its key's or its
    // dash's.
    if (!open_.empty() && open_.back().pending_key)
      node.offset = open_.back().pending_key->offset;
    else if (!open_.empty() && open_.back().has_dashes)
      node.offset = lines_.dash_before(node.offset);
    attach(node);
  }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                const std::string& value) override {
    Node& node = add(Node::Kind::Scalar, mark, anchor);
    node.text = value;
    last_scalar_offset_ = node.offset;
    attach(node);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    const std::size_t offset = lines_.offset(mark);
    if (found == anchors_.end()) throw Refusal{offset, "an alias without its anchor"};
    for (const Level& level : open_)
      if (level.node == found->second)
        throw Refusal{offset, "found an alias of the node that it stands in, which has no end"};
    attach(*found->second, offset);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) override {
    open(Node::Kind::Sequence, mark, anchor);
    open_.back().has_dashes = style == YAML::EmitterStyle::Block;
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(Node::Kind::Map, mark, anchor);
  }
  void OnMapEnd() override { close(); }

  // yaml-cpp takes the text's end for the quote's, where it stands at the begin of a line.
  void refuse_unclosed_quote() const {
    if (lines_.has_unclosed_quote(last_scalar_offset_))
      throw Refusal{last_scalar_offset_,
                    "this quote is not closed, expected the same mark behind its text"};
  }

 private:
  struct Level {
    Node* node = nullptr;
    const Node* pending_key = nullptr;
    bool has_dashes = false;  // a list whose entries stand behind '-'
  };

  Node& add(Node::Kind kind, const YAML::Mark& mark, YAML::anchor_t anchor) {
    const std::size_t offset = lines_.offset(mark);
    if (document_.nodes.size() >= max_yaml_nodes)
      throw Refusal{offset, fmt::format("the file has more than {} values", max_yaml_nodes)};
    Node& node = document_.nodes.emplace_back();
    node.kind = kind;
    node.offset = offset;
    if (anchor != YAML::NullAnchor) anchors_[anchor] = &node;
    return node;
  }

  void open(Node::Kind kind, const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (open_.size() >= max_yaml_depth)
      throw Refusal{lines_.offset(mark),
                    fmt::format("values are nested more than {} levels deep", max_yaml_depth)};
    open_.push_back({&add(kind, mark, anchor), nullptr, false});
  }

  void close() {
    const Node& node = *open_.back().node;
    open_.pop_back();
    attach(node);
  }

  void attach(const Node& value) { attach(value, value.offset); }

  // `place` is that of the alias, where the value is one.
  void attach(const Node& value, std::size_t place) {
    if (open_.empty()) {
      document_.root = &value;
      return;
    }
    Level& level = open_.back();
    if (level.node->is_map() && !level.pending_key) {
      if (!value.is_scalar())
        throw Refusal{value.offset, "found a value where the name of a key was expected"};
      level.pending_key = &value;
      return;
    }
    Entry entry;
    entry.value = &value;
    if (level.pending_key) {
      entry.key = level.pending_key->text;
      entry.key_offset = level.pending_key->offset;
      level.pending_key = nullptr;
    }
    grow(*level.node, value, place);
    level.node->entries.push_back(std::move(entry));
  }

  static void grow(Node& parent, const Node& child, std::size_t place) {
    parent.expanded_nodes = saturated_sum(parent.expanded_nodes, child.expanded_nodes);
    parent.height = std::max(parent.height, child.height + 1);
    if (parent.expanded_nodes > max_yaml_nodes)
      throw Refusal{place,
                    fmt::format("the file stands for more than {} values, once its aliases are "
                                "followed",
                                max_yaml_nodes)};
    if (parent.height > max_yaml_depth)
      throw Refusal{place, fmt::format("values are nested more than {} levels deep, once "
                                       "aliases are followed",
                                       max_yaml_depth)};
  }

  const LineTable& lines_;
  Document& document_;
  std::size_t last_scalar_offset_ = 0;
  std::vector<Level> open_;
  std::unordered_map<YAML::anchor_t, const Node*> anchors_;
};

bool is_control_character(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7f;
}

// What would make the scanner slow or hungry, or is no text at all.
std::optional<Refusal> refuse_early(std::string_view text) {
  if (text.size() > max_yaml_bytes)
    return Refusal{0, fmt::format("the file has {} bytes, more than the {} that are read",
                                  text.size(), max_yaml_bytes)};
  std::size_t line_begin = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (is_control_character(text[i]))
      return Refusal{i, fmt::format("found the byte 0x{:02x}, expected a text file",
                                    static_cast<unsigned>(static_cast<unsigned char>(text[i])))};
    if (text[i] == '\n') line_begin = i + 1;
    if (i + 1 - line_begin > max_yaml_line_bytes)
      return Refusal{line_begin,
                     fmt::format("this line has more than {} bytes", max_yaml_line_bytes)};
  }
  return std::nullopt;
}

// What stands before `offset` in its line.
std::string_view line_before(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  return before.substr(before.rfind('\n') + 1);  // npos + 1 is 0
}

bool begins_line(std::string_view text, std::size_t offset) {
  return line_before(text, offset).find_first_not_of(" \t") == std::string_view::npos;
}

// Whether a tab stands before the first word of the line around `offset`, or behind a '-' there.
bool has_tab_in_indentation(std::string_view text, std::size_t offset) {
  const std::string_view line = line_before(text, offset);
  return line.substr(0, line.find_first_not_of(" \t-")).find('\t') != std::string_view::npos;
}

// Of text that is none without quotes.
std::string_view hint_of_quotes(const std::string& reason, std::string_view text,
                                std::size_t offset) {
  const char found = offset < text.size() ? text[offset] : '\0';
  if (reason == YAML::ErrorMsg::UNKNOWN_TOKEN && (found == '@' || found == '`'))
    return "; what begins with '@' or '`' is written in quotes";
  const bool is_second_colon = line_before(text, offset).find(": ") != std::string_view::npos;
  if (reason == YAML::ErrorMsg::MAP_VALUE && is_second_colon)
    return "; what holds ': ' is written in quotes";
  return "";
}

// yaml-cpp looks at the words behind a tab before it sees that they are badly indented.
std::string hint_for(const std::string& reason, std::string_view text, std::size_t offset) {
  if (reason == YAML::ErrorMsg::TAB_IN_INDENTATION) return "; indent with blanks";
  if (reason == YAML::ErrorMsg::END_OF_SEQ_FLOW) return ", expected ']' or ','";
  if (reason == YAML::ErrorMsg::END_OF_MAP_FLOW) return ", expected '}' or ','";
  const bool is_seq = reason == YAML::ErrorMsg::END_OF_SEQ;
  if ((is_seq || reason == YAML::ErrorMsg::END_OF_MAP) && !begins_line(text, offset))
    return ": expected the line's end behind a value (quotes within quotes are written twice)";
  if (is_seq) return ", expected '-' or a key as far in as those above";
  if (reason == YAML::ErrorMsg::END_OF_MAP) return ", expected a key as far in as those above";
  if (has_tab_in_indentation(text, offset)) return " behind a tab; indent with blanks";
  return std::string(hint_of_quotes(reason, text, offset));
}

void build(std::string_view text, const LineTable& lines, Document& document) {
  ViewBuffer buffer(text);
  std::istream stream(&buffer);
  YAML::Parser parser(stream);
  TreeBuilder builder(lines, document);
  try {
    if (parser.HandleNextDocument(builder)) parser.HandleNextDocument(builder);
  } catch (const YAML::Exception&) {
    builder.refuse_unclosed_quote();  // which is why a list's or a map's end was not found
    throw;
  }
  builder.refuse_unclosed_quote();
}

}  // namespace

std::optional<Document> parse_yaml(const text::Source& source, Diagnostics& diagnostics) {
  const auto refuse = [&](std::size_t offset, std::string message) {
    diagnostics.add(text::diagnose(source, offset, Severity::Error, std::move(message)));
    return std::nullopt;
  };
  if (const auto refusal = refuse_early(source.text))
    return refuse(refusal->offset, refusal->message);
  const LineTable lines(source.text);
  std::optional<Document> document(std::in_place);
  try {
    build(source.text, lines, *document);
  } catch (const Refusal& refusal) {
    return refuse(refusal.offset, refusal.message);
  } catch (const SecondDocument& second) {
    diagnostics.add(text::diagnose(source, second.offset, Severity::Warning,
                                   "a second document begins here: only the first is read"));
  } catch (const YAML::Exception& exception) {
    const std::size_t offset = lines.offset(exception.mark);
    return refuse(offset, fmt::format("malformed YAML: {}{}", exception.msg,
                                      hint_for(exception.msg, source.text, offset)));
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& exception) {
    return refuse(0, fmt::format("malformed YAML: {}", exception.what()));
  }
  if (!document->root) return refuse(0, "the file is empty, expected a scene");
  return document;
}

}  // namespace candela::lab3
