#include "scene_io/pbrt/parse.h"

#include <fmt/format.h>

#include "scene_io/pbrt/parser.h"

namespace candela::pbrt {

void Parser::statement(const Token& directive) {
  directive_ = directive;
  const Directive* const known = known_directive();
  if (!known) return skip_to_directive();
  directive_.text = known->name;
  (this->*known->read)();
}

// What is misspelled is read as what it means, so that blocks end and the world begins. After an
// error null where it means nothing.
const Directive* Parser::known_directive() {
  if (begins_directive(directive_)) {
    const Directive* const known = directive_named(directive_.text);
    check_side_of_world(*known);
    return known;
  }
  error_here(fmt::format("found {}, expected a directive{}", described(directive_),
                         did_you_mean(directive_.text, directive_names())));
  const bool is_word = directive_.kind == TokenKind::Word;
  return is_word ? directive_named(nearest_name(directive_.text, directive_names())) : nullptr;
}

// A missing WorldBegin is said once.
void Parser::check_side_of_world(const Directive& directive) {
  if (directive.where == Directive::Where::BeforeWorld && is_in_world_)
    error_here(fmt::format("{} after WorldBegin", directive.name));
  if (directive.where != Directive::Where::InWorld || is_in_world_ || lacks_world_) return;
  lacks_world_ = true;
  error_here(fmt::format("{} before WorldBegin", directive.name));
}

// Where something begins that this file format knows; what lies between was part of what is wrong.
void Parser::skip_to_directive() {
  for (Token token = tokens_->peek(); token.kind != TokenKind::End; token = tokens_->peek()) {
    if (begins_directive(token)) return;
    tokens_->next();
  }
}

Program Parser::parse() {
  while (!files_.is_done() && !report_.is_full()) {
    file_ = files_.current().file;
    tokens_ = &files_.current().tokens;
    const Token token = tokens_->next();
    if (token.kind == TokenKind::End)
      end_file();
    else
      statement(token);
  }
  if (report_.is_full()) return std::move(program_);
  for (const Block& block : blocks_)
    report_.error(block.place, fmt::format("this {} has no end", block.directive));
  if (!is_in_world_ && !report_.diagnostics().has_errors())
    report_.error({file_, 0}, "there is no WorldBegin: expected a scene of pbrt-v4");
  program_.files = files_.paths();
  return std::move(program_);
}

Program parse(SourceFiles& files, const Report& report) {
  return Parser(files, report).parse();
}

}  // namespace candela::pbrt
