#include "scene_io/pbrt/write/write_textures.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene_io/pbrt/textures.h"

namespace candela::pbrt {
namespace {

using description::ColourInput;
using description::Encoding;
using description::ImageHandle;
using description::MappingKind;
using description::ScalarInput;
using description::TextureHandle;
using description::UvMapping;
using description::Wrap;

// What candela shows where an image is missing (renderer/texture/texture.h).
const Vec3d magenta(1, 0, 1);

WrittenParameter named(std::string_view name, const std::string& texture) {
  return {fmt::format("texture {}", name), in_quotes(texture)};
}

void add_wrap(Wrap wrap, Directive& directive) {
  if (wrap == Wrap::Mirror)
    directive.add_own("string wrap", std::string(name_of(wrap)));
  else if (wrap != Wrap::Repeat)
    directive.add("string wrap", std::string(name_of(wrap)));
}

// Planes are written by their axes in the world; other mappings by place go by SpaceOf.
void add_place_mapping(const UvMapping& mapping, Directive& directive) {
  const Transform& place = mapping.place_from_world;
  const Mat3d rows = glm::transpose(place.linear);
  switch (mapping.kind) {
    case MappingKind::Surface:
      return;
    case MappingKind::Planar:
      directive.add("string mapping", "planar");
      directive.add("vector3 v1", rows[0] * mapping.scale.x);
      directive.add("vector3 v2", rows[1] * mapping.scale.y);
      directive.add("float udelta", place.translation.x * mapping.scale.x + mapping.offset.x);
      directive.add("float vdelta", place.translation.y * mapping.scale.y + mapping.offset.y);
      return;
    case MappingKind::Spherical:
      directive.add("string mapping", "spherical");
      return;
    case MappingKind::Cylindrical:
      directive.add("string mapping", "cylindrical");
      return;
  }
}

void add_mapping(const UvMapping& mapping, Directive& directive) {
  if (mapping.kind != MappingKind::Surface) return add_place_mapping(mapping, directive);
  if (mapping.scale != Vec2d(1.0))
    directive.add("float uscale", mapping.scale.x).add("float vscale", mapping.scale.y);
  if (mapping.offset != Vec2d(0.0))
    directive.add("float udelta", mapping.offset.x).add("float vdelta", mapping.offset.y);
}

// The space that must hold where a texture's directive stands.
struct SpaceOf {
  using Space = std::optional<Transform>;  // world <- texture

  Space operator()(const description::ImageTexture& t) const { return of(t.mapping); }
  Space operator()(const description::CheckerboardTexture& t) const { return of(t.mapping); }
  Space operator()(const description::DotsTexture& t) const { return of(t.mapping); }
  Space operator()(const description::BilinearTexture& t) const { return of(t.mapping); }
  Space operator()(const description::SolidCheckerboardTexture& t) const {
    return inverse(t.place_from_world);
  }
  template <class Other>
  Space operator()(const Other&) const {
    return std::nullopt;
  }

 private:
  static Space of(const UvMapping& mapping) {
    const bool is_by_angle =
        mapping.kind == MappingKind::Spherical || mapping.kind == MappingKind::Cylindrical;
    return is_by_angle ? Space(inverse(mapping.place_from_world)) : std::nullopt;
  }
};

// What a missing image shows.
Vec3d magenta_of(const description::ImageTexture& image) {
  const Vec3d scaled = magenta * image.factor;
  const Vec3d shown = image.is_inverted ? glm::max(1.0 - scaled, 0.0) : scaled;
  return image.is_scalar ? shown : glm::clamp(shown, 0.0, 1.0);
}

bool is_grey(const Vec3d& colour) {
  return colour.x == colour.y && colour.y == colour.z;
}

}  // namespace

// One texture of the description -> its directive.
struct TextureDirectives {
  TextureWriter& writer;
  std::string name;
  TextureWriter::Kind kind;

