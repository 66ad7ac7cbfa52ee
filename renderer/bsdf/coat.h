// What coated surfaces share: the dielectric layer on top, smooth or GGX-rough.
#pragma once

#include "renderer/bsdf/bsdf.h"
#include "renderer/bsdf/coat_table.h"
#include "renderer/bsdf/fresnel.h"

namespace candela {

// Whether the coat mirrors: a delta lobe beside what is below.
[[nodiscard]] inline bool has_smooth_coat(const Bsdf& bsdf) {
  return bsdf.alpha == 0;
}

// What crosses it hardly knows directions: one width for both.
[[nodiscard]] inline float mean_coat_width(const Bsdf& bsdf) {
  return std::sqrt(bsdf.alpha * bsdf.alpha_across);
}

// Of its outer interface.
[[nodiscard]] inline float coat_reflectance(const Bsdf& bsdf, float cosine) {
  return fresnel_dielectric(cosine, bsdf.coat->eta()).reflectance;
}

// What is left after so many bounces of light that comes again by `again` each time; 0: nothing,
// since all of them count.
[[nodiscard]] inline Rgb left_after(int bounces, const Rgb& again) {
  if (bounces == 0) return Rgb{0};
  Rgb left = again;
  for (int i = 1; i < bounces; ++i) left *= again;
  return left;
}

}  // namespace candela
