// The directives that declare something.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "scene_io/pbrt/parser.h"
#include "scene_io/text/number.h"

namespace candela::pbrt {
namespace {

constexpr std::size_t most_defaults = 1000;  // each Attribute looks through them

// pbrt's; "seed" is the one that counts here.
constexpr std::array<std::string_view, 11> options{"disablepixeljitter",
                                                   "disabletexturefiltering",
                                                   "disablewavelengthjitter",
                                                   "displacementedgescale",
                                                   "forcediffuse",
                                                   "msereferenceimage",
                                                   "msereferenceout",
                                                   "pixelstats",
                                                   "rendercoordsys",
                                                   "seed",
                                                   "wavefront"};

constexpr const char* unnamed_material = "a material without a name: expected one in the quotes";

// pbrt reads the names of options without regard to case, '-' and '_'.
std::string normalized(std::string_view name) {
  std::string plain;
  for (const char c : name)
    if (c != '-' && c != '_') plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return plain;
}

}  // namespace

void Parser::camera() {
  auto statement = read_statement();
  if (!statement) return;
  if (is_singular(state_.transform.linear))
    return report_.error(statement->place, "the camera's transform is singular");
  keep(std::move(statement), program_.camera);
  program_.camera_from_world = state_.transform;
  program_.around_camera = state_.media.outside;
  systems_["camera"] = inverse(state_.transform);
}

void Parser::film() {
  keep(read_statement(), program_.film);
}
void Parser::sampler() {
  keep(read_statement(), program_.sampler);
}
void Parser::integrator() {
  keep(read_statement(), program_.integrator);
}
void Parser::pixel_filter() {
  keep(read_statement(), program_.filter);
}

void Parser::keep(std::optional<Statement> statement, std::optional<Statement>& kept) {
  if (!statement) return;
  if (kept && !is_in_world_)
    report_.warning(here(), fmt::format("{} is given twice; the last one counts", directive_.text));
  kept = std::move(statement);
}

// How pbrt finds its way to the picture changes nothing in it.
void Parser::accelerator() {
  (void)read_statement();
}

// A name and one value: Option "seed" 5. With a type before the name, as parameters have it, it
// counts as well.
void Parser::option() {
  const Place place{file_, tokens_->peek().offset};
  const auto declared = read_string("the name of an option");
  if (!declared) return;
  const std::string_view words = *declared;
  const std::size_t blank = words.find_last_of(" \t");
  const std::string name =
      normalized(words.substr(blank == std::string_view::npos ? 0 : blank + 1));
  const auto value = read_value(name, place);
  if (!value) return;
  if (name == "seed") return set_seed(*value);
  const bool is_known = std::find(options.begin(), options.end(), name) != options.end();
  warn_once("Option " + name, place,
            is_known ? fmt::format("the option {} is ignored", text::quoted(name))
                     : fmt::format("{} is no option of pbrt and is ignored{}", text::quoted(name),
                                   did_you_mean(name, {options.begin(), options.end()})));
}

// A number or a string; in brackets, too.
std::optional<Token> Parser::read_value(std::string_view what, const Place& place) {
  const bool is_list = tokens_->peek().kind == TokenKind::Open;
  if (is_list) tokens_->next();
  const Token value = tokens_->peek();
  const bool is_value = value.kind == TokenKind::Word || value.kind == TokenKind::String;
  if (is_value && !begins_directive(value)) {
    tokens_->next();
    if (!is_list) return value;
    if (tokens_->peek().kind == TokenKind::Close) {
      tokens_->next();
      return value;
    }
  }
  const Token token = tokens_->peek();
  const bool is_missing = token.kind == TokenKind::End || begins_directive(token);
  error(is_missing ? place.offset : token.offset,
        fmt::format("{}: found {}, expected one value of {}", directive_.text, described(token),
                    text::quoted(what)));
  skip_to_directive();
  return std::nullopt;
}

void Parser::set_seed(const Token& value) {
  const text::Number<double> number = text::parse_double(value.text);
  if (number && number.value >= 0 && number.value < 9e15 &&
      number.value == std::floor(number.value))
    program_.seed = static_cast<std::uint64_t>(number.value);
  else
    error(value.offset, fmt::format("Option \"seed\": found {}, expected an integer of at least 0",
                                    text::quoted(value.text)));
}

void Parser::color_space() {
  const Place place = here();
  const auto name = read_string("the name of a colour space");
  if (!name || *name == "srgb") return;
  const std::vector<std::string_view> others = {"srgb", "rec2020", "aces2065-1", "dci-p3"};
  if (std::find(others.begin(), others.end(), *name) == others.end())
    error(place.offset, fmt::format("{} is no colour space{}", text::quoted(*name),
                                    nearest_or_all(*name, others)));
  else
    warn_once("ColorSpace", place,
              fmt::format("the colour space {} is not supported: colours count as srgb",
                          text::quoted(*name)));
}

void Parser::attribute() {
  const Token token = tokens_->peek();
  const auto target = read_string("a target");
  if (!target) return;
  ParameterList list = read_list();
  const auto* const found = std::find(attribute_targets.begin(), attribute_targets.end(), *target);
  if (found == attribute_targets.end())
    return error(token.offset,
                 fmt::format("Attribute: found {}, expected shape, light, material, medium or "
                             "texture",
                             text::quoted(*target)));
  auto& defaults = state_.defaults[static_cast<std::size_t>(found - attribute_targets.begin())];
  for (Parameter& parameter : list) parameter.is_default = true;
  if (defaults) append_missing(*defaults, list);
  if (list.size() > most_defaults)
    return error(token.offset,
                 fmt::format("Attribute: more than {} parameters of one target", most_defaults));
  defaults = std::make_shared<const ParameterList>(std::move(list));
}

void Parser::light_source() {
  auto statement = read_statement(AttributeTarget::Light);
  if (statement) program_.lights.push_back({std::move(*statement), state_.transform});
}

void Parser::area_light_source() {
  auto statement = read_statement(AttributeTarget::Light);
  if (!statement) return;
  if (statement->type.empty()) {  // as pbrt: shapes shine no longer
    state_.area_light = none;
    return;
  }
  state_.area_light = program_.area_lights.size();
  program_.area_lights.push_back(std::move(*statement));
}

MaterialUse Parser::add_material(std::string name, Statement statement) {
  MaterialUse use{program_.materials.size(), {}, statement.place};
  program_.materials.push_back({std::move(name), std::move(statement)});
  return use;
}

void Parser::material() {
  auto statement = read_statement(AttributeTarget::Material);
  if (statement) state_.material = add_material({}, std::move(*statement));
}

void Parser::make_named_material() {
  auto statement = read_statement(AttributeTarget::Material);
  if (!statement) return;
  std::string name = std::exchange(statement->type, {});
  if (name.empty()) return report_.error(statement->place, unnamed_material);
  if (program_.material_named.contains(name))
    return report_.error(statement->place,
                         fmt::format("the material {} is defined twice", text::quoted(name)));
  program_.material_named[name] = program_.materials.size();
  (void)add_material(std::move(name), std::move(*statement));
}

void Parser::named_material() {
  const Place place{file_, tokens_->peek().offset};
  const auto name = read_string("the name of a material");
  if (name && name->empty()) return report_.error(place, unnamed_material);
  if (name) state_.material = {none, *name, place};
}

void Parser::make_named_medium() {
  auto statement = read_statement(AttributeTarget::Medium);
  if (!statement) return;
  const std::string name = std::exchange(statement->type, {});
  const Place place = statement->place;
  if (!program_.media.try_emplace(name, std::move(*statement)).second)
    report_.error(place, fmt::format("the medium {} is defined twice", text::quoted(name)));
}

void Parser::medium_interface() {
  const Place place{file_, tokens_->peek().offset};
  const auto inside = read_string("the name of a medium");
  if (!inside) return;
  state_.media = {{*inside, place}, {*inside, place}};  // a single name counts for both sides
  if (tokens_->peek().kind != TokenKind::String) return;
  const Place outside_place{file_, tokens_->peek().offset};
  const auto outside = read_string("the name of a medium");
  if (outside) state_.media.outside = {*outside, outside_place};
}

void Parser::reverse_orientation() {
  state_.is_reversed = !state_.is_reversed;
}

void Parser::texture() {
  const Place place = here();
  const auto name = read_string("the name of a texture");
  if (!name) return;
  const Token kind_token = tokens_->peek();
  const auto kind = read_string("float or spectrum");
  if (!kind) return;
  auto statement = read_statement(AttributeTarget::Texture);
  if (!statement) return;
  // pbrt-v3 says color.
  const bool is_float = *kind == "float";
  if (!is_float && *kind != "spectrum" && *kind != "color")
    return error(kind_token.offset,
                 fmt::format("Texture: found {}, expected float or spectrum", text::quoted(*kind)));
  auto& textures = is_float ? program_.float_textures : program_.spectrum_textures;
  const bool is_new =
      textures.try_emplace(*name, TextureStatement{std::move(*statement), state_.transform}).second;
  if (!is_new)
    report_.error(place,
                  fmt::format("the {} texture {} is defined twice", *kind, text::quoted(*name)));
}

void Parser::shape() {
  auto statement = read_statement(AttributeTarget::Shape);
  if (!statement) return;
  ShapeStatement shape{std::move(*statement), state_.transform,  state_.is_reversed,
                       state_.material,       state_.area_light, state_.media};
  if (is_singular(shape.world_from_object.linear))
    return report_.error(shape.statement.place,
                         "the current transform is singular and flattens this shape");
  if (is_in_object() && shape.area_light != none) {
    warn_once("instanced light", shape.statement.place,
              "area lights in objects do not shine, as in pbrt");
    shape.area_light = none;
  }
  (object_ ? *object_ : program_.shapes).push_back(std::move(shape));
}

}  // namespace candela::pbrt