  Directive operator()(const description::ImageTexture& t) const {
    Directive out = writer.image_directive(name, kind, t.image, {});
    add_mapping(t.mapping, out);
    if (t.factor != 1) out.add("float scale", t.factor);
    if (t.is_inverted) out.add("bool invert", true);
    if (t.is_scalar && kind == TextureWriter::Kind::Spectrum) out.add_own("bool scalar", true);
    return out;
  }
  // pbrt scales by numbers only, and what an image holds instead of what comes of it.
  Directive operator()(const description::ProductTexture& t) const {
    Directive out = directive("scale");
    out.add(input("tex", t.first)).add(writer.input(TextureWriter::Kind::Float, "scale", t.second));
    const bool is_by_number = t.second.is_constant() && is_grey(t.second.factor);
    if (!is_by_number || writer.is_image(t.first) || writer.is_image(t.second))
      out.add_own(input("tex1", t.first)).add_own(input("tex2", t.second));
    return out;
  }
  Directive operator()(const description::MixTexture& t) const {
    Directive out = directive("mix");
    out.add(input("tex1", t.first)).add(input("tex2", t.second));
    out.add(writer.input(TextureWriter::Kind::Float, "amount", t.amount));
    return out;
  }
  // pbrt has no roots; candela's own "scale" has.
  Directive operator()(const description::SquareRootTexture& t) const {
    Directive out = directive("scale");
    out.add(input("tex", t.input)).add_own("bool root", true);
    return out;
  }
  Directive operator()(const description::DirectionMixTexture& t) const {
    Directive out = directive("directionmix");
    out.add(input("tex1", t.first)).add(input("tex2", t.second));
    out.add("vector3 dir", t.direction);
    return out;
  }
  Directive operator()(const description::SolidCheckerboardTexture& t) const {
    Directive out = directive("checkerboard");
    out.add("integer dimension", 3).add(input("tex1", t.even)).add(input("tex2", t.odd));
    return out;
  }
  Directive operator()(const description::CheckerboardTexture& t) const {
    Directive out = directive("checkerboard");
    add_mapping(t.mapping, out);
    out.add(input("tex1", t.even)).add(input("tex2", t.odd));
    return out;
  }
  Directive operator()(const description::DotsTexture& t) const {
    Directive out = directive("dots");
    add_mapping(t.mapping, out);
    out.add(input("inside", t.inside)).add(input("outside", t.outside));
    return out;
  }
  Directive operator()(const description::BilinearTexture& t) const {
    Directive out = directive("bilerp");
    add_mapping(t.mapping, out);
    out.add(corner("v00", t.v00)).add(corner("v01", t.v01));
    out.add(corner("v10", t.v10)).add(corner("v11", t.v11));
    return out;
  }

