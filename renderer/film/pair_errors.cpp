#include "renderer/film/pair_errors.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/floating_point_traps.h"
#include "renderer/base/vector_widths.h"

namespace candela {
namespace {

// 1 / (r^2 + epsilon) of one channel from an estimate of r with a known variance. Plugging it in
// overstates where it is noisy; the second-order term of Taylor's series takes that away.
inline double inverse_square(double estimate, double variance, double epsilon) {
  const double square = estimate * estimate;
  const double inverse = 1 / (square + epsilon);
  const double curvature = (6 * square - 2 * epsilon) * inverse * inverse;  // of it, over it
  constexpr double most = 0.5;  // of the correction, where the series says nothing
  return (1 - std::clamp(0.5 * curvature * variance, -most, most)) * inverse;
}

inline double error_of_level(const PixelLevel& level, const Vec3d& variance, double epsilon) {
  const Vec3d inverse_squares(inverse_square(level.mean.x, level.variance.x, epsilon),
                              inverse_square(level.mean.y, level.variance.y, epsilon),
                              inverse_square(level.mean.z, level.variance.z, epsilon));
  return sum_of_components(variance * inverse_squares) / 3;
}

// How near to a pixel's own mean its level is: as its noise is small beside the structure
// [James61].
inline double trust_in(double structure, double own_noise) {
  return structure > 0 ? structure / (structure + own_noise) : 0.0;
}

// Not nearer to black than `size`, on the side of `sign`: a white balance or a filter makes
// channels negative.
inline double beyond(double value, double size, double sign) {
  return std::copysign(std::max(std::copysign(1.0, sign) * value, size), sign);
}
inline Vec3d beyond(const Vec3d& value, const Vec3d& size, const Vec3d& sign) {
  return {beyond(value.x, size.x, sign.x), beyond(value.y, size.y, sign.y),
          beyond(value.z, size.z, sign.z)};
}

// The side of the one that is farther from black.
inline double side_of(double a, double b) {
  return std::abs(a) < std::abs(b) ? b : a;
}
inline Vec3d side_of(const Vec3d& a, const Vec3d& b) {
  return {side_of(a.x, b.x), side_of(a.y, b.y), side_of(a.z, b.z)};
}

// Between the neighbours that look alike and `own`, the pixel's mean over a share of its samples;
// never far below them, since a pixel whose light comes in rare samples is black without those, but
// where no neighbour looks alike: a dark pixel among bright ones is dark.
// Where too much noise is left, all that is near by. Rare light comes on top: the pixel's own says
// little of how rare it is.
inline PixelLevel level_of(const NeighbourLevel& near, const Vec3d& own, double own_share,
                           double epsilon) {
  const Vec3d own_noise = near.own_variance * (1 / own_share);
  const Vec3d trust(trust_in(near.structure.x, own_noise.x),
                    trust_in(near.structure.y, own_noise.y),
                    trust_in(near.structure.z, own_noise.z));
  const Vec3d between = near.mean + trust * (own - near.mean);
  const Vec3d lowest = near.company / 3 * near.mean;
  const Vec3d side = side_of(between, lowest);
  const Vec3d mean = beyond(between, glm::abs(lowest), side);
  const Vec3d variance = (1.0 - trust) * (1.0 - trust) * near.noise;
  constexpr double much = 0.3;  // variance over level: at twice that nothing else counts
  const double noise = sum_of_components(variance / (mean * mean + epsilon)) / 3;
  const double blend = std::clamp(noise / much - 1, 0.0, 1.0);
  return {beyond(mix(mean, near.wide_mean, blend) + near.rare, glm::abs(lowest), side),
          variance * (1 - blend) * (1 - blend) + near.rare_noise};
}

// What a pixel is without the noise of a pair of its replicates: the mean of the others. Of two
// alone none is left, but the product of their means has the mean r^2: neither's noise is in it.
struct OwnLevel {
  Vec3d mean;
  double share;  // of the pixel's samples
};
inline OwnLevel level_beside_pair(const SampleSum& whole, const SampleSum& a, const SampleSum& b) {
  const double others = whole.samples - a.samples - b.samples;
  const double are_none = others > 0 ? 0.0 : 1.0;
  const double samples = others > 0 ? others : whole.samples;
  const Vec3d square = a.radiance * b.radiance * (1 / (a.samples * b.samples));
  const Vec3d size = glm::sqrt(max(square, 0.0));
  const Vec3d root(std::copysign(size.x, whole.radiance.x), std::copysign(size.y, whole.radiance.y),
                   std::copysign(size.z, whole.radiance.z));
  const Vec3d of_others = (whole.radiance - a.radiance - b.radiance) * (1 / samples);
  return {of_others + are_none * root, samples / whole.samples};
}

// The level that the error is held against is made without the pair: were it of the same noise,
// pixels that are too bright by chance would hide their own error.
inline double error_of_pair(const NeighbourLevel& near, const SampleSum& whole, const SampleSum& a,
                            const SampleSum& b, double epsilon) {
  const double one_of_a = 1 / a.samples;
  const double one_of_b = 1 / b.samples;
  const Vec3d difference = a.radiance * one_of_a - b.radiance * one_of_b;
  // One sample's variance is that of the difference over the sum of both.
  const Vec3d variance = difference * difference * (1 / ((one_of_a + one_of_b) * whole.samples));
  const OwnLevel own = level_beside_pair(whole, a, b);
  return error_of_level(level_of(near, own.mean, own.share, epsilon), variance, epsilon);
}

CANDELA_LANES void add_errors(const LevelLanes& near, const SampleSumLanes& whole,
                              const SampleSumLanes& a, const SampleSumLanes& b, double epsilon,
                              Lanes<double>& errors) {
  for (std::size_t i = 0; i < block_size; ++i)
    errors[i] += error_of_pair(near[i], whole[i], a[i], b[i], epsilon);
}

}  // namespace

void add_errors_of_pair(const LevelLanes& near, const SampleSumLanes& whole,
                        const SampleSumLanes& a, const SampleSumLanes& b, double epsilon,
                        Lanes<double>& errors) {
  const FloatingPointTraps traps(Traps::Off);  // lanes that nothing is in
  add_errors(near, whole, a, b, epsilon, errors);
}

double error_beside(const PixelLevel& level, const Vec3d& variance, double epsilon) {
  return error_of_level(level, variance, epsilon);
}

}  // namespace candela
