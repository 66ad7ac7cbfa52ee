#include "renderer/bsdf/coated_metal_table.h"

#include <cmath>
#include <vector>

#include "renderer/base/parallel.h"
#include "renderer/bsdf/coated_conductor.h"
#include "renderer/bsdf/ggx.h"
#include "renderer/sampling/sobol.h"

namespace candela {
namespace {

double smith_lambda(double cosine, double a) {
  return 0.5 * (std::sqrt(1 + a * a * (1 - cosine) * (1 + cosine) / (cosine * cosine)) - 1);
}

Vec3d visible_normal(const Vec3d& w, double a, Vec2f u) {
  if (a == 0) return {0, 0, 1};
  const Vec3d stretched = normalize(Vec3d(a * w.x, a * w.y, w.z));
  const double z = (1 - double{u.y}) * (1 + stretched.z) - stretched.z;
  const double r = std::sqrt(std::max(0.0, 1 - z * z));
  const double phi = 2 * pi_double * double{u.x};
  const Vec3d cap = stretched + Vec3d(r * std::cos(phi), r * std::sin(phi), z);
  return normalize(Vec3d(a * cap.x, a * cap.y, cap.z));
}

// G2 / G1(w) of a normal that w sees.
double left(double a, double cos_w, double cosine) {
  if (a == 0) return 1;
  const double own = 1 + smith_lambda(cos_w, a);
  return own / (own + smith_lambda(std::min(1.0, cosine), a));
}

// Follows light through the layers; at the coat it goes both ways, with its shares as weights.
class Walk {
 public:
  Walk(const Bsdf& bsdf, const CoatedMetalLayers& layers, std::uint32_t index)
      : bsdf_(bsdf),
        coat_alpha_(layers.coat_alpha),
        metal_alpha_(layers.metal_alpha),
        eta_(bsdf.coat->eta()),
        index_(index) {}

  // What comes out again from below, of light from the cosine.
  Vec3d from(double cos_o) {
    const Vec3d wo(std::sqrt((1 - cos_o) * (1 + cos_o)), 0, cos_o);
    const Crossing in = cross(wo, eta_);
    if (in.down.z >= 0) return Vec3d(0.0);
    Vec3d weight(in.through);
    Vec3d w = -in.down;
    Vec3d out(0.0);
    constexpr int most = 64;  // weights are below 1e-3 long before
    const int bounces = bsdf_.metal_bounces > 0 ? bsdf_.metal_bounces : most;
    for (int i = 0; i < bounces; ++i) {
      weight *= absorbed(w.z);
      const Vec3d up = off_metal(w, weight);
      if (up.z <= 0) break;
      weight *= absorbed(up.z);
      const Crossing at_top = cross(up, 1 / eta_);
      out += weight * at_top.through;
      weight *= at_top.back;
      if (at_top.reflected.z <= 0 || max_component(weight) < 1e-4) break;
      w = at_top.reflected;
    }
    return out;
  }

 private:
  struct Crossing {
    Vec3d down{0.0};  // refracted: z < 0 where it goes through
    Vec3d reflected{0.0};
    double through = 0, back = 0;  // shares that go on
  };

  Vec2f numbers() { return owen_sobol_2d(index_, 1000 + turn_++); }
  [[nodiscard]] double absorbed(double cosine) const {
    return std::exp(-double{bsdf_.coat->thickness()} / cosine);
  }

  Crossing cross(const Vec3d& w, double eta) {
    const Vec3d m = visible_normal(w, coat_alpha_, numbers());
    const double cosine = dot(w, m);
    const double cos_t2 = 1 - (1 - cosine * cosine) / (eta * eta);
    const double f = cos_t2 > 0
                         ? double{fresnel_dielectric(static_cast<float>(std::min(1.0, cosine)),
                                                     static_cast<float>(eta))
                                      .reflectance}
                         : 1;
    Crossing c;
    c.reflected = m * (2 * cosine) - w;
    if (c.reflected.z > 0) c.back = f * left(coat_alpha_, w.z, c.reflected.z);
    if (f < 1) {
      c.down = m * (cosine / eta - std::sqrt(cos_t2)) - w / eta;
      if (c.down.z < 0) c.through = (1 - f) * left(coat_alpha_, w.z, -c.down.z);
    }
    return c;
  }

