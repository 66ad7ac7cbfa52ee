// A mixture of distributions of directions, each about a place in space that light comes from, so
// that it turns and widens as one goes nearer (parallax) [Ruppert20, section 4.3].
//
// Each is a spherical Cauchy distribution [Kato20]: with the angle theta from its axis its density
// is (1 + 2 a) / (4 pi (1 + a (1 - cos theta))^2); a = 0 is uniform, and half of a narrow one lies
// within theta = sqrt(2 / a). Its long tails forgive what few paths have shown, and but for the
// azimuth it is sampled without transcendental functions.
#pragma once

#include <array>

#include "renderer/math/constants.h"
#include "renderer/math/float4.h"
#include "renderer/math/frame.h"
#include "renderer/math/transcendental.h"
#include "renderer/math/vec.h"

namespace candela {

inline constexpr std::size_t mixture_size = 8;

// A number for each target.
struct MixtureLanes {
  std::array<Float4, mixture_size / 4> four{};

  [[nodiscard]] float operator[](std::size_t i) const { return four[i / 4][i % 4]; }
  void set(std::size_t i, double value) { four[i / 4][i % 4] = static_cast<float>(value); }
};

// Of a cell.
struct TargetMixture {
  MixtureLanes x, y, z;
  MixtureLanes inverse_spread2;  // 2 / (mean square of the distance from there)
  MixtureLanes weight;           // sums to 1; 0: none
  float share = 0;               // of the paths that should follow it; 0: it does not pay
};

struct GuidedDirection {
  Vec3f wi{0};
  float pdf = 0;  // solid angle
};

// The mixture as a point sees it.
class TargetsSeen {
 public:
  TargetsSeen() = default;
  TargetsSeen(const TargetMixture& mixture, const Vec3f& from) : weight_(&mixture.weight) {
    const Float4 largest_a = broadcast(1e4f);
    const Float4 aside = broadcast(1e-15f);  // no target is just where the point is
    for (std::size_t i = 0; i < mixture_size / 4; ++i) {
      const Float4 x = mixture.x.four[i] - broadcast(from.x);
      const Float4 y = mixture.y.four[i] - broadcast(from.y);
      const Float4 z = mixture.z.four[i] - broadcast(from.z) + aside;
      const Float4 distance2 = x * x + y * y + z * z;
      const Float4 inverse = broadcast(1) / square_root(distance2);
      x_.four[i] = x * inverse;
      y_.four[i] = y * inverse;
      z_.four[i] = z * inverse;
      a_.four[i] = min(distance2 * mixture.inverse_spread2.four[i], largest_a);
      peak_.four[i] =
          mixture.weight.four[i] * (broadcast(1) + a_.four[i] * 2) * broadcast(inverse_pi / 4);
    }
  }

  [[nodiscard]] bool is_known() const { return weight_ != nullptr; }

  // Of a unit direction, by solid angle.
  [[nodiscard]] float pdf(const Vec3f& wi) const {
    Float4 sum = broadcast(0);
    for (std::size_t i = 0; i < mixture_size / 4; ++i) {
      const Float4 cosine = x_.four[i] * broadcast(wi.x) + y_.four[i] * broadcast(wi.y) +
                            z_.four[i] * broadcast(wi.z);
      const Float4 fall = broadcast(1) + a_.four[i] * max(broadcast(1) - cosine, broadcast(0));
      sum += peak_.four[i] / (fall * fall);
    }
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
  }

  // All in [0, 1).
  [[nodiscard]] GuidedDirection sample(float choice, Vec2f u) const {
    const std::size_t i = pick(choice);
    // 1 - cos theta, by inversion.
    const float below = std::min(2 * u.x / (1 + 2 * a_[i] * (1 - u.x)), 2.0f);
    const float sine = std::sqrt(below * (2 - below));
    const SinCos azimuth = sin_cos_of_turns(u.y);
    const Vec3f wi = frame_from_normal({x_[i], y_[i], z_[i]})
                         .to_world({sine * azimuth.cos, sine * azimuth.sin, 1 - below});
    return {wi, pdf(wi)};
  }

 private:
  [[nodiscard]] std::size_t pick(float choice) const {
    std::size_t last = 0;
    float sum = 0;
    for (std::size_t i = 0; i < mixture_size && !(choice < sum); ++i) {
      if (!((*weight_)[i] > 0)) continue;
      sum += (*weight_)[i];
      last = i;
    }
    return last;
  }

  const MixtureLanes* weight_ = nullptr;
  MixtureLanes x_, y_, z_, a_;
  MixtureLanes peak_;  // the density on the axis, times the weight
};

}  // namespace candela
