// The samples of a pixel that sees nothing but a sky with an image (background_pixels.h): their
// camera rays' directions, and no ray.
#pragma once

#include "integrators/render_options.h"
#include "integrators/rounds.h"
#include "integrators/tile_counts.h"
#include "renderer/film/filter.h"
#include "renderer/sampling/sampler.h"
#include "renderer/scene/scene.h"

namespace candela {

// Adds to the film what paths would bring whose camera rays leave the scene, bit by bit. `pixel`
// gives the numbers of pixel x, y.
void add_sky_samples(const Scene& scene, const Filter& filter, const RenderOptions& options,
                     const PixelSampler& pixel, const SampleRange& range, int x, int y, Film& film,
                     TileCounts& counts);

}  // namespace candela
