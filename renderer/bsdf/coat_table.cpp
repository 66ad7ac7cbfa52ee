#include "renderer/bsdf/coat_table.h"

#include <cmath>

#include "renderer/base/parallel.h"
#include "renderer/bsdf/ggx.h"
#include "renderer/math/constants.h"

namespace candela {
namespace {

// Smith's Lambda [Heitz14, eq. 72].
double smith_lambda(double cosine, double a) {
  const double tan2 = (1 - cosine) * (1 + cosine) / (cosine * cosine);
  return 0.5 * (std::sqrt(1 + a * a * tan2) - 1);
}

// Where a ray goes at one microfacet, its share of the light, and what is left after the masking.
struct Split {
  double reflectance = 1;
  double cos_reflected = 0;    // <= 0: not up again
  double cos_transmitted = 0;  // <= 0: not through
};

// One interface seen from the side of index 1; `eta` is the other side's. In the plane of x and z.
class Interface {
 public:
  Interface(double eta, double a) : eta_(eta), a_(a) {}

  [[nodiscard]] Split at(double cos_o, const Vec3d& m) const {
    const double sin_o = std::sqrt((1 - cos_o) * (1 + cos_o));
    const double cosine = sin_o * m.x + cos_o * m.z;
    if (cosine <= 0) return {1, 0, 0};
    const auto fresnel =
        fresnel_dielectric(static_cast<float>(std::min(1.0, cosine)), static_cast<float>(eta_));
    const double cos_t2 = 1 - (1 - cosine * cosine) / (eta_ * eta_);
    Split split{double{fresnel.reflectance}, 2 * cosine * m.z - cos_o, 0};
    if (cos_t2 > 0)
      split.cos_transmitted = cos_o / eta_ - m.z * (cosine / eta_ - std::sqrt(cos_t2));
    return split;
  }
  // G2 / G1(o) of a normal that is seen: what is left of light that leaves at the cosine.
  [[nodiscard]] double left(double cos_o, double cosine) const {
    if (a_ == 0) return 1;
    return (1 + smith_lambda(cos_o, a_)) /
           (1 + smith_lambda(cos_o, a_) + smith_lambda(std::min(1.0, cosine), a_));
  }
  // The mean of value(split) over the visible normals [Dupuy23, listing 3]: half of them mirrors
  // the other. Rings are shifted from turn to turn by the golden ratio.
  template <class Value>
  [[nodiscard]] double mean(double cos_o, const Value& value) const {
    if (a_ == 0) return value(at(cos_o, Vec3d(0, 0, 1)));
    constexpr int turns = 16;
    constexpr int rings = 32;
    const double sin_o = std::sqrt((1 - cos_o) * (1 + cos_o));
    const Vec3d stretched = normalize(Vec3d(a_ * sin_o, 0, cos_o));
    double sum = 0;
    for (int i = 0; i < turns; ++i) {
      const double shift = std::fmod(0.5 + i * 0.6180339887498949, 1.0);
      for (int j = 0; j < rings; ++j) {
        const double phi = pi_double * (i + 0.5) / turns;
        const double z = (1 - (j + shift) / rings) * (1 + stretched.z) - stretched.z;
        const double r = std::sqrt(std::max(0.0, 1 - z * z));
        const Vec3d cap = stretched + Vec3d(r * std::cos(phi), r * std::sin(phi), z);
        sum += value(at(cos_o, normalize(Vec3d(a_ * cap.x, a_ * cap.y, cap.z))));
      }
    }
    return sum / (turns * rings);
  }

 private:
  double eta_;
  double a_;
};

double absorbed(double thickness, double cosine) {
  return std::exp(-thickness / cosine);
}

// 2 times the integral of value(c) c dc over (0, `edge`) and (edge, 1), with c = x^2: fine where
// interfaces are steep, and never across the edge of total reflection.
template <class Value>
double cosine_mean(double edge, const Value& value) {
  constexpr int steps = 96;
  const double roots[] = {0, std::sqrt(edge), 1};
  double sum = 0;
  for (int part = 0; part < 2; ++part) {
    const double step = (roots[part + 1] - roots[part]) / steps;
    if (!(step > 0)) continue;
    for (int i = 0; i < steps; ++i) {
      const double x = roots[part] + (i + 0.5) * step;
      sum += 4 * x * x * x * value(x * x) * step;
    }
  }
  return sum;
}

}  // namespace

CoatTable::Row CoatTable::make_row(double alpha) const {
  const double a = alpha < double{smallest_ggx_width} ? 0 : alpha;
  const double thickness = thickness_;
  const Interface outside(double{eta_}, a);
  const auto transmitted = [&](double c) {
    return outside.mean(c, [&](const Split& split) {
      if (split.cos_transmitted <= 0) return 0.0;
      return (1 - split.reflectance) * outside.left(c, split.cos_transmitted) *
             absorbed(thickness, split.cos_transmitted);
    });
  };
  Row row;
  for (std::size_t i = 1; i <= intervals; ++i) {
    const double root = static_cast<double>(i) / intervals;
    row.transmittances[i] = static_cast<float>(transmitted(root * root));
  }
  // At the grazing end rough interfaces still let light through.
  row.transmittances[0] = static_cast<float>(transmitted(1e-6));

  const Interface inside(1 / double{eta_}, a);
  const double critical = std::sqrt(1 - 1 / square(double{eta_}));
  row.internal_reflectance = static_cast<float>(cosine_mean(critical, [&](double c) {
    return absorbed(thickness, c) * inside.mean(c, [&](const Split& split) {
      if (split.cos_reflected <= 0) return 0.0;
      return split.reflectance * inside.left(c, split.cos_reflected) *
             absorbed(thickness, split.cos_reflected);
    });
  }));
  const auto interpolated = [&](double c) {
    const Place at = place(static_cast<float>(std::sqrt(c)), intervals);
    const float* values = &row.transmittances[at.index];
    return double{values[0] + (values[1] - values[0]) * at.fraction};
  };
  row.mean_transmittance = static_cast<float>(cosine_mean(0.5, interpolated));
  return row;
}

CoatTable::CoatTable(float eta, float thickness, float alpha) : eta_(eta), thickness_(thickness) {
  if (alpha >= 0) {
    rows_.push_back(make_row(double{alpha}));
    return;
  }
  rows_.resize(row_intervals + 1);
  parallel_for(rows_.size(), [&](std::size_t i) {
    rows_[i] = make_row(square(square(static_cast<double>(i) / row_intervals)));
  });
}

}  // namespace candela
