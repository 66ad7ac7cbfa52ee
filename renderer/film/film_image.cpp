// A film's means and layers as an image.
#include <array>

#include "renderer/film/film.h"
#include "renderer/film/heavy_tails.h"
#include "renderer/film/pixel_interval.h"
#include "renderer/film/variance.h"

namespace candela {
namespace {

struct Layer {
  Aov aov;
  std::array<const char*, 3> channels;  // null: fewer than three
};

constexpr std::array<Layer, 9> layers{{
    {Aov::Albedo, {"albedo.R", "albedo.G", "albedo.B"}},
    {Aov::Normal, {"normal.X", "normal.Y", "normal.Z"}},
    {Aov::Depth, {"depth.Z", nullptr, nullptr}},
    {Aov::Position, {"position.X", "position.Y", "position.Z"}},
    {Aov::MaterialId, {"material_id.V", nullptr, nullptr}},
    {Aov::Samples, {"samples.V", nullptr, nullptr}},
    {Aov::Variance, {"variance.R", "variance.G", "variance.B"}},
    {Aov::Interval, {"interval.R", "interval.G", "interval.B"}},
    {Aov::HeavyTail, {"heavy_tail.V", nullptr, nullptr}},
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

}  // namespace

Image Film::to_image(bool with_alpha) const {
  Image image(crop_.width(), crop_.height(), channel_names(aovs_, with_alpha));
  const auto has = [&](Aov aov) { return (aovs_ & aov_bit(aov)) != 0; };
  const auto intervals = has(Aov::Interval) ? pixel_intervals(*this) : std::vector<Vec3d>();
  const auto heavy_tails = has(Aov::HeavyTail) ? heavy_tail_mask(*this) : std::vector<bool>();
  float* out = image.values.data();
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const Pixel& pixel = pixels_[i];
    const double per_sample = pixel.samples > 0 ? 1.0 / pixel.samples : 0.0;
    out = put(out, mean(i));
    if (with_alpha) *out++ = static_cast<float>(pixel.alpha * per_sample);
    const AovPixel none;
    const AovPixel& aov = aov_pixels_.empty() ? none : aov_pixels_[i];
    const double per_hit = aov.hits > 0 ? 1.0 / aov.hits : 0.0;
    for (const Layer& layer : layers) {
      if (!has(layer.aov)) continue;
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
        case Aov::Variance:
          out = put(out, variance_of_mean(*this, i));
          break;
        case Aov::Interval:
          out = put(out, intervals[i]);
          break;
        case Aov::HeavyTail:
          *out++ = heavy_tails[i] ? 1.0f : 0.0f;
          break;
      }
    }
  }
  return image;
}

}  // namespace candela
