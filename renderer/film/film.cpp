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

void Film::take_pixel(std::size_t i, const Film& other, std::size_t from) {
  pixels_[i] = other.pixels_[from];
  for (std::uint32_t r = 0; r < replicates_; ++r)
    sums_[i * replicates_ + r] = other.sums_[from * replicates_ + r];
  if (!aov_pixels_.empty() && !other.aov_pixels_.empty()) aov_pixels_[i] = other.aov_pixels_[from];
}

Film Film::cropped(const PixelRect& crop) const {
  Film part(full_width_, full_height_, crop, aovs_, replicates_, balance_);
  for (int y = crop.y0; y < crop.y1; ++y)
    for (int x = crop.x0; x < crop.x1; ++x) part.take_pixel(part.index(x, y), *this, index(x, y));
  return part;
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
