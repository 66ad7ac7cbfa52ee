// Textures, and parameters that may be one.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include "scene_io/pbrt/context.h"

namespace candela::pbrt {

class Textures {
 public:
  explicit Textures(Context& context) : context_(context) {}

  // A colour: rgb, spectrum or the name of a spectrum texture. Nothing where it is absent or, after
  // an error, none.
  std::optional<description::ColourInput> colour(Arguments& arguments, std::string_view name);
  // A number or the name of a float texture.
  std::optional<description::ScalarInput> scalar(Arguments& arguments, std::string_view name);
  // The float texture of a parameter of that type.
  std::optional<description::ScalarInput> scalar_texture(const Parameter& parameter);
  // 1 minus a number.
  description::ScalarInput complement(const description::ScalarInput& input, const Place& place);
  description::ScalarInput square_root(const description::ScalarInput& input, const Place& place);
  description::ColourInput product(const description::ColourInput& a,
                                   const description::ColourInput& b, const Place& place);
  description::ScalarInput scaled(const description::ScalarInput& input, double factor,
                                  const Place& place);
  // Heights, pbrt's in the world's unit.
  void set_heights(Arguments& arguments, description::Material& material);
  // A file of normals.
  description::ImageHandle normal_map(Arguments& arguments);
  // Of those that were not asked for; nothing of them comes to the scene.
  void check_unused() const;

 private:
  enum class Kind : std::uint8_t { Float, Spectrum };

  // Absent: in error.
  using Value = std::optional<description::ColourInput>;
  void set_height_texture(const Parameter& parameter, description::Material& material);
  bool set_own_heights(Arguments& arguments, description::Material& material);
  [[nodiscard]] std::map<std::string, TextureStatement>& statements(Kind kind) const;
  Value named(Kind kind, const Parameter& parameter);
  void report_unknown(Kind kind, const Place& place, const std::string& name) const;
  Value make(Kind kind, TextureStatement& texture, const std::string& name);
  void note_filter(Arguments& arguments);
  description::ColourInput grey(const description::ColourInput& input, const Place& place);
  Value image(Kind kind, const TextureStatement& statement, Arguments& arguments,
              const std::string& name);
  Value scale(Kind kind, Arguments& arguments, const std::string& name);
  Value scaled_image(const description::ColourInput& input, const description::ColourInput& scale,
                     const std::string& name, const Place& place);
  Value mix(Kind kind, Arguments& arguments, const std::string& name);
  Value direction_mix(Kind kind, const TextureStatement& statement, Arguments& arguments,
                      const std::string& name);
  Value checkerboard(Kind kind, const TextureStatement& statement, Arguments& arguments,
                     const std::string& name);
  Value dots(Kind kind, const TextureStatement& statement, Arguments& arguments,
             const std::string& name);
  Value bilerp(Kind kind, const TextureStatement& statement, Arguments& arguments,
               const std::string& name);
  Value stand_in(Arguments& arguments);
  description::ColourInput input(Kind kind, Arguments& arguments, std::string_view name,
                                 const Vec3d& otherwise);
  Vec3d corner(Kind kind, Arguments& arguments, std::string_view name, double otherwise);
  description::UvMapping mapping(const TextureStatement& texture, Arguments& arguments);
  Transform place_from_world(const TextureStatement& texture);
  template <class Texture>
  description::ColourInput add(Texture kind, const std::string& name, const Place& place);

  Context& context_;
  std::array<std::map<std::string, Value>, 2> made_;  // by kind
  int depth_ = 0;
};

template <class Texture>
description::ColourInput Textures::add(Texture kind, const std::string& name, const Place& place) {
  auto& textures = context_.scene.textures;
  textures.push_back({name, place.span(), std::move(kind)});
  description::ColourInput input;
  input.texture = description::TextureHandle(textures.size() - 1);
  return input;
}

// "sRGB", "linear" and "gamma 2.2", as pbrt-v4 calls encodings of PNG files; and candela's own
// "lab3".
[[nodiscard]] std::string_view name_of(description::Encoding encoding);
[[nodiscard]] std::optional<description::Encoding> encoding_named(std::string_view name);

// What "wrap" says; mirror is candela's own.
[[nodiscard]] std::string_view name_of(description::Wrap wrap);
[[nodiscard]] description::Wrap wrap_of(Arguments& arguments, description::Wrap otherwise);

// Adds an image of the scene, or finds the equal one that is there. Invalid after an error.
[[nodiscard]] description::ImageHandle add_image(Context& context, const Parameter& file,
                                                 description::Encoding encoding,
                                                 description::Wrap wrap);
// The same of what shines: a file that is not there is an error, where textures are magenta.
[[nodiscard]] description::ImageHandle add_light_image(
    Context& context, const Parameter& file, description::Encoding encoding,
    description::Wrap wrap = description::Wrap::Clamp);

}  // namespace candela::pbrt
