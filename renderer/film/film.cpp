#include "renderer/film/film.h"

#include <algorithm>
#include <array>

namespace candela {
namespace {

struct Layer {
  Aov aov;
  std::array<const char*, 3> channels;  // null: fewer than three
};

constexpr std::array<Layer, 6> layers{{
    {Aov::Albedo, {"albedo.R", "albedo.G", "albedo.B"}},
    {Aov::Normal, {"normal.X", "normal.Y", "normal.Z"}},
    {Aov::Depth, {"depth.Z", nullptr, nullptr}},
    {Aov::Position, {"position.X", "position.Y", "position.Z"}},
    {Aov::MaterialId, {"material_id.V", nullptr, nullptr}},
    {Aov::Samples, {"samples.V", nullptr, nullptr}},
}};

std::vector<std::string> channel_names(AovSet aovs, bool with_alpha) {
  std::vector<std::string> names{"R", "G", "B"};
  if (with_alpha) names.emplace_back("A");
  for (const Layer& layer : layers) {
    if ((aovs & aov_bit(layer.aov)) == 0) continue;
    for (const char* name : layer.channels)
      if (name != nullptr) names.emplace_back(name);
  }
  return names;
}

float* put(float* out, const Vec3d& v) {
  for (int c = 0; c < 3; ++c) *out++ = static_cast<float>(v[c]);
  return out;
}

constexpr AovSet first_hit_aovs = aov_bit(Aov::Albedo) | aov_bit(Aov::Normal) |
                                  aov_bit(Aov::Depth) | aov_bit(Aov::Position) |
                                  aov_bit(Aov::MaterialId);

}  // namespace

Film::Film(int full_width, int full_height, PixelRect crop, AovSet aovs)
    : full_width_(full_width), full_height_(full_height), crop_(crop), aovs_(aovs) {
  const auto count =
      static_cast<std::size_t>(crop.width()) * static_cast<std::size_t>(crop.height());
  pixels_.resize(count);
  if ((aovs & first_hit_aovs) != 0) aov_pixels_.resize(count);
}

std::size_t Film::index(int x, int y) const {
  return static_cast<std::size_t>(y - crop_.y0) * static_cast<std::size_t>(crop_.width()) +
         static_cast<std::size_t>(x - crop_.x0);
}

void Film::add(int x, int y, const FilmSample& sample) {
  const std::size_t i = index(x, y);
  Pixel& pixel = pixels_[i];
  pixel.radiance += Vec3d(sample.radiance);
  pixel.alpha += static_cast<double>(sample.alpha);
  ++pixel.samples;
  if (aov_pixels_.empty() || !sample.has_hit) return;
  AovPixel& aov = aov_pixels_[i];
  aov.albedo += Vec3d(sample.albedo);
  aov.normal += Vec3d(sample.normal);
  aov.position += sample.position;
  aov.depth += sample.depth;
  ++aov.hits;
  if (pixel.samples == 1) aov.material = sample.material + 1;
}

void Film::add_invalid(int x, int y) {
  ++pixels_[index(x, y)].samples;
}

std::uint32_t Film::min_samples() const {
  std::uint32_t fewest = pixels_.empty() ? 0 : pixels_.front().samples;
  for (const Pixel& pixel : pixels_) fewest = std::min(fewest, pixel.samples);
  return fewest;
}

std::uint32_t Film::max_samples() const {
  std::uint32_t most = 0;
  for (const Pixel& pixel : pixels_) most = std::max(most, pixel.samples);
  return most;
}

Image Film::to_image(bool with_alpha) const {
  Image image(crop_.width(), crop_.height(), channel_names(aovs_, with_alpha));
  float* out = image.values.data();
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const Pixel& pixel = pixels_[i];
    const double per_sample = pixel.samples > 0 ? 1.0 / pixel.samples : 0.0;
    out = put(out, pixel.radiance * per_sample);
    if (with_alpha) *out++ = static_cast<float>(pixel.alpha * per_sample);
    const AovPixel none;
    const AovPixel& aov = aov_pixels_.empty() ? none : aov_pixels_[i];
    const double per_hit = aov.hits > 0 ? 1.0 / aov.hits : 0.0;
    for (const Layer& layer : layers) {
      if ((aovs_ & aov_bit(layer.aov)) == 0) continue;
      switch (layer.aov) {
        case Aov::Albedo:
          out = put(out, aov.albedo * per_hit);
          break;
        case Aov::Normal:
          out = put(out, aov.normal * per_hit);
          break;
        case Aov::Depth:
          *out++ = static_cast<float>(aov.depth * per_hit);
          break;
        case Aov::Position:
          out = put(out, aov.position * per_hit);
          break;
        case Aov::MaterialId:
          *out++ = static_cast<float>(aov.material);
          break;
        case Aov::Samples:
          *out++ = static_cast<float>(pixel.samples);
          break;
      }
    }
  }
  return image;
}

}  // namespace candela
