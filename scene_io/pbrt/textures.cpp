#include "scene_io/pbrt/textures.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "scene_io/pbrt/source_files.h"
#include "scene_io/pbrt/spectrum.h"
#include "scene_io/text/cursor.h"

namespace candela::pbrt {
namespace {

using description::ColourInput;
using description::Encoding;
using description::ImageHandle;
using description::ScalarInput;
using description::TextureHandle;
using description::UvMapping;
using description::Wrap;

constexpr int deepest = 64;  // textures of textures

bool has_extension(std::string_view name, std::string_view extension) {
  return name.size() > extension.size() &&
         text::equal_ignoring_case(name.substr(name.size() - extension.size()), extension);
}

bool is_constant(const ColourInput& input) {
  return !input.map && !input.texture;
}

Wrap wrap_of(Arguments& arguments) {
  const Parameter* parameter = arguments.find("wrap", {ParameterType::String});
  if (!parameter || parameter->strings.size() != 1 || parameter->strings[0] == "repeat")
    return Wrap::Repeat;
  if (parameter->strings[0] == "black") return Wrap::Black;
  if (parameter->strings[0] == "clamp") return Wrap::Clamp;
  if (parameter->strings[0] == "mirror") return Wrap::Mirror;  // candela's own
  arguments.warning(*parameter, fmt::format("{} is none of repeat, black and clamp: it is repeated",
                                            text::quoted(parameter->strings[0])));
  return Wrap::Repeat;
}

// Only PNG files are as "encoding" says.
Encoding encoding_of(Arguments& arguments, std::string_view file_name) {
  const Parameter* parameter = arguments.find("encoding", {ParameterType::String});
  if (!parameter || parameter->strings.size() != 1 || !has_extension(file_name, ".png"))
    return encoding_of_file(file_name);
  const auto encoding = encoding_named(parameter->strings[0]);
  if (!encoding)
    arguments.warning(*parameter, fmt::format("{} is not supported: it counts as sRGB",
                                              text::quoted(parameter->strings[0])));
  return encoding.value_or(Encoding::Srgb);
}

std::vector<std::string_view> names_of(const std::map<std::string, TextureStatement>& textures) {
  std::vector<std::string_view> names;
  for (const auto& [name, texture] : textures) names.push_back(name);
  return names;
}

ScalarInput to_scalar(const ColourInput& input) {
  ScalarInput scalar;
  scalar.factor = input.factor.x;
  scalar.map = input.map;
  scalar.texture = input.texture;
  // As in pbrt: alpha of images that have it.
  scalar.channel = input.map ? description::alpha_or_first : 0;
  return scalar;
}

}  // namespace

std::string_view name_of(Encoding encoding) {
  switch (encoding) {
    case Encoding::Linear:
      return "linear";
    case Encoding::Srgb:
      return "sRGB";
    case Encoding::LabGamma:
      return "gamma 2.2";
  }
  return "linear";
}

std::optional<Encoding> encoding_named(std::string_view name) {
  for (const Encoding encoding : {Encoding::Linear, Encoding::Srgb, Encoding::LabGamma})
    if (name_of(encoding) == name) return encoding;
  return std::nullopt;
}

Encoding encoding_of_file(std::string_view name) {
  const bool is_linear =
      has_extension(name, ".exr") || has_extension(name, ".hdr") || has_extension(name, ".pfm");
  return is_linear ? Encoding::Linear : Encoding::Srgb;
}

ImageHandle add_image(Context& context, const Parameter& file, Encoding encoding, Wrap wrap) {
  if (file.strings.size() != 1) {
    context.report.error(file.place, "expected the name of one image file");
    return {};
  }
  const std::string path =
      resolve_file(context.scene.path, file.place, file.strings[0], context.report);
  std::error_code failed;
  const auto status = std::filesystem::status(path, failed);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    context.report.error(file.place, fmt::format("{} is no regular file; expected an image",
                                                 text::quoted_path(path)));
    return {};
  }
  auto& images = context.scene.images;
  const auto same = std::find_if(images.begin(), images.end(), [&](const auto& image) {
    return image.path == path && image.encoding == encoding && image.wrap == wrap;
  });
  if (same != images.end()) return ImageHandle(static_cast<std::size_t>(same - images.begin()));
  images.push_back({path, encoding, wrap, file.place.span()});
  return ImageHandle(images.size() - 1);
}

template <class Texture>
ColourInput Textures::add(Texture kind, const std::string& name, const Place& place) {
  auto& textures = context_.scene.textures;
  textures.push_back({name, place.span(), std::move(kind)});
  ColourInput input;
  input.texture = TextureHandle(textures.size() - 1);
  return input;
}