 private:
  [[nodiscard]] Directive directive(std::string_view type) const {
    return writer.directive(name, kind, type);
  }
  [[nodiscard]] WrittenParameter input(std::string_view parameter, const ColourInput& value) const {
    return writer.input(kind, parameter, value);
  }
  [[nodiscard]] WrittenParameter corner(std::string_view parameter, const Vec3d& value) const {
    return input(parameter, {value, {}, {}});
  }
};

WrittenParameter TextureWriter::colour(std::string_view name, const ColourInput& value) {
  return input(Kind::Spectrum, name, value);
}

WrittenParameter TextureWriter::scaled_colour(std::string_view name, const ColourInput& value,
                                              double scale, double limit) {
  if (value.texture)
    return scaled(Kind::Spectrum, name, texture(Kind::Spectrum, "tex", value.texture), scale);
  if (value.map) return image(Kind::Spectrum, name, value.map, {}, scale);
  return colour(name, {glm::min(value.factor * scale, Vec3d(limit)), {}, {}});
}

WrittenParameter TextureWriter::scaled(Kind kind, std::string_view name,
                                       const WrittenParameter& plain, double scale) {
  if (scale == 1) return {fmt::format("texture {}", name), plain.value};
  const std::string made = context_.unique_name("texture", "scaled");
  text_ += directive(made, kind, "scale").add(plain).add("float scale", scale).text();
  return named(name, made);
}

WrittenParameter TextureWriter::scalar(std::string_view name, const ScalarInput& value) {
  if (value.texture) return texture(Kind::Float, name, value.texture);
  if (value.map)
    return image(Kind::Float, name, value.map, channel_of(value.map, value.channel), 1);
  return {fmt::format("float {}", name), value_text(value.factor)};
}

WrittenParameter TextureWriter::heights(std::string_view name,
                                        const description::Material& material, double scale) {
  if (!material.height_texture)
    return image(Kind::Float, name, material.height, channel_of(material.height, 0), scale);
  const WrittenParameter plain = texture(Kind::Float, "tex", material.height_texture);
  return scaled(Kind::Float, name, plain, scale);
}

std::optional<WrittenParameter> TextureWriter::map_alpha(std::string_view name, ImageHandle map) {
  const auto facts = facts_of(map);
  if (!facts || facts->alpha_channel < 0) return std::nullopt;
  return image(Kind::Float, name, map, {facts->alpha_channel, true}, 1);
}

std::string TextureWriter::file_of(ImageHandle handle) {
  return facts_of(handle) ? file(handle, WrittenImage::all_channels) : "";
}

std::optional<ImageFacts> TextureWriter::facts_of(ImageHandle handle) {
  const description::Image& image = context_.scene.images[handle.index];
  const auto [at, is_new] = facts_.try_emplace(image.path);
  if (!is_new) return at->second;
  if (context_.options.image_facts) at->second = context_.options.image_facts(image.path);
  if (!at->second)
    context_.warn(image.span,
                  fmt::format("the image '{}' cannot be read: it is magenta, as candela "
                              "shows it",
                              image.path));
  return at->second;
}

WrittenParameter TextureWriter::input(Kind kind, std::string_view name, const ColourInput& value) {
  if (value.texture) return texture(kind, name, value.texture);
  if (value.map) return image(kind, name, value.map, {}, 1);
  if (kind == Kind::Spectrum) return {fmt::format("rgb {}", name), value_text(value.factor)};
  return {fmt::format("float {}", name), value_text(value.factor.x)};
}

// What candela looks up: alpha where there is one, or the asked one; grey files repeat theirs. What
// pbrt takes of an image itself is left to it.
TextureWriter::Channel TextureWriter::channel_of(ImageHandle image, int channel) {
  const auto facts = facts_of(image);
  if (!facts) return {};
  const bool asks_alpha =
      channel == 3 || (channel == description::alpha_or_first && facts->alpha_channel >= 0);
  if (asks_alpha) return {facts->alpha_channel, true};
  const int colours = facts->channels - (facts->alpha_channel >= 0 ? 1 : 0);
  if (facts->channels == 1 || channel == description::alpha_or_mean) return {};
  return {std::clamp(channel, 0, colours >= 3 ? 2 : 0), false};
}

WrittenParameter TextureWriter::image(Kind kind, std::string_view name, ImageHandle handle,
                                      Channel channel, double scale) {
  const bool is_missing = !facts_of(handle);
  if (is_missing && kind == Kind::Spectrum)
    return {fmt::format("rgb {}", name), value_text(magenta)};
  if (is_missing || (channel.is_alpha && channel.index < 0))
    return {fmt::format("float {}", name), value_text(scale)};
  const auto [at, is_new] = images_.try_emplace({kind, handle.index, channel.index, scale});
  if (is_new) {
    const std::string& path = context_.scene.images[handle.index].path;
    at->second = context_.unique_name("texture", stem_of(path));
    Directive out = image_directive(at->second, kind, handle, channel);
    if (scale != 1) out.add("float scale", scale);
    text_ += out.text();
  }
  return named(name, at->second);
}

Directive TextureWriter::image_directive(const std::string& name, Kind kind, ImageHandle handle,
                                         Channel channel) {
  const description::Image& image = context_.scene.images[handle.index];
  const std::string path = file(handle, channel.index);
  Directive out = directive(name, kind, "imagemap");
  out.add("string filename", path);
  const Encoding encoding = channel.is_alpha ? Encoding::Linear : image.encoding;
  const bool is_png = path.ends_with(".png");
  if (is_png && encoding == Encoding::LabGamma) {
    out.add("string encoding", std::string(name_of(Encoding::Gamma22)));
    out.add_own("string decode", std::string(name_of(encoding)));
  } else if (is_png) {
    out.add("string encoding", std::string(name_of(encoding)));
  } else if (encoding != Encoding::Linear) {
    out.add_own("string decode", std::string(name_of(encoding)));
    context_.warn(image.span,
                  fmt::format("for pbrt the numbers of '{}' are linear ones: it decodes "
                              "PNG files only",
                              image.path));
  }
  add_wrap(image.wrap, out);
  if (image.wrap == Wrap::Mirror)
    context_.warn(image.span, fmt::format("pbrt repeats '{}' without mirroring it", image.path));
  return out;
}

// PNG, EXR and HDR files are copied; pbrt-v4 reads others by their extension and by rules of their
// own, so they become PNG or, with floats, EXR.
std::string TextureWriter::file(ImageHandle handle, int channel) {
  const std::string& path = context_.scene.images[handle.index].path;
  const auto [at, is_new] = files_.try_emplace({path, channel});
  if (!is_new) return at->second;
  const auto facts = facts_of(handle);
  const std::string extension = lower_extension_of(path);
  const bool is_whole = channel == WrittenImage::all_channels;
  const bool is_copied =
      is_whole && (extension == ".png" || extension == ".exr" || extension == ".hdr");
  const std::string made = facts && facts->is_float ? ".exr" : ".png";
  const std::string part = is_whole ? "" : fmt::format("-channel{}", channel);
  const std::string wish = stem_of(path) + part + (is_copied ? extension : made);
  at->second = context_.options.folder + "/" + context_.unique_name("file", wish);
  context_.written.images.push_back(
      {at->second, path, channel, is_copied, context_.scene.images[handle.index].span});
  return at->second;
}

WrittenParameter TextureWriter::texture(Kind kind, std::string_view name, TextureHandle handle) {
  const auto known = textures_.find({kind, handle.index});
  if (known != textures_.end()) return named(name, known->second);
  const description::Texture& texture = context_.scene.textures[handle.index];
  const std::string made = make(kind, texture);
  textures_[{kind, handle.index}] = made;
  return named(name, made);
}

bool TextureWriter::is_image(const description::ColourInput& input) const {
  if (!input.texture) return input.map.is_valid();
  return std::holds_alternative<description::ImageTexture>(
      context_.scene.textures[input.texture.index].kind);
}

// Its inputs' directives come before its own.
std::string TextureWriter::make(Kind kind, const description::Texture& texture) {
  const std::string name = context_.unique_name("texture", stem_of(texture.name));
  const auto* image = std::get_if<description::ImageTexture>(&texture.kind);
  if (image && !facts_of(image->image)) {
    text_ += directive(name, kind, "constant")
                 .add(input(kind, "value", {magenta_of(*image), {}, {}}))
                 .text();
    return name;
  }
  const Directive out = std::visit(TextureDirectives{*this, name, kind}, texture.kind);
  if (std::holds_alternative<description::SquareRootTexture>(texture.kind))
    context_.warn(texture.span, fmt::format("texture '{}': pbrt has no square roots of textures: "
                                            "the texture itself is written",
                                            texture.name));
  if (const auto space = std::visit(SpaceOf{}, texture.kind))
    text_ += "AttributeBegin\n  Transform " + matrix_text(*space) + "\n" + out.text("  ") +
             "AttributeEnd\n";
  else
    text_ += out.text();
  return name;
}

Directive TextureWriter::directive(const std::string& name, Kind kind,
                                   std::string_view type) const {
  return {"Texture " + in_quotes(name) + (kind == Kind::Float ? " \"float\"" : " \"spectrum\""),
          type};
}

}  // namespace candela::pbrt
