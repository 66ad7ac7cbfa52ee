#include "renderer/film/film.h"

#include <algorithm>

namespace candela {
namespace {

constexpr AovSet first_hit_aovs = aov_bit(Aov::Albedo) | aov_bit(Aov::Normal) |
                                  aov_bit(Aov::Depth) | aov_bit(Aov::Position) |
                                  aov_bit(Aov::MaterialId);

}  // namespace

Film::Film(int full_width, int full_height, PixelRect crop, AovSet aovs, std::uint32_t replicates,
           const std::optional<Mat3d>& balance)
    : full_width_(full_width),
      full_height_(full_height),
      crop_(crop),
      aovs_(aovs),
      replicates_(replicates),
      balance_(balance) {
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
  const Vec3d radiance(sample.radiance);
  sums_[i * replicates_ + pixel.samples % replicates_] +=
      (balance_ ? *balance_ * radiance : radiance) * double{sample.weight};
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

// As one with the pilot's pixel `p`.
void Film::mix_pixel(std::size_t i, const Film& pilot, std::size_t p, double pilot_weight) {
  Pixel& pixel = pixels_[i];
  const Pixel& before = pilot.pixels_[p];
  const bool is_own = pixel.samples >= replicates_;  // else some replicate has no mean
  const double weight = is_own ? pilot_weight : 1;
  const std::uint32_t own_samples = is_own ? pixel.samples : 0;
  const std::uint32_t samples = own_samples + before.samples;
  const auto of_replicate = [this](std::uint32_t count, std::uint32_t r) {
    return static_cast<double>((count + replicates_ - 1 - r) / replicates_);
  };
  for (std::uint32_t r = 0; r < replicates_; ++r) {
    Vec3d& sum = sums_[i * replicates_ + r];
    const Vec3d own = is_own ? sum / of_replicate(own_samples, r) : Vec3d(0.0);
    const Vec3d pilots =
        pilot.sums_[p * replicates_ + r] / std::max(of_replicate(before.samples, r), 1.0);
    sum = (own * (1 - weight) + pilots * weight) * of_replicate(samples, r);
  }
  const double own_alpha = is_own ? pixel.alpha / own_samples : 0;
  pixel.alpha = (own_alpha * (1 - weight) + before.alpha / before.samples * weight) * samples;
  pixel.samples = samples;
  pixel.cost += before.cost;
}

Film Film::with_pilot(const Film& pilot, double pilot_weight) const {
  Film mixed = *this;
  for (int y = crop_.y0; y < crop_.y1; ++y)
    for (int x = crop_.x0; x < crop_.x1; ++x) {
      const std::size_t i = index(x, y);
      const std::size_t p = pilot.index(x, y);
      if (pilot.pixels_[p].samples == 0) continue;
      mixed.mix_pixel(i, pilot, p, pilot_weight);
      if (mixed.aov_pixels_.empty()) continue;
      AovPixel& aov = mixed.aov_pixels_[i];
      const AovPixel& before = pilot.aov_pixels_[p];
      aov.albedo += before.albedo;
      aov.normal += before.normal;
      aov.position += before.position;
      aov.depth += before.depth;
      aov.hits += before.hits;
      aov.material = before.material;
    }
  return mixed;
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

double Film::mean_samples() const {
  if (pixels_.empty()) return 0;
  double sum = 0;
  for (const Pixel& pixel : pixels_) sum += pixel.samples;
  return sum / static_cast<double>(pixels_.size());
}

Vec3d Film::mean(std::size_t i) const {
  if (pixels_[i].samples == 0) return Vec3d(0.0);
  Vec3d sum(0.0);
  for (std::uint32_t r = 0; r < replicates_; ++r) sum += replicate_sum(i, r);
  return sum / static_cast<double>(pixels_[i].samples);
}

}  // namespace candela
