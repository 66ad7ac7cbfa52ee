// Image files as pbrt names them: textures, heights, normals.
#include <filesystem>

#include <fmt/format.h>

#include "renderer/base/letter_case.h"
#include "scene_io/image_encoding.h"
#include "scene_io/pbrt/source_files.h"
#include "scene_io/pbrt/textures.h"

namespace candela::pbrt {
namespace {

using description::ColourInput;
using description::Encoding;
using description::ImageHandle;
using description::MappingKind;
using description::Wrap;

// Only PNG files are as "encoding" says; all are as candela's own "decode" does. pbrt-v3 decodes
// sRGB unless "gamma" is false.
Encoding encoding_of(Arguments& arguments, std::string_view file_name) {
  const std::string decode = arguments.string("decode").value_or("");
  if (const auto own = encoding_named(decode)) {
    arguments.accept({"encoding"});
    return *own;
  }
  if (const Parameter* gamma = arguments.find("gamma")) {
    if (gamma->type != ParameterType::Bool)
      arguments.warning(*gamma, "is no bool and is ignored");  // pbrt-v2's exponent
    else if (!arguments.flag("gamma", true))
      return Encoding::Linear;
  }
  const Parameter* parameter = arguments.find("encoding", {ParameterType::String});
  if (!parameter || parameter->strings.size() != 1 || !ends_ignoring_case(file_name, ".png"))
    return encoding_of_colours(file_name);
  const auto encoding = encoding_named(parameter->strings[0]);
  if (!encoding)
    arguments.warning(*parameter, fmt::format("{} is not supported: it counts as sRGB",
                                              text::quoted(parameter->strings[0])));
  return encoding.value_or(Encoding::Srgb);
}

}  // namespace

std::string_view name_of(Encoding encoding) {
  switch (encoding) {
    case Encoding::Linear:
      return "linear";
    case Encoding::Srgb:
      return "sRGB";
    case Encoding::Gamma22:
      return "gamma 2.2";
    case Encoding::LabGamma:
      return "lab3";
  }
  return "linear";
}

std::optional<Encoding> encoding_named(std::string_view name) {
  for (const Encoding encoding :
       {Encoding::Linear, Encoding::Srgb, Encoding::Gamma22, Encoding::LabGamma})
    if (name_of(encoding) == name) return encoding;
  return std::nullopt;
}

namespace {

enum class Need : std::uint8_t { MayBeMissing, MustExist };

ImageHandle add_image(Context& context, const Parameter& file, Encoding encoding, Wrap wrap,
                      Need need) {
  if (file.strings.size() != 1) {
    context.report.error(file.place, fmt::format("{} has {}, expected the name of one image file",
                                                 text::quoted(file.name), describe_count(file)));
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
  if (need == Need::MustExist && !std::filesystem::exists(status)) {
    context.report.error(file.place,
                         fmt::format("{}: no such file for an image", text::quoted_path(path)));
    return {};
  }
  return context.images.add({path, encoding, wrap, file.place.span()}, context.scene);
}

}  // namespace

Wrap wrap_of(Arguments& arguments, Wrap otherwise) {
  const Parameter* parameter = arguments.find("wrap", {ParameterType::String});
  if (!parameter || parameter->strings.size() != 1) return otherwise;
  for (const Wrap wrap : {Wrap::Repeat, Wrap::Black, Wrap::Clamp, Wrap::Mirror})
    if (parameter->strings[0] == name_of(wrap)) return wrap;
  arguments.warning(*parameter, fmt::format("{} is none of repeat, black and clamp: it is {}",
                                            text::quoted(parameter->strings[0]),
                                            otherwise == Wrap::Repeat ? "repeated" : "clamped"));
  return otherwise;
}

std::string_view name_of(Wrap wrap) {
  switch (wrap) {
    case Wrap::Repeat:
      return "repeat";
    case Wrap::Clamp:
      return "clamp";
    case Wrap::Black:
      return "black";
    case Wrap::Mirror:
      return "mirror";
  }
  return "";
}

ImageHandle add_image(Context& context, const Parameter& file, Encoding encoding, Wrap wrap) {
  return add_image(context, file, encoding, wrap, Need::MayBeMissing);
}

ImageHandle add_light_image(Context& context, const Parameter& file, Encoding encoding, Wrap wrap) {
  return add_image(context, file, encoding, wrap, Need::MustExist);
}

void Textures::set_heights(Arguments& arguments, description::Material& material) {
  if (set_own_heights(arguments, material)) return;
  const Parameter* parameter =
      arguments.find("displacement", {ParameterType::Texture, ParameterType::Float});
  if (!parameter) parameter = arguments.find("bumpmap", {ParameterType::Texture});  // pbrt-v3
  if (!parameter || parameter->type != ParameterType::Texture) return;
  set_height_texture(*parameter, material);
  material.heights_are_lengths = true;
}

// candela's own: heights in the unit that it has.
bool Textures::set_own_heights(Arguments& arguments, description::Material& material) {
  const Parameter* parameter = arguments.find("heights", {ParameterType::Texture});
  if (!parameter) return false;
  arguments.accept({"displacement"});
  material.height_scale = arguments.number("heightscale").value_or(1);
  set_height_texture(*parameter, material);
  return true;
}

void Textures::set_height_texture(const Parameter& parameter, description::Material& material) {
  if (const auto heights = scalar_texture(parameter))
    material.height_texture =
        grey({Vec3d(1.0), heights->map, heights->texture}, parameter.place).texture;
}

ImageHandle Textures::normal_map(Arguments& arguments) {
  const Parameter* file = arguments.find("normalmap", {ParameterType::String});
  return file ? add_image(context_, *file, Encoding::Linear, Wrap::Repeat) : ImageHandle();
}

// Lookups are bilinear, pbrt's default; the samples of a pixel average what its footprint covers.
// pbrt-v3 has the flag "trilinear" and otherwise filters by EWA, of which nothing is said.
void Textures::note_filter(Arguments& arguments) {
  const Parameter* filter = arguments.find("filter", {ParameterType::String});
  const bool is_trilinear = arguments.flag("trilinear", false);
  if (filter && filter->strings.size() == 1) {
    const std::string& name = filter->strings[0];
    if (name == "bilinear") return;
    if (name != "point" && name != "trilinear" && name != "ewa" && name != "EWA")
      return arguments.warning(*filter,
                               fmt::format("{} is none of bilinear, point, trilinear and ewa: "
                                           "images are looked up bilinearly",
                                           text::quoted(name)));
  } else if (!is_trilinear) {
    return;
  }
  const Place& place = filter ? filter->place : arguments.find("trilinear")->place;
  context_.note_once("texture filter", place,
                     "images are looked up bilinearly, whatever \"filter\" they name: a pixel's "
                     "samples average them over its footprint");
}

Textures::Value Textures::image(Kind kind, const TextureStatement& statement, Arguments& arguments,
                                const std::string& name) {
  const Parameter* file = arguments.file("filename", "an imagemap");
  note_filter(arguments);
  arguments.accept({"maxanisotropy"});
  const Wrap wrap = wrap_of(arguments, Wrap::Repeat);
  const Encoding encoding = encoding_of(arguments, file ? file->strings[0] : "");
  description::ImageTexture texture;
  texture.mapping = mapping(statement, arguments);
  texture.factor = arguments.number("scale").value_or(1);
  texture.is_inverted = arguments.flag("invert", false);
  if (!file) return std::nullopt;
  texture.image = add_image(context_, *file, encoding, wrap);
  if (!texture.image) return std::nullopt;
  const bool is_grey = arguments.flag("scalar", false);  // candela's own
  texture.is_scalar = kind == Kind::Float || is_grey;
  const bool is_plain =
      !is_grey && texture.mapping.scale == Vec2d(1.0) && texture.mapping.offset == Vec2d(0.0) &&
      texture.mapping.kind == MappingKind::Surface && texture.factor == 1 && !texture.is_inverted;
  if (is_plain) return ColourInput{Vec3d(1.0), texture.image, {}};
  return add(texture, name, arguments.statement().place);
}

}  // namespace candela::pbrt
