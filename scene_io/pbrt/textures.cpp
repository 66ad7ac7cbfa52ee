#include "scene_io/pbrt/textures.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "renderer/math/transform.h"
#include "scene_io/pbrt/spectrum.h"
#include "scene_io/text/cursor.h"

namespace candela::pbrt {
namespace {

using description::ColourInput;
using description::MappingKind;
using description::ScalarInput;
using description::UvMapping;

constexpr int deepest = 64;  // textures of textures

ScalarInput to_scalar(const ColourInput& input) {
  ScalarInput scalar;
  scalar.factor = input.factor.x;
  scalar.map = input.map;
  scalar.texture = input.texture;
  scalar.channel = input.map ? description::alpha_or_mean : 0;
  return scalar;
}

}  // namespace

// One number, as an input of another texture.
ColourInput Textures::grey(const ColourInput& input, const Place& place) {
  if (!input.map) return input;
  description::ImageTexture texture;
  texture.image = input.map;
  texture.is_scalar = true;
  return add(texture, "grey", place);
}

std::optional<ColourInput> Textures::colour(Arguments& arguments, std::string_view name) {
  const Parameter* parameter = arguments.find(
      name, {ParameterType::Rgb, ParameterType::Xyz, ParameterType::Spectrum,
             ParameterType::Blackbody, ParameterType::Texture, ParameterType::Float});
  if (!parameter) return std::nullopt;
  if (parameter->type == ParameterType::Texture) return named(Kind::Spectrum, *parameter);
  const auto constant = factor_colour(*parameter, context_.scene, context_.report);
  if (!constant) return std::nullopt;
  return ColourInput{*constant, {}, {}};
}

std::optional<ScalarInput> Textures::scalar(Arguments& arguments, std::string_view name) {
  const Parameter* parameter = arguments.find(name, {ParameterType::Float, ParameterType::Texture});
  if (!parameter) return std::nullopt;
  if (parameter->type == ParameterType::Texture) return scalar_texture(*parameter);
  const auto number = arguments.number(name);
  if (!number) return std::nullopt;
  ScalarInput input;
  input.factor = *number;
  return input;
}

std::optional<ScalarInput> Textures::scalar_texture(const Parameter& parameter) {
  const Value value = named(Kind::Float, parameter);
  if (!value) return std::nullopt;
  return to_scalar(*value);
}

ScalarInput Textures::complement(const ScalarInput& input, const Place& place) {
  ScalarInput result;
  result.factor = 1 - input.factor;
  if (input.is_constant()) return result;
  const ColourInput amount = grey({Vec3d(input.factor), input.map, input.texture}, place);
  const description::MixTexture texture{{Vec3d(1.0), {}, {}}, {Vec3d(0.0), {}, {}}, amount};
  result.factor = 1;
  result.texture = add(texture, "1 - amount", place).texture;
  return result;
}

ScalarInput Textures::square_root(const ScalarInput& input, const Place& place) {
  ScalarInput result;
  result.factor = std::sqrt(std::max(input.factor, 0.0));
  if (input.is_constant()) return result;
  const description::SquareRootTexture texture{grey({Vec3d(1.0), input.map, input.texture}, place)};
  result.texture = add(texture, "root", place).texture;
  return result;
}

ColourInput Textures::product(const ColourInput& a, const ColourInput& b, const Place& place) {
  if (a.is_constant() && b.is_constant()) return {a.factor * b.factor, {}, {}};
  const auto is_one = [](const ColourInput& c) {
    return c.is_constant() && c.factor == Vec3d(1.0);
  };
  if (is_one(a)) return b;
  if (is_one(b)) return a;
  return add(description::ProductTexture{a, b}, "product", place);
}

ScalarInput Textures::scaled(const ScalarInput& input, double factor, const Place& place) {
  ScalarInput result;
  result.factor = input.factor * factor;
  if (input.is_constant()) return result;
  const ColourInput unscaled = grey({Vec3d(1.0), input.map, input.texture}, place);
  result.factor = 1;
  result.texture = product(unscaled, {Vec3d(factor), {}, {}}, place).texture;
  return result;
}

void Textures::report_unknown(Kind kind, const Place& place, const std::string& name) const {
  const bool is_float = kind == Kind::Float;
  const auto& wanted = statements(kind);
  const auto& others = statements(is_float ? Kind::Spectrum : Kind::Float);
  const auto words = [](bool of_float) { return of_float ? "float" : "spectrum"; };
  const std::string hint =
      others.contains(name)
          ? fmt::format("; the texture of this name is a {} one", words(!is_float))
          : context_.report.did_you_mean_key(name, wanted);
  context_.report.error(
      place, fmt::format("there is no {} texture {}{}", words(is_float), text::quoted(name), hint));
}

std::map<std::string, TextureStatement>& Textures::statements(Kind kind) const {
  Program& program = context_.program;
  return kind == Kind::Float ? program.float_textures : program.spectrum_textures;
}

void Textures::check_unused() const {
  description::SceneDescription unused;
  unused.textures = context_.scene.textures;  // which handles of those that are made lead to
  Context context = context_.for_unused(unused);
  Textures textures(context);
  textures.made_ = made_;
  for (const Kind kind : {Kind::Float, Kind::Spectrum})
    for (const auto& [name, texture] : statements(kind))
      (void)textures.named(kind,
                           {ParameterType::Texture, name, texture.statement.place, {}, {name}});
}

Textures::Value Textures::named(Kind kind, const Parameter& parameter) {
  if (parameter.strings.size() != 1) {
    context_.report.error(parameter.place,
                          fmt::format("{} has {}, expected the name of one texture",
                                      text::quoted(parameter.name), describe_count(parameter)));
    return std::nullopt;
  }
  const std::string& name = parameter.strings[0];
  auto& made = made_[static_cast<std::size_t>(kind)];
  const auto known = made.find(name);
  if (known != made.end()) return known->second;
  auto& textures = statements(kind);
  const auto found = textures.find(name);
  if (found == textures.end()) {
    report_unknown(kind, parameter.place, name);
    return std::nullopt;
  }
  if (depth_ >= deepest) {
    context_.report.error(parameter.place,
                          fmt::format("textures are made of each other more than {} deep: {} "
                                      "perhaps of itself",
                                      deepest, text::quoted(name)));
    made[name] = std::nullopt;
    return std::nullopt;
  }
  ++depth_;
  Value value = make(kind, found->second, name);
  --depth_;
  return made[name] = value;
}

Textures::Value Textures::make(Kind kind, TextureStatement& texture, const std::string& name) {
  Arguments arguments(texture.statement, context_.report);
  const std::string& type = texture.statement.type;
  Value value;
  if (type == "constant")
    value = input(kind, arguments, "value", Vec3d(1.0));
  else if (type == "imagemap")
    value = image(kind, texture, arguments, name);
  else if (type == "scale")
    value = scale(kind, arguments, name);
  else if (type == "mix")
    value = mix(kind, arguments, name);
  else if (type == "directionmix")
    value = direction_mix(kind, texture, arguments, name);
  else if (type == "checkerboard")
    value = checkerboard(kind, texture, arguments, name);
  else if (type == "dots")
    value = dots(kind, texture, arguments, name);
  else if (type == "bilerp")
    value = bilerp(kind, texture, arguments, name);
  else
    return stand_in(arguments);
  arguments.warn_of_unknown();
  return arguments.has_errors() ? std::nullopt : value;
}

Textures::Value Textures::stand_in(Arguments& arguments) {
  static constexpr std::string_view others[] = {"fbm", "wrinkled", "windy", "marble", "ptex", "uv"};
  static constexpr std::string_view ours[] = {"constant",     "imagemap",     "scale", "mix",
                                              "directionmix", "checkerboard", "dots",  "bilerp"};
  const Statement& statement = arguments.statement();
  if (std::find(std::begin(others), std::end(others), statement.type) != std::end(others)) {
    context_.warn_once("texture " + statement.type, statement.place,
                       fmt::format("textures of type {} are not supported: grey (0.5) is used",
                                   text::quoted(statement.type)));
    return ColourInput{Vec3d(0.5), {}, {}};
  }
  context_.report.error(
      statement.place,
      fmt::format("{} is no texture{}", text::quoted(statement.type),
                  nearest_or_all(statement.type, {std::begin(ours), std::end(ours)})));
  return std::nullopt;
}

ColourInput Textures::input(Kind kind, Arguments& arguments, std::string_view name,
                            const Vec3d& otherwise) {
  const ColourInput constant{otherwise, {}, {}};
  if (kind == Kind::Spectrum) return colour(arguments, name).value_or(constant);
  const Parameter* parameter = arguments.find(name, {ParameterType::Float, ParameterType::Texture});
  if (!parameter) return constant;
  if (parameter->type == ParameterType::Texture)
    return grey(named(Kind::Float, *parameter).value_or(constant), parameter->place);
  return {Vec3d(arguments.number(name).value_or(otherwise.x)), {}, {}};
}

// Places are in the space that holds at the texture's directive.
UvMapping Textures::mapping(const TextureStatement& texture, Arguments& arguments) {
  const std::string kind = arguments.string("mapping").value_or("uv");
  UvMapping mapping;
  if (kind == "uv" || kind == "planar")
    mapping.offset = {arguments.number("udelta").value_or(0),
                      arguments.number("vdelta").value_or(0)};
  if (kind == "uv") {
    mapping.scale = {arguments.number("uscale").value_or(1),
                     arguments.number("vscale").value_or(1)};
    return mapping;
  }
  mapping.place_from_world = place_from_world(texture);
  if (kind == "planar") {
    mapping.kind = MappingKind::Planar;
    const Vec3d v1 = arguments.point("v1").value_or(Vec3d(1, 0, 0));
    const Vec3d v2 = arguments.point("v2").value_or(Vec3d(0, 1, 0));
    const Mat3d rows(v1, v2, Vec3d(0.0));
    mapping.place_from_world =
        Transform{glm::transpose(rows), Vec3d(0.0)} * mapping.place_from_world;
    return mapping;
  }
  if (kind == "spherical")
    mapping.kind = MappingKind::Spherical;
  else if (kind == "cylindrical")
    mapping.kind = MappingKind::Cylindrical;
  else
    arguments.error(
        *arguments.find("mapping"),
        fmt::format("is {}, expected uv, planar, spherical or cylindrical", text::quoted(kind)));
  return mapping;
}

Transform Textures::place_from_world(const TextureStatement& texture) {
  if (!is_singular(texture.world_from_texture.linear)) return inverse(texture.world_from_texture);
  context_.report.error(texture.statement.place, "the transform of this texture is singular");
  return {};
}

// pbrt-v3 names the two factors tex1 and tex2, and so does candela where the second is a colour or
// one of them an image whose values are to be multiplied as they come out.
Textures::Value Textures::scale(Kind kind, Arguments& arguments, const std::string& name) {
  const bool is_product = arguments.has("tex1");
  if (is_product) arguments.accept({"tex", "scale"});
  description::ProductTexture texture;
  texture.first = input(kind, arguments, is_product ? "tex1" : "tex", Vec3d(1.0));
  if (arguments.flag("root", false))  // candela's own
    return add(description::SquareRootTexture{texture.first}, name, arguments.statement().place);
  texture.second = is_product ? input(kind, arguments, "tex2", Vec3d(1.0))
                              : input(Kind::Float, arguments, "scale", Vec3d(1.0));
  if (texture.first.is_constant() && texture.second.is_constant())
    return ColourInput{texture.first.factor * texture.second.factor, {}, {}};
  const Place& place = arguments.statement().place;
  if (!is_product) {
    if (const auto image = scaled_image(texture.first, texture.second, name, place)) return *image;
    if (kind == Kind::Float)
      if (const auto image = scaled_image(texture.second, texture.first, name, place))
        return *image;
  }
  return add(texture, name, place);
}

// As pbrt has it: a number scales what an image holds, before that is inverted or clamped.
Textures::Value Textures::scaled_image(const ColourInput& input, const ColourInput& scale,
                                       const std::string& name, const Place& place) {
  if (!scale.is_constant()) return std::nullopt;
  description::ImageTexture image;
  if (input.map) {
    image.image = input.map;
  } else {
    if (!input.texture) return std::nullopt;
    const auto& textures = context_.scene.textures;
    const auto* known = std::get_if<description::ImageTexture>(&textures[input.texture.index].kind);
    if (!known) return std::nullopt;
    image = *known;
  }
  image.factor *= scale.factor.x;
  return add(image, name, place);
}

Textures::Value Textures::mix(Kind kind, Arguments& arguments, const std::string& name) {
  description::MixTexture texture;
  texture.first = input(kind, arguments, "tex1", Vec3d(0.0));
  texture.second = input(kind, arguments, "tex2", Vec3d(1.0));
  texture.amount = input(Kind::Float, arguments, "amount", Vec3d(0.5));
  return add(texture, name, arguments.statement().place);
}

Textures::Value Textures::direction_mix(Kind kind, const TextureStatement& statement,
                                        Arguments& arguments, const std::string& name) {
  description::DirectionMixTexture texture;
  texture.first = input(kind, arguments, "tex1", Vec3d(0.0));
  texture.second = input(kind, arguments, "tex2", Vec3d(1.0));
  const Vec3d along = arguments.point("dir").value_or(Vec3d(0, 1, 0));
  const Vec3d direction = statement.world_from_texture.vector(along);
  const double size = max_component(glm::abs(direction));
  if (!(size > 0 && std::isfinite(size))) {
    context_.report.error(
        arguments.statement().place,
        fmt::format("\"dir\" is [{}, {}, {}], expected a direction", along.x, along.y, along.z));
    return std::nullopt;
  }
  texture.direction = normalize(direction / size);
  return add(texture, name, arguments.statement().place);
}

Textures::Value Textures::checkerboard(Kind kind, const TextureStatement& statement,
                                       Arguments& arguments, const std::string& name) {
  const ColourInput even = input(kind, arguments, "tex1", Vec3d(1.0));
  const ColourInput odd = input(kind, arguments, "tex2", Vec3d(0.0));
  arguments.accept({"aamode"});  // pbrt-v3
  const Place& place = arguments.statement().place;
  const auto dimension = arguments.integer("dimension").value_or(2);
  if (dimension != 2 && dimension != 3)
    arguments.error(*arguments.find("dimension"), fmt::format("is {}, expected 2 or 3", dimension));
  if (dimension == 3)
    return add(description::SolidCheckerboardTexture{place_from_world(statement), even, odd}, name,
               place);
  return add(description::CheckerboardTexture{mapping(statement, arguments), even, odd}, name,
             place);
}

Textures::Value Textures::dots(Kind kind, const TextureStatement& statement, Arguments& arguments,
                               const std::string& name) {
  description::DotsTexture texture;
  texture.mapping = mapping(statement, arguments);
  texture.inside = input(kind, arguments, "inside", Vec3d(1.0));
  texture.outside = input(kind, arguments, "outside", Vec3d(0.0));
  return add(texture, name, arguments.statement().place);
}

Vec3d Textures::corner(Kind kind, Arguments& arguments, std::string_view name, double otherwise) {
  const ColourInput value = input(kind, arguments, name, Vec3d(otherwise));
  if (!value.is_constant())
    arguments.warning(*arguments.find(name), "is no constant: white is used");
  return value.factor;
}

Textures::Value Textures::bilerp(Kind kind, const TextureStatement& statement, Arguments& arguments,
                                 const std::string& name) {
  description::BilinearTexture texture;
  texture.mapping = mapping(statement, arguments);
  texture.v00 = corner(kind, arguments, "v00", 0);
  texture.v01 = corner(kind, arguments, "v01", 1);
  texture.v10 = corner(kind, arguments, "v10", 0);
  texture.v11 = corner(kind, arguments, "v11", 1);
  return add(texture, name, arguments.statement().place);
}

}  // namespace candela::pbrt
