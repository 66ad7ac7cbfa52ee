#include "renderer/scene/compile_textures.h"

#include <algorithm>

namespace candela {
namespace {

Vec4f constant_of(const Vec3d& value) {
  return {Vec3f(value), 1};
}

PlaceMap place_map(const Transform& place_from_world, const Transform& world_from_normalised) {
  const Transform t = place_from_world * world_from_normalised;
  return {Vec3f(t.linear[0]), Vec3f(t.linear[1]), Vec3f(t.linear[2]), Vec3f(t.translation)};
}

bool is_identity(const description::UvMapping& mapping) {
  return mapping.scale == Vec2d(1.0) && mapping.offset == Vec2d(0.0) &&
         mapping.kind == description::MappingKind::Surface;
}

bool is_pattern(const Procedural& p) {
  return p.kind == ProceduralKind::Checkerboard || p.kind == ProceduralKind::Dots ||
         p.kind == ProceduralKind::Bilinear || p.is_by_place();
}

struct Builder {
  TextureCompiler& compile;

  Procedural operator()(const description::ImageTexture& t) const {
    Procedural out{.kind = ProceduralKind::Image,
                   .factor = static_cast<float>(t.factor),
                   .is_inverted = t.is_inverted,
                   .is_reflectance = !t.is_scalar};
    set_mapping(t.mapping, out);
    out.inputs[0].texture = t.is_scalar ? grey(t.image) : compile.image(t.image);
    return out;
  }
  Procedural operator()(const description::DirectionMixTexture& t) const {
    return {.kind = ProceduralKind::DirectionMix,
            .direction = Vec3f(t.direction),
            .inputs = {compile.inner_input(t.first), compile.inner_input(t.second)}};
  }
  Procedural operator()(const description::SolidCheckerboardTexture& t) const {
    return {.kind = ProceduralKind::SolidCheckerboard,
            .place = place_map(t.place_from_world, compile.world_from_normalised()),
            .inputs = {compile.inner_input(t.even), compile.inner_input(t.odd)}};
  }
  Procedural operator()(const description::ProductTexture& t) const {
    return {.kind = ProceduralKind::Product,
            .inputs = {compile.inner_input(t.first), compile.inner_input(t.second)}};
  }
  Procedural operator()(const description::SquareRootTexture& t) const {
    return {.kind = ProceduralKind::SquareRoot, .inputs = {compile.inner_input(t.input)}};
  }
  Procedural operator()(const description::MixTexture& t) const {
    return {.kind = ProceduralKind::Mix,
            .inputs = {compile.inner_input(t.first), compile.inner_input(t.second),
                       compile.inner_input(t.amount)}};
  }
  Procedural operator()(const description::CheckerboardTexture& t) const {
    Procedural out{.kind = ProceduralKind::Checkerboard,
                   .inputs = {compile.inner_input(t.even), compile.inner_input(t.odd)}};
    set_mapping(t.mapping, out);
    return out;
  }
  Procedural operator()(const description::DotsTexture& t) const {
    Procedural out{.kind = ProceduralKind::Dots,
                   .inputs = {compile.inner_input(t.inside), compile.inner_input(t.outside)}};
    set_mapping(t.mapping, out);
    return out;
  }
  Procedural operator()(const description::BilinearTexture& t) const {
    Procedural out{.kind = ProceduralKind::Bilinear};
    set_mapping(t.mapping, out);
    const Vec3d* const corners[] = {&t.v00, &t.v01, &t.v10, &t.v11};
    for (std::size_t i = 0; i < 4; ++i) out.inputs[i].constant = constant_of(*corners[i]);
    return out;
  }

