// Where samples are summed: in double, a pixel's replicates (or pieces of its one sequence) apart,
// each in an order that the whole picture's scene and options tell.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/image/image.h"
#include "renderer/math/lanes.h"
#include "renderer/math/vec.h"

namespace candela {

// Half-open rectangle of pixels, y from the top.
struct PixelRect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  [[nodiscard]] int width() const { return x1 - x0; }
  [[nodiscard]] int height() const { return y1 - y0; }
  [[nodiscard]] bool is_empty() const { return x1 <= x0 || y1 <= y0; }
  [[nodiscard]] bool contains(int x, int y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
  // In rows from the top.
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - y0) * static_cast<std::size_t>(width()) +
           static_cast<std::size_t>(x - x0);
  }
  friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

// Layers beside the picture, all from the first hit of camera rays, averaged over the samples that
// hit (material_id: of sample 0), in file units; how many samples there are; and what is known of
// the error: the variance of the pixel's mean, what the truth lies within (pixel_interval.h), and a
// mask of where neither can be trusted (heavy_tails.h).
enum class Aov : std::uint8_t {
  Albedo,
  Normal,
  Depth,
  Position,
  MaterialId,
  Samples,
  Variance,
  Interval,
  HeavyTail
};
using AovSet = std::uint32_t;
constexpr AovSet aov_bit(Aov aov) {
  return 1u << static_cast<unsigned>(aov);
}

// What one camera sample brings.
struct FilmSample {
  Rgb radiance{0};
  float weight = 1;      // the filter's, of the radiance alone: the rest is averaged by its size
  float alpha = 1;       // 0 where the camera ray left the scene
  bool has_hit = false;  // the rest counts only then
  Rgb albedo{0};
  Vec3f normal{0};      // world space, unit, towards the camera
  Vec3d position{0.0};  // file units
  double depth = 0;     // distance from the camera, file units
  std::uint32_t material = 0;
};

// How many of a pixel's samples are of each replicate: they take turns.
struct SamplesByReplicate {
  std::uint32_t of_each = 0;
  std::uint32_t with_one_more = 0;

  [[nodiscard]] std::uint32_t of(std::uint32_t replicate) const {
    return of_each + (replicate < with_one_more ? 1 : 0);
  }
};

class Film {
 public:
  Film() = default;
  // `replicates`: at least 1. Sample s of a pixel belongs to replicate s mod `replicates`, whose
  // samples are independent of those of the others (sampler.h: PixelSampler). `balance` is what the
  // radiance of each sample is multiplied by (math/white_balance.h), so that all that is known of
  // the error is of the colours that the picture has; saturated ones may get negative parts.
  Film(int full_width, int full_height, PixelRect crop, AovSet aovs, std::uint32_t replicates = 1,
       const std::optional<Mat3d>& balance = {});

  // Of a film without samples: its samples are of one sequence, and in place of replicates pieces
  // of `samples` consecutive ones are summed apart, in turn. They are not independent, so that they
  // tell where there is more noise, but not how much there is.
  void sum_pieces_of(std::uint32_t samples) { samples_a_piece_ = samples; }
  // Sequences of random numbers that the samples of a pixel are of.
  [[nodiscard]] std::uint32_t sequences() const { return samples_a_piece_ > 0 ? 1 : replicates_; }

  // Adds sample `sample_index` of a pixel; when a film is read those of a pixel are the first ones,
  // whatever order they came in. Calls for one pixel come from one thread at a time. Coordinates of
  // the full picture. Non-finite or negative radiance must not come here: the caller counts it.
  void add(int x, int y, std::uint32_t sample_index, const FilmSample& sample) {
    const std::size_t i = index(x, y);
    sums_[i * replicates_ + sum_of(sample_index)] +=
        balanced(sample.radiance) * double{sample.weight};
    pixels_[i].alpha += static_cast<double>(sample.alpha);
    ++pixels_[i].samples;
    if (!aov_pixels_.empty() && sample.has_hit) add_first_hit(i, sample_index, sample);
  }
  // Its next one, where they come in order.
  void add(int x, int y, const FilmSample& sample) {
    add(x, y, pixels_[index(x, y)].samples, sample);
  }
  // The same of the samples of a block in the given lanes, at least one, which keep nothing of
  // their hits. The first lane's is `first_index`, and so on; they are added in this order.
  void add(int x, int y, std::uint32_t first_index, LaneMask lanes, const Vec3Lanes& radiance,
           const Lanes<float>& weight, const Lanes<float>& alpha);
  // More light of a sample that is there, times the filter's weights already: of either sign.
  void add_weighted(int x, int y, std::uint32_t sample_index, const Rgb& radiance) {
    sums_[index(x, y) * replicates_ + sum_of(sample_index)] += balanced(radiance);
  }
  // A sample that was invalid: it counts as black, and as clear, so that sums of others stand.
  void add_invalid(int x, int y);
  // What the pixel's samples took, in rays or the like: sample_density.h weighs it.
  void add_cost(int x, int y, std::uint32_t cost) { pixels_[index(x, y)].cost += cost; }

