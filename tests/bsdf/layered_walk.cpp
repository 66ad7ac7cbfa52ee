#include "tests/bsdf/layered_walk.h"

#include "renderer/math/constants.h"
#include "renderer/sampling/hash.h"
#include "tests/bsdf/reference_bsdf.h"

namespace candela::tests {
namespace {

class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(mix_bits(seed)) {}
  double next() {
    state_ = mix_bits(state_ + 0x9e3779b97f4a7c15u);
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

double lambda(double cosine, double a) {
  return 0.5 * (std::sqrt(1 + a * a * (1 - cosine * cosine) / (cosine * cosine)) - 1);
}

// A normal of the density D cos [Walter07, eqs. 35 and 36].
Vec3d sample_normal(double a, Numbers& numbers) {
  const double u = numbers.next();
  const double tan2 = a * a * u / (1 - u);
  const double cosine = 1 / std::sqrt(1 + tan2);
  const double sine = std::sqrt(1 - cosine * cosine);
  const double phi = 2 * pi_double * numbers.next();
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

struct Bounce {
  Vec3d direction{0.0};
  double weight = 0;  // 0: lost
  bool is_through = false;
};

// At an interface seen from w's side, w.z > 0, of the relative index `index` of the other side;
// metals let nothing through.
Bounce meet(const Vec3d& w, std::complex<double> index, bool is_metal, double a, Numbers& numbers) {
  const Vec3d m = a > 0 ? sample_normal(a, numbers) : Vec3d(0, 0, 1);
  const double cosine = dot(w, m);
  if (cosine <= 0) return {};
  const double eta = index.real();
  const double cos_t2 = 1 - (1 - cosine * cosine) / (eta * eta);
  const bool is_total = !is_metal && cos_t2 <= 0;
  const double f = is_total ? 1 : exact_fresnel(std::min(1.0, cosine), index);
  Bounce bounce;
  bounce.is_through = !is_metal && numbers.next() >= f;
  bounce.direction =
      bounce.is_through ? m * (cosine / eta - std::sqrt(cos_t2)) - w / eta : m * (2 * cosine) - w;
  const bool is_right_side = (bounce.direction.z > 0) != bounce.is_through;
  if (!is_right_side) return {};
  bounce.weight = is_metal ? f : 1;
  if (a > 0) {
    const double out = std::abs(bounce.direction.z);
    bounce.weight *= cosine / (w.z * m.z * (1 + lambda(w.z, a) + lambda(out, a)));
  }
  return bounce;
}

Bounce meet_below(const LayeredSurface& surface, const Vec3d& w, Numbers& numbers) {
  if (surface.metal)
    return meet(w, *surface.metal / surface.eta, true, surface.metal_alpha, numbers);
  const double r = std::sqrt(numbers.next());
  const double phi = 2 * pi_double * numbers.next();
  return {{r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - r * r)}, surface.reflectance, false};
}

}  // namespace

WalkEnd walk_layers(const LayeredSurface& surface, double cos_o, std::uint64_t seed) {
  Numbers numbers(seed);
  const Vec3d wo(std::sqrt((1 - cos_o) * (1 + cos_o)), 0, cos_o);
  const Bounce first = meet(wo, surface.eta, false, surface.coat_alpha, numbers);
  if (!first.is_through) return {first.weight, 0};
  double weight = first.weight;
  Vec3d w = -first.direction;  // seen from the surface
  for (int i = 0; surface.bounces == 0 || i < surface.bounces; ++i) {
    weight *= std::exp(-surface.thickness / w.z);
    const Bounce below = meet_below(surface, w, numbers);
    weight *= below.weight;
    if (!(weight > 1e-12)) break;
    weight *= std::exp(-surface.thickness / below.direction.z);
    const Vec3d up{below.direction.x, below.direction.y, below.direction.z};
    const Bounce above = meet(up, 1 / surface.eta, false, surface.coat_alpha, numbers);
    weight *= above.weight;
    if (above.is_through) return {0, weight};
    if (!(weight > 1e-12)) break;
    w = above.direction;
  }
  return {};
}

}  // namespace candela::tests
