#include "integrators/guiding/fit_cell.h"

#include <array>
#include <vector>

#include "integrators/guiding/fit_targets.h"

namespace candela {
namespace {

// Beyond the last, what the mixture misses would be too noisy.
constexpr std::array<float, 4> shares{0, 0.25f, 0.5f, 0.75f};
using Moments = std::array<double, shares.size()>;  // with each share

// `record`: of the others. The squares of what it would have brought, as often as it would have
// come, with each share; in units of what its path brings to the picture.
void add_moments(const TargetMixture& mixture, const TrainingRecord& record, Moments& moments) {
  const float guide_pdf =
      TargetsSeen(mixture, record.position).pdf(normalize(record.target - record.position));
  const double brought = double{record.weight} * record.throughput;
  for (std::size_t i = 0; i < shares.size(); ++i)
    moments[i] += brought * brought * record.pdf /
                  (record.bsdf_pdf + shares[i] * (guide_pdf - record.bsdf_pdf));
}

float best_share(std::span<const TrainingRecord> records) {
  constexpr double least_gain = 1.05;
  std::array<std::vector<TrainingRecord>, 2> halves;
  for (std::size_t i = 0; i < records.size(); ++i) halves[i % 2].push_back(records[i]);
  if (halves[1].empty()) return 0;
  Moments moments{};
  for (std::size_t half = 0; half < 2; ++half) {
    const TargetMixture mixture = fit_targets(halves[half]);
    for (const TrainingRecord& record : halves[1 - half]) add_moments(mixture, record, moments);
  }
  float best = 0;
  double least = moments[0] / least_gain;
  for (std::size_t i = 1; i < shares.size(); ++i) {
    if (!(moments[i] < least)) continue;
    least = moments[i];
    best = shares[i];
  }
  return best;
}

}  // namespace

TargetMixture fit_cell(std::span<const TrainingRecord> records) {
  const float share = best_share(records);
  TargetMixture mixture = fit_targets(records);
  mixture.share = share;
  return mixture;
}

}  // namespace candela
