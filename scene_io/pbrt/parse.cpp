#include "scene_io/pbrt/parse.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "scene_io/pbrt/parser.h"

namespace candela::pbrt {
namespace {

enum class Where : std::uint8_t { Anywhere, BeforeWorld, InWorld };

struct Directive {
  std::string_view name;
  void (Parser::*read)();
  Where where = Where::Anywhere;
};

// TransformBegin is AttributeBegin in pbrt-v4. SurfaceIntegrator, VolumeIntegrator, Renderer and
// WorldEnd are of earlier versions.
constexpr std::array<Directive, 44> directives{
    {{"Accelerator", &Parser::accelerator},
     {"ActiveTransform", &Parser::active_transform},
     {"AreaLightSource", &Parser::area_light_source, Where::InWorld},
     {"Attribute", &Parser::attribute},
     {"AttributeBegin", &Parser::attribute_begin, Where::InWorld},
     {"AttributeEnd", &Parser::attribute_end, Where::InWorld},
     {"Camera", &Parser::camera, Where::BeforeWorld},
     {"ColorSpace", &Parser::color_space},
     {"ConcatTransform", &Parser::concat_transform},
     {"CoordSysTransform", &Parser::coord_sys_transform},
     {"CoordinateSystem", &Parser::coordinate_system},
     {"Film", &Parser::film, Where::BeforeWorld},
     {"Identity", &Parser::identity},
     {"Import", &Parser::import, Where::InWorld},
     {"Include", &Parser::include},
     {"Integrator", &Parser::integrator, Where::BeforeWorld},
     {"LightSource", &Parser::light_source, Where::InWorld},
     {"LookAt", &Parser::look_at},
     {"MakeNamedMaterial", &Parser::make_named_material, Where::InWorld},
     {"MakeNamedMedium", &Parser::make_named_medium},
     {"Material", &Parser::material, Where::InWorld},
     {"MediumInterface", &Parser::medium_interface},
     {"NamedMaterial", &Parser::named_material, Where::InWorld},
     {"ObjectBegin", &Parser::object_begin, Where::InWorld},
     {"ObjectEnd", &Parser::object_end, Where::InWorld},
     {"ObjectInstance", &Parser::object_instance, Where::InWorld},
     {"Option", &Parser::option},
     {"PixelFilter", &Parser::pixel_filter, Where::BeforeWorld},
     {"Renderer", &Parser::accelerator, Where::BeforeWorld},
     {"ReverseOrientation", &Parser::reverse_orientation, Where::InWorld},
     {"Rotate", &Parser::rotate},
     {"Sampler", &Parser::sampler, Where::BeforeWorld},
     {"Scale", &Parser::scale},
     {"Shape", &Parser::shape, Where::InWorld},
     {"SurfaceIntegrator", &Parser::integrator, Where::BeforeWorld},
     {"Texture", &Parser::texture, Where::InWorld},
     {"Transform", &Parser::transform},
     {"TransformBegin", &Parser::attribute_begin, Where::InWorld},
     {"TransformEnd", &Parser::attribute_end, Where::InWorld},
     {"TransformTimes", &Parser::transform_times, Where::BeforeWorld},
     {"Translate", &Parser::translate},
     {"VolumeIntegrator", &Parser::accelerator, Where::BeforeWorld},
     {"WorldBegin", &Parser::world_begin, Where::BeforeWorld},
     {"WorldEnd", &Parser::world_end}}};

const Directive* find(std::string_view name) {
  const auto found =
      std::find_if(directives.begin(), directives.end(),
                   [&](const Directive& directive) { return directive.name == name; });
  return found == directives.end() ? nullptr : &*found;
}

std::vector<std::string_view> names() {
  std::vector<std::string_view> all;
  for (const Directive& directive : directives) all.push_back(directive.name);
  return all;
}

}  // namespace

void Parser::statement(const Token& directive) {
  directive_ = directive;
  const Directive* known = directive.kind == TokenKind::Word ? find(directive.text) : nullptr;
  if (!known) {
    const std::string_view word = directive.text.substr(0, 100);
    if (directive.kind == TokenKind::Broken)
      error_here("a quote that is not closed on its line");
    else
      error_here(fmt::format("found {}, expected a directive{}", text::quoted(directive.text),
                             did_you_mean(word, names())));
    return skip_to_directive();
  }
  if (known->where == Where::InWorld && !is_in_world_)
    error_here(fmt::format("{} before WorldBegin", known->name));
  if (known->where == Where::BeforeWorld && is_in_world_)
    error_here(fmt::format("{} after WorldBegin", known->name));
  (this->*known->read)();
}

// Where something begins that this file format knows; what lies between was part of what is wrong.
void Parser::skip_to_directive() {
  for (Token token = tokens_->peek(); token.kind != TokenKind::End; token = tokens_->peek()) {
    if (token.kind == TokenKind::Word && find(token.text)) return;
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
    report_.error(block.place, fmt::format("this {} has no end", block.kind == Block::Kind::Object
                                                                     ? "ObjectBegin"
                                                                     : "AttributeBegin"));
  if (!is_in_world_ && !report_.diagnostics().has_errors())
    report_.error({file_, 0}, "there is no WorldBegin: expected a scene of pbrt-v4");
  program_.files = files_.paths();
  return std::move(program_);
}

Program parse(SourceFiles& files, const Report& report) {
  return Parser(files, report).parse();
}

}  // namespace candela::pbrt