std::optional<ColourInput> Textures::colour(Arguments& arguments, std::string_view name) {
  const Parameter* parameter = arguments.find(
      name, {ParameterType::Rgb, ParameterType::Xyz, ParameterType::Spectrum,
             ParameterType::Blackbody, ParameterType::Texture, ParameterType::Float});
  if (!parameter) return std::nullopt;
  if (parameter->type == ParameterType::Texture) return named(Kind::Spectrum, *parameter);
  const auto constant = factor_colour(*parameter, context_.scene.path, context_.report);
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
  if (!input.map && !input.texture) return result;
  const ColourInput amount{Vec3d(input.factor), input.map, input.texture};
  const description::MixTexture texture{{Vec3d(1.0), {}, {}}, {Vec3d(0.0), {}, {}}, amount};
  result.factor = 1;
  result.texture = add(texture, "1 - amount", place).texture;
  return result;
}

void Textures::set_heights(Arguments& arguments, description::Material& material) {
  if (set_own_heights(arguments, material)) return;
  const Parameter* parameter =
      arguments.find("displacement", {ParameterType::Texture, ParameterType::Float});
  if (!parameter) parameter = arguments.find("bumpmap", {ParameterType::Texture});  // pbrt-v3
  if (!parameter || parameter->type != ParameterType::Texture) return;
  const auto heights = scalar_texture(*parameter);
  if (!heights) return;
  material.height = heights->map;
  material.height_texture = heights->texture;
  material.height_scale = heights_are_lengths;
}

// candela's own: heights in the unit that it has.
bool Textures::set_own_heights(Arguments& arguments, description::Material& material) {
  const Parameter* parameter = arguments.find("heights", {ParameterType::Texture});
  if (!parameter) return false;
  arguments.accept({"displacement"});
  material.height_scale = arguments.number("heightscale").value_or(1);
  const auto heights = scalar_texture(*parameter);
  if (!heights) return true;
  material.height = heights->map;
  material.height_texture = heights->texture;
  return true;
}

ImageHandle Textures::normal_map(Arguments& arguments) {
  const Parameter* file = arguments.find("normalmap", {ParameterType::String});
  return file ? add_image(context_, *file, Encoding::Linear, Wrap::Repeat) : ImageHandle();
}

