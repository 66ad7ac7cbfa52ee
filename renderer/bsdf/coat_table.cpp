#include "renderer/bsdf/coat_table.h"

#include <cmath>

#include "renderer/base/parallel.h"
#include "renderer/bsdf/ggx.h"
#include "renderer/bsdf/table_microfacets.h"

namespace candela {
namespace {

// An interface seen from the side of index 1; `eta` is the other side's.
struct Interface {
  double eta;
  double a;

  // The mean of value(split) over the visible normals.
  template <class Value>
  [[nodiscard]] double mean(double cos_o, const Value& value) const {
    return mean_over_visible_normals<13, 40>(
        cos_o, a, [&](const Vec3d& m) { return value(split_at_microfacet(cos_o, m, eta)); });
  }
  // Of light that leaves at the cosine.
  [[nodiscard]] double left(double cos_o, double cosine) const {
    return 1 - masked_share(cos_o, cosine, a);
  }
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
  const Interface outside{double{eta_}, a};
  const auto transmitted = [&](double c) {
    return outside.mean(c, [&](const InterfaceSplit& split) {
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

  const Interface inside{1 / double{eta_}, a};
  const double critical = std::sqrt(1 - 1 / square(double{eta_}));
  row.internal_reflectance = static_cast<float>(cosine_mean(critical, [&](double c) {
    return absorbed(thickness, c) * inside.mean(c, [&](const InterfaceSplit& split) {
      if (split.cos_reflected <= 0) return 0.0;
      return split.reflectance * inside.left(c, split.cos_reflected) *
             absorbed(thickness, split.cos_reflected);
    });
  }));
  const auto interpolated = [&](double c) {
    const TablePlace at = table_place(static_cast<float>(std::sqrt(c)), intervals);
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
