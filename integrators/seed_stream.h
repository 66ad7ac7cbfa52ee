// Random numbers of what is rendered beside a picture, to learn how to render it or how wrong it
// is: others than the picture's own and than those of each other, for any pictures' seeds.
#pragma once

#include <cstdint>

#include "renderer/sampling/hash.h"

namespace candela {

// Their numbers are kept: another one gives other bits.
enum class SeedStream : std::uint64_t {
  LampPixels = 3,     // path/find_lamp_pixels.h
  GuideTraining = 4,  // guiding/training.h
  GuideTrial = 5,     // guiding/choose_guide.h
  Roulette = 6,       // roulette/choose_roulette.h
  CloserLook = 7,     // closer_look.h
  Reuse = 8           // reuse/choose_reuse.h
};

[[nodiscard]] constexpr std::uint64_t seed_of(SeedStream stream, std::uint64_t picture_seed) {
  return hash_combine(picture_seed, static_cast<std::uint64_t>(stream));
}

}  // namespace candela
