#include "integrators/guiding/training.h"

#include <algorithm>
#include <numeric>

#include "integrators/guiding/training_log.h"
#include "integrators/seed_stream.h"
#include "integrators/trial.h"
#include "renderer/base/parallel.h"

namespace candela {
namespace {

using Records = std::vector<TrainingRecord>;

// As many as are of use, evenly: in bright scenes nearly all paths bring light.
Records thinned(const std::vector<Records>& groups) {
  constexpr std::size_t most = 1 << 17;
  std::size_t count = 0;
  for (const Records& group : groups) count += group.size();
  const std::size_t step = (count + most - 1) / most;
  Records kept;
  std::size_t i = 0;
  for (const Records& group : groups)
    for (const TrainingRecord& record : group)
      if (i++ % step == 0) kept.push_back(record);
  return kept;
}

// Of block `index`: a pixel and random numbers of its own.
Records records_of_block(const RenderOptions& options, const TileFunction& render_tile,
                         TilePass pass, std::uint32_t index) {
  TrainingLog log;
  pass.observer = &log;
  run_block(pass, {pass.seed, index, index}, options, render_tile);
  return std::move(log.records());
}

}  // namespace

Training::Training(const RenderOptions& options, const TileFunction& render_tile,
                   const std::function<bool()>& is_over)
    : options_(options), render_tile_(render_tile), is_over_(is_over) {
  settings_.seed = seed_of(SeedStream::GuideTraining, options.seed);
  settings_.plan.roulette_threshold = options.plan.roulette_threshold;
}

std::uint64_t Training::samples() const {
  return std::uint64_t{blocks_} * whole_block;
}

void Training::run_until(std::uint64_t samples) {
  const auto end = static_cast<std::uint32_t>(samples / whole_block);
  if (blocks_ == 0) iterate(end / 4);
  while (blocks_ > 0 && 2 * blocks_ <= end && !is_over_()) iterate(blocks_);
}

void Training::iterate(std::uint32_t blocks) {
  constexpr std::uint32_t blocks_at_once = 32;
  settings_.guide = field_.cells() > 0 ? &field_ : nullptr;
  std::vector<Records> groups((blocks + blocks_at_once - 1) / blocks_at_once);
  std::vector<std::uint32_t> done(groups.size());  // blocks: the time may be over
  parallel_for(groups.size(), [&](std::size_t group) {
    const std::uint32_t first = static_cast<std::uint32_t>(group) * blocks_at_once;
    for (std::uint32_t i = first; i < std::min(first + blocks_at_once, blocks); ++i) {
      if (is_over_()) return;
      const Records found = records_of_block(options_, render_tile_, settings_, blocks_ + i);
      groups[group].insert(groups[group].end(), found.begin(), found.end());
      ++done[group];
    }
  });
  field_ = GuidingField(thinned(groups));
  blocks_ = std::accumulate(done.begin(), done.end(), blocks_);
}

}  // namespace candela
