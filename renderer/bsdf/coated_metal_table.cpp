#include "renderer/bsdf/coated_metal_table.h"

#include <cmath>
#include <vector>

#include "renderer/base/parallel.h"
#include "renderer/bsdf/coated_conductor.h"
#include "renderer/sampling/hash.h"
#include "renderer/sampling/sobol.h"

namespace candela {
namespace {

// One direction of the lobe: what it brings before it is scaled, and where to.
struct Brought {
  Vec3d value;
  float cosine;
};

constexpr std::uint32_t directions = 1024;

std::vector<Brought> lobe_from(const Bsdf& bsdf, float cos_o) {
  std::vector<Brought> all;
  const Vec3f wo{std::sqrt((1 - cos_o) * (1 + cos_o)), 0, cos_o};
  for (std::uint32_t i = 0; i < directions; ++i) {
    const Vec3f wi = sample_coated_metal(bsdf, wo, owen_sobol_2d(i, mix_bits(999)));
    if (!(wi.z > 0)) continue;
    const BsdfEvaluation e = evaluate_coated_metal(bsdf, wo, wi);
    if (e.pdf > 0) all.push_back({Vec3d(e.value / e.pdf) / double{directions}, wi.z});
  }
  return all;
}

}  // namespace

CoatedMetalTable::CoatedMetalTable(const Bsdf& bsdf, const CoatedMetalLayers& layers) {
  std::vector<double> cosines;
  for (std::size_t i = 0; i <= intervals; ++i)
    cosines.push_back(std::max(1e-6, square(static_cast<double>(i) / intervals)));
  const std::vector<Vec3d> wanted = albedos_from_below(bsdf, layers, cosines);
  std::array<std::vector<Brought>, intervals + 1> lobes;
  parallel_for(intervals + 1, [&](std::size_t i) {
    lobes[i] = lobe_from(bsdf, static_cast<float>(cosines[i]));
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
