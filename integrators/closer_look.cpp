#include "integrators/closer_look.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "integrators/seed_stream.h"
#include "renderer/base/parallel.h"
#include "renderer/film/variance.h"
#include "renderer/sampling/hash.h"

namespace candela {
namespace {

constexpr std::uint32_t part_samples = 256;
constexpr std::uint32_t part_replicates = 4;  // their spread tells how sure the level is

PixelRect rect_of_pixel(const Film& film, std::size_t index) {
  const auto width = static_cast<std::size_t>(film.crop().width());
  const int x = film.crop().x0 + static_cast<int>(index % width);
  const int y = film.crop().y0 + static_cast<int>(index / width);
  return {x, y, x + 1, y + 1};
}

// Samples that all looks at a picture may take: a share of its own; of small pictures, of which
// single pixels are more, some times as many as those, but no more than take a moment.
std::uint64_t budget_of(const Film& film) {
  constexpr double share = 1.0 / 32;
  constexpr double most_times = 4;
  constexpr double moment = 1 << 17;
  const double all = film.mean_samples() * static_cast<double>(film.pixel_count());
  return static_cast<std::uint64_t>(std::max(share * all, std::min(most_times * all, moment)));
}

}  // namespace

CloserLook::CloserLook(const RenderOptions& options, TileFunction render_tile,
                       std::function<bool()> is_over)
    : options_(options), render_tile_(std::move(render_tile)), is_over_(std::move(is_over)) {}

// Again where better known errors let others matter.
std::uint64_t CloserLook::correct(const Film& film, const TilePass& settings, PixelErrors& errors) {
  std::uint64_t invalid_samples = 0;
  replace(film, errors);
  while (!is_over_()) {
    const std::vector<Part> parts = parts_to_render(film, errors);
    if (parts.empty()) break;
    constexpr std::size_t at_once = 4096;  // what they tell is held in memory
    for (std::size_t first = 0; first < parts.size(); first += at_once)
      invalid_samples += look_at(
          film, settings, std::span(parts).subspan(first, std::min(at_once, parts.size() - first)));
    replace(film, errors);
  }
  return invalid_samples;
}

// Summed in the order of the parts.
std::uint64_t CloserLook::look_at(const Film& film, const TilePass& settings,
                                  std::span<const Part> parts) {
  std::vector<std::optional<Look>> looks(parts.size());
  parallel_for(parts.size(), [&](std::size_t i) {
    if (!is_over_()) looks[i] = render_part(film, settings, parts[i]);
  });
  std::uint64_t invalid_samples = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!looks[i]) continue;
    Seen& seen = seen_[parts[i].index];
    seen.means += looks[i]->mean;
    seen.variances += looks[i]->variance;
    ++seen.parts;
    samples_ += part_samples;
    invalid_samples += looks[i]->invalid_samples;
  }
  return invalid_samples;
}

void CloserLook::replace(const Film& film, PixelErrors& errors) const {
  for (const auto& [index, seen] : seen_) {
    const double parts = seen.parts;
    const PixelLevel level{seen.means / parts, seen.variances / (parts * parts)};
    errors.errors[index] = error_at_level(film, index, level, errors.epsilon);
  }
}

// What doubtful pixels still want, the worst first, as long as the budget has it, or enough to tell
// more of the pixel than its own samples and the neighbours do.
std::vector<CloserLook::Part> CloserLook::parts_to_render(const Film& film,
                                                          const PixelErrors& errors) const {
  constexpr std::uint64_t enough = 4;  // times the pixel's own samples
  const std::uint64_t budget = budget_of(film);
  std::uint64_t left = (budget - std::min(samples_, budget)) / part_samples;
  std::vector<Part> parts;
  for (const DoubtfulPixel& pixel : doubtful_pixels(film, errors)) {
    const auto seen = seen_.find(pixel.index);
    const std::uint32_t first = seen == seen_.end() ? 0 : seen->second.parts;
    const std::uint64_t wanted = (pixel.wanted + part_samples - 1) / part_samples;
    const std::uint64_t end = std::min(wanted, first + left);
    const bool tells = end == wanted || end * part_samples >= enough * film.samples(pixel.index);
    if (end <= first || !tells) continue;
    for (auto number = first; number < end; ++number)
      parts.push_back({pixel.index, static_cast<std::uint32_t>(number)});
    left -= end - first;
  }
  return parts;
}

// What its samples tell; not the film, which takes more memory than the rest together.
CloserLook::Look CloserLook::render_part(const Film& film, const TilePass& settings,
                                         const Part& part) const {
  TilePass pass = settings;
  pass.tile = rect_of_pixel(film, part.index);
  pass.range = {0, part_samples};
  pass.density = nullptr;
  pass.plan.reuses_paths = false;  // else its company would be rendered, too
  const std::uint64_t seed = seed_of(SeedStream::CloserLook, options_.seed);
  pass.seed = hash_counter(seed, part.number);
  Film own(film.full_width(), film.full_height(), pass.tile, 0, part_replicates,
           film_balance(options_));
  const TileCounts counts = render_tile_(pass, own);
  return {own.mean(0), variance_of_mean(own, 0), counts.invalid_samples};
}

}  // namespace candela
