#include "renderer/bsdf/layered_metal.h"

#include <array>
#include <cmath>
#include <optional>

#include "renderer/base/parallel.h"
#include "renderer/bsdf/coat_table.h"
#include "renderer/bsdf/table_microfacets.h"
#include "renderer/sampling/hash.h"
#include "renderer/sampling/sobol.h"

namespace candela {
namespace {

// Directions between the layers, by the root of their cosine: node i stands for (i / last)^2, and
// for what lies between it and its neighbours, by weights that fall off towards them.
constexpr std::size_t nodes = 96;
constexpr std::uint32_t samples = 2048;  // of a row: directions and microfacets
constexpr double part = 1.0 / samples;
constexpr int most_bounces = 1000;  // of light that perfect metals and total reflection keep

using Shares = std::array<double, nodes>;
using Colours = std::array<Vec3d, nodes>;

double cosine_at(double x) {
  return std::max(1e-3, square(x / (nodes - 1)));
}

// One of a node's directions, u in [0, 1). The outermost nodes stand for themselves.
double cosine_of(std::size_t node, double u) {
  const double aside = u < 0.5 ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 - 2 * u);
  const bool is_outermost = node == 0 || node == nodes - 1;
  return cosine_at(static_cast<double>(node) + (is_outermost ? 0 : aside));
}

// A share of light that goes on at a cosine, split between the nodes beside it.
template <class Share>
void add(double cosine, const Share& share, std::array<Share, nodes>& row) {
  const double x = std::sqrt(std::min(cosine, 1.0)) * (nodes - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(x), nodes - 2);
  row[i] += share * (static_cast<double>(i + 1) - x);
  row[i + 1] += share * (x - static_cast<double>(i));
}

// Calls meet(cosine, m) for directions, evenly spread over those of `cosine_of` u in [0, 1), and
// for microfacets that they see.
void for_each_meeting(const auto& cosine_of, double alpha, std::uint32_t dimension,
                      const auto& meet) {
  for (std::uint32_t i = 0; i < samples; ++i) {
    const double cosine = cosine_of(double{owen_sobol_2d(i, mix_bits(2 * dimension)).x});
    const Vec2f u = owen_sobol_2d(i, mix_bits(2 * dimension + 1));
    meet(cosine, visible_normal(cosine, alpha, double{u.x}, double{u.y}));
  }
}

// One way through the coat, or back from it. `eta`: of the far side over the near one.
struct CoatRow {
  double through = 0;
  Shares refracted{};  // to these cosines beyond
  Shares reflected{};

  CoatRow(const auto& cosine_of, double alpha, double eta, std::uint32_t dimension) {
    for_each_meeting(cosine_of, alpha, dimension, [&](double cosine, const Vec3d& m) {
      const InterfaceSplit split = split_at_microfacet(cosine, m, eta);
      const auto share = [&](double weight, double leaving) {
        return part * weight * (1 - masked_share(cosine, leaving, alpha));
      };
      if (split.cos_reflected > 0)
        add(split.cos_reflected, share(split.reflectance, split.cos_reflected), reflected);
      if (!(split.cos_transmitted > 0)) return;
      const double passed = share(1 - split.reflectance, split.cos_transmitted);
      through += passed;
      add(split.cos_transmitted, passed, refracted);
    });
  }
};

Colours metal_row(const Bsdf& bsdf, const auto& cosine_of, double alpha, std::uint32_t dimension) {
  Colours row{};
  for_each_meeting(cosine_of, alpha, dimension, [&](double cosine, const Vec3d& m) {
    const double up = cosine_of_reflected(cosine, m);
    if (!(up > 0)) return;
    const double cos_m = sine_of(cosine) * m.x + cosine * m.z;
    const auto c = static_cast<float>(std::min(1.0, cos_m));
    const double unmasked = 1 - masked_share(cosine, up, alpha);
    add(up, Vec3d(fresnel_conductor(c, bsdf.eta, bsdf.k)) * (part * unmasked), row);
  });
  return row;
}

// The layers' operators on light between them.
class Between {
 public:
  Between(const Bsdf& bsdf, const CoatedMetalLayers& layers)
      : bounces_(bsdf.metal_bounces > 0 ? bsdf.metal_bounces : most_bounces) {
    const double eta = double{bsdf.coat->eta()};
    std::array<std::optional<CoatRow>, nodes> coat;
    parallel_for(nodes, [&](std::size_t i) {
      const auto dimension = static_cast<std::uint32_t>(i);
      const auto cosine_here = [i](double u) { return cosine_of(i, u); };
      crossed_[i] = std::exp(-double{bsdf.coat->thickness()} / cosine_at(static_cast<double>(i)));
      coat[i].emplace(cosine_here, layers.coat_alpha, 1 / eta, dimension);
      metal_[i] = metal_row(bsdf, cosine_here, layers.metal_alpha, nodes + dimension);
    });
    for (std::size_t i = 0; i < nodes; ++i) {
      escape_[i] = coat[i]->through;
      back_[i] = coat[i]->reflected;
    }
  }

  // What comes out of light that goes down from the coat.
  [[nodiscard]] Vec3d out_of(const Shares& entering) const {
    Vec3d out(0.0);
    Colours down{};
    for (std::size_t i = 0; i < nodes; ++i) down[i] = Vec3d(entering[i]);
    double left = 1;
    for (int bounce = 0; bounce < bounces_ && left > 1e-5; ++bounce) {
      const Colours up = off_metal(down);
      for (std::size_t i = 0; i < nodes; ++i) out += up[i] * escape_[i];
      down = off_coat(up);
      left = 0;
      for (const Vec3d& share : down) left += max_component(share);
    }
    return out;
  }

 private:
  // Absorbed on the way down and up.
  [[nodiscard]] Colours off_metal(const Colours& down) const {
    Colours up{};
    for (std::size_t i = 0; i < nodes; ++i)
      for (std::size_t j = 0; j < nodes; ++j)
        up[j] += down[i] * metal_[i][j] * (crossed_[i] * crossed_[j]);
    return up;
  }

  [[nodiscard]] Colours off_coat(const Colours& up) const {
    Colours down{};
    for (std::size_t i = 0; i < nodes; ++i)
      for (std::size_t j = 0; j < nodes; ++j) down[j] += up[i] * back_[i][j];
    return down;
  }

  int bounces_;
  Shares crossed_{};                    // of light that crosses the coat
  Shares escape_{};                     // what leaves upwards
  std::array<Shares, nodes> back_{};    // what the coat turns down again, from row to column
  std::array<Colours, nodes> metal_{};  // what the metal turns up
};

}  // namespace

std::vector<Vec3d> albedos_from_below(const Bsdf& bsdf, const CoatedMetalLayers& layers,
                                      const std::vector<double>& cosines) {
  const Between between(bsdf, layers);
  std::vector<Vec3d> albedos(cosines.size());
  parallel_for(cosines.size(), [&](std::size_t i) {
    const CoatRow entry([&](double) { return cosines[i]; }, layers.coat_alpha,
                        double{bsdf.coat->eta()}, static_cast<std::uint32_t>(2 * nodes + i));
    albedos[i] = between.out_of(entry.refracted);
  });
  return albedos;
}

}  // namespace candela