  Vec3d off_metal(const Vec3d& w, Vec3d& weight) {
    const Vec3d m = visible_normal(w, metal_alpha_, numbers());
    const double cosine = dot(w, m);
    const Vec3d up = m * (2 * cosine) - w;
    if (up.z <= 0) return up;
    const auto c = static_cast<float>(std::min(1.0, cosine));
    weight *= Vec3d(fresnel_conductor(c, bsdf_.eta, bsdf_.k)) * left(metal_alpha_, w.z, up.z);
    return up;
  }

  const Bsdf& bsdf_;
  double coat_alpha_;
  double metal_alpha_;
  double eta_;
  std::uint32_t index_;
  std::uint32_t turn_ = 0;
};

// One direction of the lobe: what it brings before it is scaled, and where to.
struct Brought {
  Vec3d value;
  float cosine;
};

constexpr std::uint32_t walks = 8192;  // 1 % of dark albedos
constexpr std::uint32_t directions = 1024;

Vec3d walked_albedo(const Bsdf& bsdf, const CoatedMetalLayers& layers, double cos_o) {
  Vec3d sum(0.0);
  for (std::uint32_t i = 0; i < walks; ++i) sum += Walk(bsdf, layers, i).from(cos_o);
  return sum / double{walks};
}

std::vector<Brought> lobe_from(const Bsdf& bsdf, float cos_o) {
  std::vector<Brought> all;
  const Vec3f wo{std::sqrt((1 - cos_o) * (1 + cos_o)), 0, cos_o};
  for (std::uint32_t i = 0; i < directions; ++i) {
    const Vec3f wi = sample_coated_metal(bsdf, wo, owen_sobol_2d(i, 999));
    if (!(wi.z > 0)) continue;
    const BsdfEvaluation e = evaluate_coated_metal(bsdf, wo, wi);
    if (e.pdf > 0) all.push_back({Vec3d(e.value / e.pdf) / double{directions}, wi.z});
  }
  return all;
}

}  // namespace

CoatedMetalTable::CoatedMetalTable(const Bsdf& bsdf, const CoatedMetalLayers& layers) {
  std::array<Vec3d, intervals + 1> wanted;
  std::array<std::vector<Brought>, intervals + 1> lobes;
  parallel_for(intervals + 1, [&](std::size_t i) {
    const double cos_o = std::max(1e-3, square(static_cast<double>(i) / intervals));
    wanted[i] = walked_albedo(bsdf, layers, cos_o);
    lobes[i] = lobe_from(bsdf, static_cast<float>(cos_o));
    albedos_[i] = Rgb(wanted[i]);
    scales_[i] = Rgb(1);
  });
  // A product of both directions' factors, so that f stays reciprocal: each is turned by half of
  // what its own albedo lacks, again and again [Sinkhorn67].
  constexpr int turns = 30;
  constexpr double most = 4;  // where the lobe brings next to nothing
  for (int turn = 0; turn < turns; ++turn) {
    std::array<Rgb, intervals + 1> next = scales_;
    for (std::size_t i = 0; i <= intervals; ++i) {
      Vec3d sum(0.0);
      for (const Brought& b : lobes[i]) sum += b.value * Vec3d(scale(b.cosine));
      for (int c = 0; c < 3; ++c) {
        const double found = sum[c] * double{scales_[i][c]};
        if (!(found > 0)) continue;
        const double factor = std::sqrt(wanted[i][c] / found);
        next[i][c] = static_cast<float>(std::min(most, double{scales_[i][c]} * factor));
      }
    }
    scales_ = next;
  }
}

}  // namespace candela
