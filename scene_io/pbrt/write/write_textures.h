// Texture directives and the image files behind them, each made when something first asks for it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>

#include "scene_io/pbrt/write/directive.h"
#include "scene_io/pbrt/write/write_context.h"

namespace candela::pbrt {

class TextureWriter {
 public:
  explicit TextureWriter(WriteContext& context) : context_(context) {}

  // `"rgb NAME" [ .. ]`, or `"texture NAME"` of a spectrum texture.
  [[nodiscard]] WrittenParameter colour(std::string_view name,
                                        const description::ColourInput& input);
  // The same times `scale`; a constant at most `limit`.
  [[nodiscard]] WrittenParameter scaled_colour(std::string_view name,
                                               const description::ColourInput& input, double scale,
                                               double limit);
  // `"float NAME" x`, or `"texture NAME"` of a float texture.
  [[nodiscard]] WrittenParameter scalar(std::string_view name,
                                        const description::ScalarInput& input);
  // Grey heights by an image or a texture, times `scale`.
  [[nodiscard]] WrittenParameter heights(std::string_view name,
                                         const description::Material& material, double scale);
  // The alpha of a material's diffuse map where it has one, as lab3 takes it.
  [[nodiscard]] std::optional<WrittenParameter> map_alpha(std::string_view name,
                                                          description::ImageHandle map);

  // The file of an image as it stands, relative to the scene; "" where it cannot be read.
  [[nodiscard]] std::string file_of(description::ImageHandle image);
  [[nodiscard]] std::optional<ImageFacts> facts_of(description::ImageHandle image);

  // All directives so far.
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  enum class Kind : std::uint8_t { Float, Spectrum };
  using FileKey = std::tuple<std::string, int>;                   // path, channel
  using ImageKey = std::tuple<Kind, std::uint32_t, int, double>;  // image, channel, scale

  struct Channel {
    int index = WrittenImage::all_channels;
    bool is_alpha = false;  // never decoded
  };

  WrittenParameter input(Kind kind, std::string_view name, const description::ColourInput& input);
  WrittenParameter image(Kind kind, std::string_view name, description::ImageHandle image,
                         Channel channel, double scale);
  WrittenParameter scaled(Kind kind, std::string_view name, const WrittenParameter& plain,
                          double scale);
  WrittenParameter texture(Kind kind, std::string_view name, description::TextureHandle texture);
  Channel channel_of(description::ImageHandle image, int channel);
  std::string file(description::ImageHandle image, int channel);
  Directive image_directive(const std::string& name, Kind kind, description::ImageHandle image,
                            Channel channel);

  [[nodiscard]] bool is_image(const description::ColourInput& input) const;
  std::string make(Kind kind, const description::Texture& texture);
  Directive directive(const std::string& name, Kind kind, std::string_view type) const;

  WriteContext& context_;
  std::string text_;
  std::map<FileKey, std::string> files_;
  std::map<ImageKey, std::string> images_;
  std::map<std::tuple<Kind, std::uint32_t>, std::string> textures_;
  std::map<std::string, std::optional<ImageFacts>> facts_;  // by path

  friend struct TextureDirectives;
};

}  // namespace candela::pbrt