 private:
  // With the number in all channels.
  [[nodiscard]] TextureHandle grey(description::ImageHandle image) const {
    const TextureCompiler::Scalar scalar = compile.scalar(image);
    if (scalar.channel == 0) return scalar.texture;
    Procedural alpha{.kind = ProceduralKind::Alpha};
    alpha.inputs[0].texture = scalar.texture;
    return compile.store().add(alpha);
  }
  void set_mapping(const description::UvMapping& mapping, Procedural& out) const {
    out.uv_scale = Vec2f(mapping.scale);
    out.uv_offset = Vec2f(mapping.offset);
    out.mapping = mapping.kind;
    if (mapping.kind != description::MappingKind::Surface)
      out.place = place_map(mapping.place_from_world, compile.world_from_normalised());
  }
};

// An image where it is, with its own values.
const description::ImageTexture* plain_image(const description::Texture& texture) {
  const auto* image = std::get_if<description::ImageTexture>(&texture.kind);
  const bool is_plain =
      image && is_identity(image->mapping) && image->factor == 1 && !image->is_inverted;
  return is_plain ? image : nullptr;
}

}  // namespace

// Whether texture() or image() of it is the image itself, and not as one number.
bool TextureCompiler::is_colour_image(const description::ColourInput& input) const {
  if (!input.texture) return input.map.is_valid();
  const auto* const plain = plain_image(scene_.textures[input.texture.index]);
  return plain && !plain->is_scalar;
}

TextureHandle TextureCompiler::image(description::ImageHandle image) {
  return image ? store_.add(scene_.images[image.index], diagnostics_) : TextureHandle{};
}

TextureHandle TextureCompiler::light_image(description::ImageHandle image) {
  return image ? store_.add_light(scene_.images[image.index], diagnostics_) : TextureHandle{};
}

TextureCompiler::Scalar TextureCompiler::scalar(description::ImageHandle handle) {
  const TextureHandle texture = image(handle);
  switch (store_.scalar_kind(texture)) {
    case TextureStore::ScalarKind::First:
      return {texture, 0};
    case TextureStore::ScalarKind::Alpha:
      return {texture, 3};
    case TextureStore::ScalarKind::Mean:
      break;
  }
  const auto [at, is_new] = means_.try_emplace(texture.index);
  if (is_new) {
    Procedural mean{.kind = ProceduralKind::Mean};
    mean.inputs[0].texture = texture;
    at->second = store_.add(mean);
  }
  return {at->second, 0};
}

TextureValue TextureCompiler::input(const description::ColourInput& input) {
  if (input.texture) return texture(input.texture);
  return {constant_of(input.factor), image(input.map)};
}

TextureValue TextureCompiler::inner_input(const description::ColourInput& from) {
  const TextureValue value = input(from);
  if (!is_colour_image(from) || !store_.may_exceed_one(value.texture)) return value;
  const auto [at, is_new] = clamped_.try_emplace(value.texture.index);
  if (is_new) {
    Procedural clamped{.kind = ProceduralKind::Image, .is_reflectance = true};
    clamped.inputs[0] = value;
    at->second = store_.add(clamped);
  }
  return {Vec4f(1), at->second};
}

// Where nothing varies the value is that of any place.
TextureValue TextureCompiler::added(const Procedural& procedural) {
  const bool varies =
      is_pattern(procedural) ||
      std::any_of(procedural.inputs.begin(), procedural.inputs.end(),
                  [](const TextureValue& input) { return input.texture.is_valid(); });
  if (!varies) return {evaluate_procedural(procedural, store_, {}), {}};
  return {Vec4f(1), store_.add(procedural)};
}

TextureValue TextureCompiler::texture(description::TextureHandle handle) {
  std::optional<TextureValue>& known = compiled_[handle.index];
  if (!known) {
    const description::Texture& texture = scene_.textures[handle.index];
    const auto* const plain = plain_image(texture);
    const auto of_image = plain && plain->is_scalar ? scalar(plain->image) : Scalar{};
    if (plain && of_image.channel == 0)
      known = TextureValue{Vec4f(1), plain->is_scalar ? of_image.texture : image(plain->image)};
    else
      known = added(std::visit(Builder{*this}, texture.kind));
  }
  return *known;
}

}  // namespace candela
