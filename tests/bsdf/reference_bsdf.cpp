#include "tests/bsdf/reference_bsdf.h"

#include <algorithm>
#include <complex>

#include "renderer/math/constants.h"

namespace candela::tests {

double exact_fresnel(double cos_theta, std::complex<double> eta) {
  const double sin2 = 1 - cos_theta * cos_theta;
  const std::complex<double> cos_t = std::sqrt(1.0 - sin2 / (eta * eta));
  const std::complex<double> s = (cos_theta - eta * cos_t) / (cos_theta + eta * cos_t);
  const std::complex<double> p = (eta * cos_theta - cos_t) / (eta * cos_theta + cos_t);
  return std::min(1.0, 0.5 * (std::norm(s) + std::norm(p)));
}

namespace {

double schlick(double f0, double f90, double cos_theta) {
  return f0 + (f90 - f0) * std::pow(1 - cos_theta, 5);
}

// Of one microfacet, or of a smooth surface, at the cosine to its normal.
double fresnel_of(const Bsdf& bsdf, double cosine) {
  const double c = std::min(1.0, cosine);
  const auto conductor = [&] { return exact_fresnel(c, {double{bsdf.eta.y}, -double{bsdf.k.y}}); };
  switch (bsdf.model) {
    case BsdfModel::CookTorrance:
    case BsdfModel::CompensatedCookTorrance:
      if (bsdf.fresnel == FresnelTerm::Schlick) return schlick(double{bsdf.f0.y}, 1, c);
      if (bsdf.fresnel == FresnelTerm::Conductor) return conductor();
      return exact_fresnel(c, {double{bsdf.eta.x}, 0});
    case BsdfModel::Lab:
      return schlick(double{bsdf.specular.y}, std::min(1.0, 50 * double{bsdf.specular.y}), c);
    case BsdfModel::Conductor:
    case BsdfModel::AnisotropicConductor:
      return conductor();
    case BsdfModel::Dielectric:
    case BsdfModel::AnisotropicDielectric:
    case BsdfModel::ThinDielectric:
      return exact_fresnel(c, {double{bsdf.eta.x}, 0});
    case BsdfModel::Diffuse:
    case BsdfModel::Mirror:
    case BsdfModel::DiffuseTransmission:
    case BsdfModel::CoatedDiffuse:
    case BsdfModel::CoatedConductor:
      return 0;
  }
  return 0;
}

bool is_anisotropic(const Bsdf& bsdf) {
  return bsdf.model == BsdfModel::AnisotropicConductor ||
         bsdf.model == BsdfModel::AnisotropicDielectric;
}
bool is_dielectric(const Bsdf& bsdf) {
  return bsdf.model == BsdfModel::Dielectric || bsdf.model == BsdfModel::AnisotropicDielectric;
}

// Along x and y.
Vec2d widths(const Bsdf& bsdf) {
  const float across = is_anisotropic(bsdf) ? bsdf.alpha_across : bsdf.alpha;
  return {double{std::clamp(bsdf.alpha, 1e-4f, 1.0f)}, double{std::clamp(across, 1e-4f, 1.0f)}};
}

// [Heitz14, eqs. 85 and 86; of one width Walter07, eq. 33], which float could not take as it
// stands.
double distribution(const Vec3d& h, const Vec2d& a) {
  const double base = square(h.x / a.x) + square(h.y / a.y) + h.z * h.z;
  return 1 / (pi_double * a.x * a.y * base * base);
}
double lambda(const Vec3d& w, const Vec2d& a) {
  const double stretched_tan2 = (square(a.x * w.x) + square(a.y * w.y)) / (w.z * w.z);
  return 0.5 * (std::sqrt(1 + stretched_tan2) - 1);
}
double smith_correlated(const Vec3d& wo, const Vec3d& wi, const Vec2d& a) {
  return 1 / (1 + lambda(wo, a) + lambda(wi, a));
}
double smith_separable(const Vec3d& wo, const Vec3d& wi, const Vec2d& a) {
  return 1 / ((1 + lambda(wo, a)) * (1 + lambda(wi, a)));
}
double schlick_ggx(double c, double a) {
  const double k = (a + 1) * (a + 1) / 8;
  return c / (c * (1 - k) + k);
}
double reflection_masking(const Bsdf& bsdf, const Vec3d& wo, const Vec3d& wi, const Vec2d& a) {
  const bool has_choice = bsdf.model == BsdfModel::CookTorrance;
  if (has_choice && bsdf.geometry == GeometryTerm::SchlickGgx)
    return schlick_ggx(wo.z, a.x) * schlick_ggx(wi.z, a.x);
  return smith_correlated(wo, wi, a);
}

double specular_factor(const Bsdf& bsdf) {
  return bsdf.model == BsdfModel::CookTorrance ? double{bsdf.specular.y} : 1;
}

bool has_diffuse_part(const Bsdf& bsdf) {
  return bsdf.model == BsdfModel::Diffuse || bsdf.model == BsdfModel::CookTorrance ||
         bsdf.model == BsdfModel::Lab;
}
// f of the diffuse part.
double diffuse_value(const Bsdf& bsdf, double co, double ci) {
  if (!has_diffuse_part(bsdf)) return 0;
  const double lambert = double{bsdf.diffuse.y} / pi_double;
  if (bsdf.model != BsdfModel::Lab) return lambert;
  return lambert * (1 - fresnel_of(bsdf, co)) * (1 - fresnel_of(bsdf, ci));
}

double reflection(const Bsdf& bsdf, const Vec3d& wo, const Vec3d& wi) {
  const Vec2d a = widths(bsdf);
  const Vec3d h = normalize(wo + wi);
  return specular_factor(bsdf) * fresnel_of(bsdf, dot(wo, h)) *
         reflection_masking(bsdf, wo, wi, a) * distribution(h, a) / (4 * wo.z * wi.z);
}

// [Walter07, eqs. 16, 20 and 21], with the 1 / eta^2 of radiance.
double refraction(const Bsdf& bsdf, const Vec3d& wo, const Vec3d& wi) {
  const Vec2d a = widths(bsdf);
  const double eta = bsdf.eta.x;
  Vec3d h = -(wo + eta * wi);
  h = normalize(h.z < 0 ? -h : h);
  const double oh = dot(wo, h);
  const double ih = dot(wi, h);
  if (oh <= 0 || ih >= 0) return 0;
  const double jacobian = 1 / square(eta * ih + oh);
  return double{bsdf.transmittance.y} * std::abs(ih * oh / (wi.z * wo.z)) *
         (1 - fresnel_of(bsdf, oh)) * smith_separable(wo, wi, a) * distribution(h, a) * jacobian;
}

bool has_microfacets(const Bsdf& bsdf) {
  return bsdf.model == BsdfModel::CookTorrance || bsdf.model == BsdfModel::Lab ||
         bsdf.model == BsdfModel::Conductor || is_anisotropic(bsdf) || is_dielectric(bsdf);
}

// What a microfacet of normal m sends on, times its masking.
double microfacet_energy(const Bsdf& bsdf, const Vec3d& wo, const Vec3d& m, const Vec2d& a) {
  const double cosine = dot(wo, m);
  const double f = fresnel_of(bsdf, cosine);
  const Vec3d reflected = m * (2 * cosine) - wo;
  double energy = 0;
  if (reflected.z > 0)
    energy += specular_factor(bsdf) * f * reflection_masking(bsdf, wo, reflected, a);
  if (!is_dielectric(bsdf) || f >= 1) return energy;
  const double eta = bsdf.eta.x;
  const double cos_t = std::sqrt(std::max(0.0, 1 - (1 - cosine * cosine) / (eta * eta)));
  const Vec3d refracted = m * (cosine / eta - cos_t) - wo / eta;
  if (refracted.z < 0)
    energy += double{bsdf.transmittance.y} * (1 - f) * smith_separable(wo, refracted, a);
  return energy;
}

// The integral of energy D(m) (wo.m) / wo.z over normals. Of width 1, with tan^2 = (1 - v^2) / v^2
// and v in (0, 1), D cos dm = 2 v dv dphi / (2 pi); others are that one stretched, and the 1 / m.z
// that is left is bounded by v.
double microfacet_albedo(const Bsdf& bsdf, const Vec3d& wo, int steps) {
  const Vec2d a = widths(bsdf);
  const Vec2d stretched(a.x * wo.x, a.y * wo.y);
  const double aside = std::hypot(stretched.x, stretched.y);
  const double towards = std::atan2(stretched.y, stretched.x);
  double sum = 0;
  const auto add = [&](double v, double azimuth, double measure) {
    const double sin_m = std::sqrt(1 - v * v);
    const Vec3d m(a.x * sin_m * std::cos(azimuth), a.y * sin_m * std::sin(azimuth), v);
    const double length = glm::length(m);
    const double cosine = dot(wo, m / length);
    if (cosine > 0)
      sum += microfacet_energy(bsdf, wo, m / length, a) * measure * length * cosine / wo.z;
  };
  // The azimuths on either side of wo; of one width, the one is the other's mirror image.
  const bool is_symmetric = !is_anisotropic(bsdf);
  for (int i = 0; i < steps; ++i) {
    // Shifted from row to row by the golden ratio, so that edges along rows are cut many times.
    const double turn = 0.5 + i * 0.6180339887498949;
    for (int j = 0; j < steps; ++j) {
      const double s = (j + turn - std::floor(turn)) / steps;
      const double v = s * s;
      // Those within which the normal is seen.
      const double limit = -wo.z * v / std::max(1e-300, aside * std::sqrt(1 - v * v));
      const double range = std::acos(std::clamp(limit, -1.0, 1.0)) / pi_double;
      const double azimuth = pi_double * range * (i + 0.5) / steps;
      const double measure = 4 * s * range / (static_cast<double>(steps) * steps);
      if (is_symmetric) {
        add(v, towards + azimuth, measure);
      } else {
        add(v, towards + azimuth, measure / 2);
        add(v, towards - azimuth, measure / 2);
      }
    }
  }
  return sum;
}

double diffuse_albedo(const Bsdf& bsdf, double co) {
  constexpr int steps = 1000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double c = (i + 0.5) / steps;
    sum += diffuse_value(bsdf, co, c) * 2 * pi_double * c / steps;
  }
  return sum;
}

double smooth_albedo(const Bsdf& bsdf, double co) {
  const double f = fresnel_of(bsdf, co);
  if (bsdf.model == BsdfModel::Mirror) return double{bsdf.diffuse.y};
  if (bsdf.model == BsdfModel::Conductor) return f;
  const double t = bsdf.transmittance.y;
  if (is_dielectric(bsdf)) return f + t * (1 - f);
  // A pane: reflections between its faces, the tint once a crossing.
  const double inside = t * t * square(1 - f) / (1 - f * f);
  return f + inside * f + inside;
}

}  // namespace

double reference_value(const Bsdf& bsdf, const Vec3d& wo, const Vec3d& wi) {
  if (bsdf.is_smooth || wi.z == 0) return 0;
  if (wi.z < 0) return is_dielectric(bsdf) ? -wi.z * refraction(bsdf, wo, wi) : 0;
  const double specular = has_microfacets(bsdf) ? reflection(bsdf, wo, wi) : 0;
  return wi.z * (diffuse_value(bsdf, wo.z, wi.z) + specular);
}

double reference_albedo(const Bsdf& bsdf, const Vec3d& wo, int steps) {
  const bool is_smooth =
      bsdf.is_smooth || bsdf.model == BsdfModel::Mirror || bsdf.model == BsdfModel::ThinDielectric;
  if (is_smooth) return smooth_albedo(bsdf, wo.z);
  const double diffuse = has_diffuse_part(bsdf) ? diffuse_albedo(bsdf, wo.z) : 0;
  return diffuse + (has_microfacets(bsdf) ? microfacet_albedo(bsdf, wo, steps) : 0);
}

}  // namespace candela::tests
