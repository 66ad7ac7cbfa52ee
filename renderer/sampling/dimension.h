// The named random dimensions. Every random number of a render is a function of
// (seed, pixel, sample, branch, bounce, dimension), where split paths and rays for lamps are
// branches of their sample: no generator is passed, stored or thread-local, so work that is skipped
// shifts no stream: one scene, one set of options and one seed give one image, bit by bit.
#pragma once

#include <cstdint>

namespace candela {

enum class Dimension : std::uint8_t {
  // once a camera sample (bounce 0)
  Filter,  // 2D: where in the pixel's filter
  Lens,    // 2D
  // once a bounce
  LightChoice,     // 1D: which light
  LightPoint,      // 2D: where on it
  LobeChoice,      // 1D: which lobe of the BSDF
  Direction,       // 2D: direction within the lobe
  Roulette,        // 1D
  MaterialChoice,  // 1D: which part of a mixture
  FreeFlight,      // 1D: where a medium scatters, and which channel decides
  // once a camera ray that looks for lamps alone (bounce 0)
  LampFilter,  // 2D
  LampLens,    // 2D
  // once a bounce, where paths are guided
  GuideChoice,  // 1D: whether the direction is the guide's or the BSDF's
};

}  // namespace candela
