// Files, blocks and what stands behind a directive's name.

#include <fmt/format.h>

#include "scene_io/pbrt/parser.h"
#include "scene_io/text/number.h"

namespace candela::pbrt {
namespace {

constexpr std::size_t deepest = 4096;  // blocks within blocks: each keeps a state
// Each statement has a copy of them.
constexpr std::size_t most_default_bytes = std::size_t{1} << 28;

std::size_t bytes_of(const Parameter& parameter) {
  return sizeof(Parameter) + parameter.numbers.size() * sizeof(double) +
         parameter.strings.size() * sizeof(std::string);
}

}  // namespace

void Parser::error(std::size_t offset, std::string message) const {
  report_.error({file_, offset}, std::move(message));
}

void Parser::warn_once(const std::string& key, const Place& place, std::string message) {
  if (warned_.insert(key).second) report_.warning(place, std::move(message));
}

std::optional<std::string> Parser::read_string(std::string_view what) {
  const Token token = tokens_->peek();
  if (token.kind == TokenKind::String) {
    tokens_->next();
    return unescaped(token.text);
  }
  error(token.offset, fmt::format("{}: found {}, expected {} in quotes", directive_.text,
                                  described(token), what));
  skip_to_directive();
  return std::nullopt;
}

std::optional<double> Parser::read_number() {
  const Token token = tokens_->peek();
  const text::Number<double> number = token.kind == TokenKind::Word
                                          ? text::parse_double(token.text)
                                          : text::Number<double>{0, text::NumberFault::Malformed};
  if (number) {
    tokens_->next();
    return number.value;
  }
  const bool is_missing = begins_directive(token);
  error(is_missing ? directive_.offset : token.offset,
        token.kind == TokenKind::Word && !is_missing
            ? fmt::format("{}: {} {}, expected a number", directive_.text, text::quoted(token.text),
                          describe(number.fault))
            : fmt::format("{}: found {}, expected a number", directive_.text, described(token)));
  skip_to_directive();
  return std::nullopt;
}

ParameterList Parser::read_list() {
  return read_parameters(*tokens_, *file_, report_);
}

std::optional<Statement> Parser::read_statement(std::optional<AttributeTarget> target) {
  Statement statement;
  statement.directive = std::string(directive_.text);
  statement.place = {file_, tokens_->peek().offset};
  const auto type = read_string("a type");
  if (!type) return std::nullopt;
  statement.type = *type;
  statement.parameters = read_list();
  if (target) add_defaults(statement, *target);
  return statement;
}

// What Attribute gave for all, after the statement's own.
void Parser::add_defaults(Statement& statement, AttributeTarget target) {
  const auto& defaults = state_.defaults[static_cast<std::size_t>(target)];
  if (!defaults || default_bytes_ > most_default_bytes) return;
  for (const Parameter& parameter : *defaults) default_bytes_ += bytes_of(parameter);
  if (default_bytes_ > most_default_bytes)
    return error_here(
        fmt::format("Attribute gives more than {} bytes of parameters to what "
                    "follows it",
                    most_default_bytes));
  append_missing(*defaults, statement.parameters);
}

bool Parser::push(Block::Kind kind) {
  if (blocks_.size() >= deepest) {
    error_here(fmt::format("blocks lie in each other more than {} deep", deepest));
    return false;
  }
  blocks_.push_back({state_, here(), kind, directive_.text});
  return true;
}

bool Parser::pop(Block::Kind kind) {
  if (blocks_.empty() || blocks_.back().kind != kind) {
    error_here(fmt::format("{} without a begin{}", directive_.text,
                           blocks_.empty() ? "" : " in the innermost block"));
    return false;
  }
  state_ = std::move(blocks_.back().state);
  blocks_.pop_back();
  return true;
}

void Parser::attribute_begin() {
  push(Block::Kind::Attribute);
}
void Parser::attribute_end() {
  pop(Block::Kind::Attribute);
}

void Parser::object_begin() {
  const Place place = here();
  const auto name = read_string("the name of an object");
  const bool is_nested = is_in_object();
  if (!push(Block::Kind::Object)) return;
  if (is_nested) {
    ++nested_objects_;
    return report_.error(place, "ObjectBegin within an ObjectBegin, expected ObjectEnd first");
  }
  const auto [at, is_new] = program_.objects.try_emplace(name.value_or(""));
  if (name && !is_new)
    report_.error(place, fmt::format("the object {} is defined twice", text::quoted(*name)));
  object_ = &at->second;
}

void Parser::object_end() {
  if (!pop(Block::Kind::Object)) return;
  if (nested_objects_ > 0)
    --nested_objects_;
  else
    object_ = nullptr;
}

void Parser::object_instance() {
  const Place place = here();
  const auto name = read_string("the name of an object");
  if (!name) return;
  if (is_in_object())
    return report_.error(place, fmt::format("an instance of {} within an ObjectBegin: objects "
                                            "cannot be made of instances",
                                            text::quoted(*name)));
  program_.object_uses.push_back({*name, place, state_.transform});
}

void Parser::include_file(bool is_import) {
  const Place place{file_, tokens_->peek().offset};
  const auto name = read_string("the name of a file");
  if (!name) return;
  if (is_import && !push(Block::Kind::Import)) return;
  if (!files_.include(place, *name, is_import) && is_import) pop(Block::Kind::Import);
}

void Parser::include() {
  include_file(false);
}
void Parser::import() {
  include_file(true);
}

// What an imported file set ends with it.
void Parser::end_file() {
  const bool is_import = files_.current().is_import;
  files_.close();
  if (!is_import) return;
  while (!blocks_.empty() && blocks_.back().kind != Block::Kind::Import) {
    report_.error(blocks_.back().place, "this block has no end in its file");
    if (blocks_.back().kind == Block::Kind::Object) object_ = nullptr;
    blocks_.pop_back();
  }
  if (!blocks_.empty()) pop(Block::Kind::Import);
}

void Parser::world_begin() {
  is_in_world_ = true;
  state_.transform = Transform();
  state_.sets_transform = true;
  systems_["world"] = Transform();
}

// Of pbrt-v3.
void Parser::world_end() {}

}  // namespace candela::pbrt