  // All pixels become as those of a film that has them, too (take_pixel()).
  void take_part_of(const Film& other);
  // Pixel i becomes as pixel `from` of a film with as many sequences, whose pieces are added up;
  // its layers as well where both films have some.
  void take_pixel(std::size_t i, const Film& other, std::size_t from);

  [[nodiscard]] const PixelRect& crop() const { return crop_; }
  [[nodiscard]] int full_width() const { return full_width_; }
  [[nodiscard]] int full_height() const { return full_height_; }
  [[nodiscard]] AovSet aovs() const { return aovs_; }
  [[nodiscard]] std::uint32_t replicates() const { return replicates_; }
  [[nodiscard]] std::size_t pixel_count() const { return pixels_.size(); }

  // What a film of such pixels holds for each of them.
  [[nodiscard]] static std::size_t bytes_a_pixel(AovSet aovs, std::uint32_t replicates);

  // A pixel's place in the crop, in rows from the top; the others take it.
  [[nodiscard]] std::size_t index(int x, int y) const { return crop_.index(x, y); }
  [[nodiscard]] std::uint32_t samples(std::size_t i) const { return pixels_[i].samples; }
  [[nodiscard]] std::uint32_t cost(std::size_t i) const { return pixels_[i].cost; }
  // Of pieces: where all are whole.
  [[nodiscard]] SamplesByReplicate samples_by_replicate(std::size_t i) const {
    return {pixels_[i].samples / replicates_, pixels_[i].samples % replicates_};
  }
  [[nodiscard]] const Vec3d& replicate_sum(std::size_t i, std::uint32_t replicate) const {
    return sums_[i * replicates_ + replicate];
  }
  // 0 where there is no sample.
  [[nodiscard]] Vec3d mean(std::size_t i) const;
  // Samples a pixel: the fewest and the most over the crop.
  [[nodiscard]] std::uint32_t min_samples() const;
  [[nodiscard]] std::uint32_t max_samples() const;
  [[nodiscard]] double mean_samples() const;

  // The means as an image of the crop's size: channels R G B, then A where `with_alpha`, then
  // layers under the names that Blender, tev and OIDN read: albedo.R .G .B, normal.X .Y .Z,
  // depth.Z, position.X .Y .Z, material_id.V, samples.V, variance.R .G .B, interval.R .G .B,
  // heavy_tail.V. Pixels without samples are 0.
  [[nodiscard]] Image to_image(bool with_alpha) const;

 private:
  struct Pixel {
    double alpha = 0;
    std::uint32_t samples = 0;
    std::uint32_t cost = 0;
  };
  struct AovPixel {
    Vec3d albedo{0.0};
    Vec3d normal{0.0};
    Vec3d position{0.0};
    double depth = 0;
    std::uint32_t hits = 0;
    std::uint32_t material = 0;  // + 1; 0: none
  };

  // Which of a pixel's sums a sample belongs to.
  [[nodiscard]] std::uint32_t sum_of(std::uint32_t sample_index) const {
    const std::uint32_t turn =
        samples_a_piece_ > 0 ? sample_index / samples_a_piece_ : sample_index;
    return turn % replicates_;
  }
  [[nodiscard]] Vec3d balanced(const Rgb& radiance) const {
    const Vec3d light(radiance);
    return balance_ ? *balance_ * light : light;
  }
  void add_first_hit(std::size_t i, std::uint32_t sample_index, const FilmSample& sample);

  int full_width_ = 0;
  int full_height_ = 0;
  PixelRect crop_;
  AovSet aovs_ = 0;
  std::uint32_t replicates_ = 1;
  std::uint32_t samples_a_piece_ = 0;  // 0: there are replicates
  std::vector<Pixel> pixels_;
  std::vector<Vec3d> sums_;  // of radiance: `replicates_` a pixel
  std::vector<AovPixel> aov_pixels_;
  std::optional<Mat3d> balance_;
};

}  // namespace candela
