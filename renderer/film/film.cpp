#include "renderer/film/film.h"

#include <algorithm>

namespace candela {
namespace {

constexpr AovSet first_hit_aovs = aov_bit(Aov::Albedo) | aov_bit(Aov::Normal) |
                                  aov_bit(Aov::Depth) | aov_bit(Aov::Position) |
                                  aov_bit(Aov::MaterialId);

}  // namespace

Film::Film(int full_width, int full_height, PixelRect crop, AovSet aovs, std::uint32_t replicates)
    : full_width_(full_width),
      full_height_(full_height),
      crop_(crop),
      aovs_(aovs),
      replicates_(replicates) {
  const auto count =
      static_cast<std::size_t>(crop.width()) * static_cast<std::size_t>(crop.height());
  pixels_.resize(count);
  sums_.resize(count * replicates);
  if ((aovs & first_hit_aovs) != 0) aov_pixels_.resize(count);
}

std::size_t Film::index(int x, int y) const {
  return static_cast<std::size_t>(y - crop_.y0) * static_cast<std::size_t>(crop_.width()) +
         static_cast<std::size_t>(x - crop_.x0);
}

void Film::add(int x, int y, const FilmSample& sample) {
  const std::size_t i = index(x, y);
  Pixel& pixel = pixels_[i];
  sums_[i * replicates_ + pixel.samples % replicates_] += Vec3d(sample.radiance);
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

Vec3d Film::mean(std::size_t i) const {
  if (pixels_[i].samples == 0) return Vec3d(0.0);
  Vec3d sum(0.0);
  for (std::uint32_t r = 0; r < replicates_; ++r) sum += replicate_sum(i, r);
  return sum / static_cast<double>(pixels_[i].samples);
}

}  // namespace candela
