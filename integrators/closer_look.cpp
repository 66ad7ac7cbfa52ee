#include "integrators/closer_look.h"

#include <algorithm>
#include <utility>

#include "renderer/base/parallel.h"
#include "renderer/film/variance.h"
#include "renderer/sampling/hash.h"

namespace candela {
namespace {

constexpr std::uint32_t replicates = 16;  // their spread tells how sure the level is

PixelRect pixel_at(const Film& film, std::size_t index) {
  const auto width = static_cast<std::size_t>(film.crop().width());
  const int x = film.crop().x0 + static_cast<int>(index % width);
  const int y = film.crop().y0 + static_cast<int>(index / width);
  return {x, y, x + 1, y + 1};
}

std::uint32_t whole_blocks(std::uint32_t samples) {
  return (samples + whole_block - 1) / whole_block * whole_block;
}

}  // namespace

CloserLook::CloserLook(const RenderOptions& options, TileFunction render_tile,
                       const CancelFlag* cancel)
    : options_(options), render_tile_(std::move(render_tile)), cancel_(cancel) {}

void CloserLook::correct(const Film& film, const TilePass& settings, PixelErrors& errors) {
  look_at(doubtful_pixels(film, errors, budget(film)), film, settings);
  for (const auto& [index, look] : films_)
    errors.errors[index] =
        error_at_level(film, index, {look.mean(0), variance_of_mean(look, 0)}, errors.epsilon);
}

// What is left of a share of the picture's own samples, or of what takes a moment.
std::uint64_t CloserLook::budget(const Film& film) const {
  constexpr double share = 1.0 / 32;
  constexpr double moment = 1 << 17;
  const double all = film.mean_samples() * static_cast<double>(film.pixel_count());
  const auto most = static_cast<std::uint64_t>(std::max(share * all, moment));
  return most - std::min(samples_, most);
}

// Samples of a pixel that was looked at before go on where those ended.
void CloserLook::look_at(const std::vector<DoubtfulPixel>& pixels, const Film& film,
                         const TilePass& settings) {
  std::vector<Film*> films;
  for (const DoubtfulPixel& pixel : pixels)
    films.push_back(&films_
                         .try_emplace(pixel.index, film.full_width(), film.full_height(),
                                      pixel_at(film, pixel.index), 0, replicates,
                                      film_balance(options_))
                         .first->second);
  parallel_for(pixels.size(), [&](std::size_t i) {
    if (cancel_ != nullptr && cancel_->load(std::memory_order_relaxed)) return;
    TilePass pass = settings;
    pass.tile = films[i]->crop();
    pass.range = {films[i]->samples(0), whole_blocks(pixels[i].samples)};
    pass.density = nullptr;
    pass.seed = mix_bits(options_.seed + 6);  // none that the picture or guiding uses
    if (pass.range.first < pass.range.end) render_tile_(pass, *films[i]);
  });
  samples_ = 0;
  for (const auto& [index, look] : films_) samples_ += look.samples(0);
}

}  // namespace candela