Textures::Value Textures::named(Kind kind, const Parameter& parameter) {
  if (parameter.strings.size() != 1) {
    context_.report.error(parameter.place, "expected the name of one texture");
    return std::nullopt;
  }
  const std::string& name = parameter.strings[0];
  auto& made = made_[static_cast<std::size_t>(kind)];
  const auto known = made.find(name);
  if (known != made.end()) return known->second;
  auto& textures =
      kind == Kind::Float ? context_.program.float_textures : context_.program.spectrum_textures;
  const auto found = textures.find(name);
  if (found == textures.end()) {
    context_.report.error(
        parameter.place,
        fmt::format("there is no {} texture {}{}", kind == Kind::Float ? "float" : "spectrum",
                    text::quoted(name),
                    did_you_mean(std::string_view(name).substr(0, 100), names_of(textures))));
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
    value = image(arguments, name);
  else if (type == "scale")
    value = product(kind, arguments, name);
  else if (type == "mix" || type == "directionmix")
    value = mix(kind, arguments, name);
  else if (type == "checkerboard")
    value = checkerboard(kind, arguments, name);
  else if (type == "dots")
    value = dots(kind, arguments, name);
  else if (type == "bilerp")
    value = bilerp(kind, arguments, name);
  else
    return stand_in(arguments);
  arguments.warn_of_unknown();
  return value;
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
  const std::string_view word = std::string_view(statement.type).substr(0, 100);
  context_.report.error(statement.place,
                        fmt::format("{} is no texture{}", text::quoted(statement.type),
                                    did_you_mean(word, {std::begin(ours), std::end(ours)})));
  return std::nullopt;
}

ColourInput Textures::input(Kind kind, Arguments& arguments, std::string_view name,
                            const Vec3d& otherwise) {
  const ColourInput constant{otherwise, {}, {}};
  if (kind == Kind::Spectrum) return colour(arguments, name).value_or(constant);
  const Parameter* parameter = arguments.find(name, {ParameterType::Float, ParameterType::Texture});
  if (!parameter) return constant;
  if (parameter->type == ParameterType::Texture)
    return named(Kind::Float, *parameter).value_or(constant);
  return {Vec3d(arguments.number(name).value_or(otherwise.x)), {}, {}};
}

UvMapping Textures::mapping(Arguments& arguments) {
  const Parameter* kind = arguments.find("mapping", {ParameterType::String});
  arguments.accept({"v1", "v2"});
  UvMapping mapping;
  mapping.scale = {arguments.number("uscale").value_or(1), arguments.number("vscale").value_or(1)};
  mapping.offset = {arguments.number("udelta").value_or(0), arguments.number("vdelta").value_or(0)};
  if (kind && kind->strings.size() == 1 && kind->strings[0] != "uv")
    context_.warn_once("mapping " + kind->strings[0], kind->place,
                       fmt::format("the mapping {} is not supported: the surface's uv are used",
                                   text::quoted(kind->strings[0])));
  return mapping;
}

Textures::Value Textures::image(Arguments& arguments, const std::string& name) {
  const Parameter* file = arguments.find("filename", {ParameterType::String});
  // All maps are filtered by the footprint; pbrt-v3's spellings.
  arguments.accept({"filter", "maxanisotropy", "trilinear", "gamma"});
  const Wrap wrap = wrap_of(arguments);
  const Encoding encoding =
      encoding_of(arguments, file && file->strings.size() == 1 ? file->strings[0] : "");
  description::ImageTexture texture;
  texture.mapping = mapping(arguments);
  texture.factor = arguments.number("scale").value_or(1);
  texture.is_inverted = arguments.flag("invert", false);
  if (!file) {
    context_.report.error(arguments.statement().place,
                          "an imagemap without its file: expected \"string filename\"");
    return std::nullopt;
  }
  texture.image = add_image(context_, *file, encoding, wrap);
  if (!texture.image) return std::nullopt;
  const bool is_plain = texture.mapping.scale == Vec2d(1.0) &&
                        texture.mapping.offset == Vec2d(0.0) && texture.factor == 1 &&
                        !texture.is_inverted;
  if (is_plain) return ColourInput{Vec3d(1.0), texture.image, {}};
  return add(texture, name, arguments.statement().place);
}

// pbrt-v3 names the two factors tex1 and tex2, and so does candela where the second is a colour.
Textures::Value Textures::product(Kind kind, Arguments& arguments, const std::string& name) {
  const bool is_v3 = arguments.has("tex1");
  if (is_v3) arguments.accept({"tex", "scale"});
  description::ProductTexture texture;
  texture.first = input(kind, arguments, is_v3 ? "tex1" : "tex", Vec3d(1.0));
  texture.second = is_v3 ? input(kind, arguments, "tex2", Vec3d(1.0))
                         : input(Kind::Float, arguments, "scale", Vec3d(1.0));
  if (is_constant(texture.first) && is_constant(texture.second))
    return ColourInput{texture.first.factor * texture.second.factor, {}, {}};
  return add(texture, name, arguments.statement().place);
}

Textures::Value Textures::mix(Kind kind, Arguments& arguments, const std::string& name) {
  description::MixTexture texture;
  texture.first = input(kind, arguments, "tex1", Vec3d(0.0));
  texture.second = input(kind, arguments, "tex2", Vec3d(1.0));
  if (arguments.statement().type == "directionmix") {
    arguments.accept({"dir"});
    context_.warn_once("directionmix", arguments.statement().place,
                       "textures that depend on the normal are not supported: their two halves "
                       "are mixed evenly");
  } else {
    texture.amount = input(Kind::Float, arguments, "amount", Vec3d(0.5));
  }
  return add(texture, name, arguments.statement().place);
}

Textures::Value Textures::checkerboard(Kind kind, Arguments& arguments, const std::string& name) {
  description::CheckerboardTexture texture;
  texture.mapping = mapping(arguments);
  texture.even = input(kind, arguments, "tex1", Vec3d(1.0));
  texture.odd = input(kind, arguments, "tex2", Vec3d(0.0));
  arguments.accept({"aamode"});  // pbrt-v3
  if (arguments.integer("dimension").value_or(2) != 2)
    context_.warn_once("checkerboard", arguments.statement().place,
                       "checkerboards of three dimensions are not supported: two are used");
  return add(texture, name, arguments.statement().place);
}

Textures::Value Textures::dots(Kind kind, Arguments& arguments, const std::string& name) {
  description::DotsTexture texture;
  texture.mapping = mapping(arguments);
  texture.inside = input(kind, arguments, "inside", Vec3d(1.0));
  texture.outside = input(kind, arguments, "outside", Vec3d(0.0));
  return add(texture, name, arguments.statement().place);
}

Vec3d Textures::corner(Kind kind, Arguments& arguments, std::string_view name, double otherwise) {
  const ColourInput value = input(kind, arguments, name, Vec3d(otherwise));
  if (!is_constant(value))
    arguments.warning(*arguments.find(name), "is no constant: white is used");
  return value.factor;
}

Textures::Value Textures::bilerp(Kind kind, Arguments& arguments, const std::string& name) {
  description::BilinearTexture texture;
  texture.mapping = mapping(arguments);
  texture.v00 = corner(kind, arguments, "v00", 0);
  texture.v01 = corner(kind, arguments, "v01", 1);
  texture.v10 = corner(kind, arguments, "v10", 0);
  texture.v11 = corner(kind, arguments, "v11", 1);
  return add(texture, name, arguments.statement().place);
}

}  // namespace candela::pbrt
