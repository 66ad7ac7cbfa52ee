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

// A pixel's sums stay in registers as long as one after the other adds to the same.
void Film::add(int x, int y, std::uint32_t first_index, LaneMask lanes, const Vec3Lanes& radiance,
               const Lanes<float>& weight, const Lanes<float>& alpha) {
  const std::size_t i = index(x, y);
  Vec3d* sums = &sums_[i * replicates_];
  std::uint32_t at = sum_of(first_index);
  Vec3d sum = sums[at];
  double sum_of_alpha = pixels_[i].alpha;
  for_each_lane(lanes, [&](std::uint32_t lane) {
    if (const std::uint32_t next = sum_of(first_index + lane); next != at) {
      sums[at] = sum;
      sum = sums[next];
      at = next;
    }
    sum += balanced(radiance[lane]) * double{weight[lane]};
    sum_of_alpha += static_cast<double>(alpha[lane]);
  });
  sums[at] = sum;
  pixels_[i].alpha = sum_of_alpha;
  pixels_[i].samples += lane_count(lanes);
}

void Film::add_first_hit(std::size_t i, std::uint32_t sample_index, const FilmSample& sample) {
  AovPixel& aov = aov_pixels_[i];
  aov.albedo += Vec3d(sample.albedo);
  aov.normal += Vec3d(sample.normal);
  aov.position += sample.position;
  aov.depth += sample.depth;
  ++aov.hits;
  if (sample_index == 0) aov.material = sample.material + 1;
}

void Film::add_invalid(int x, int y) {
  ++pixels_[index(x, y)].samples;
}

void Film::take_pixel(std::size_t i, const Film& other, std::size_t from) {
  pixels_[i] = other.pixels_[from];
  for (std::uint32_t r = 0; r < replicates_; ++r) sums_[i * replicates_ + r] = Vec3d(0.0);
  for (std::uint32_t r = 0; r < other.replicates_; ++r)
    sums_[i * replicates_ + r % replicates_] += other.sums_[from * other.replicates_ + r];
  if (!aov_pixels_.empty() && !other.aov_pixels_.empty()) aov_pixels_[i] = other.aov_pixels_[from];
}

void Film::take_part_of(const Film& other) {
  for (int y = crop_.y0; y < crop_.y1; ++y)
    for (int x = crop_.x0; x < crop_.x1; ++x) take_pixel(index(x, y), other, other.index(x, y));
}

std::size_t Film::bytes_a_pixel(AovSet aovs, std::uint32_t replicates) {
  return sizeof(Pixel) + replicates * sizeof(Vec3d) +
         ((aovs & first_hit_aovs) != 0 ? sizeof(AovPixel) : 0);
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
