// Colour of spectra: CIE 1931 (2 degrees) -> linear Rec.709.
#pragma once

#include <functional>
#include <vector>

#include "renderer/math/vec.h"

namespace candela {

// A spectrum of samples by rising wavelength (nanometres), linear between and 0 beyond them.
struct SampledSpectrum {
  std::vector<double> wavelengths;
  std::vector<double> values;

  [[nodiscard]] double operator()(double wavelength) const;
};

using SpectrumFunction = std::function<double(double wavelength)>;

// Planck's law, relative.
[[nodiscard]] double black_body(double wavelength, double kelvin);

// The colour of light with this spectrum, scaled to luminance 1, as pbrt scales the spectra of its
// lights; components outside Rec.709 are cut at 0. Black where it has no luminance.
[[nodiscard]] Vec3d colour_of_light(const SpectrumFunction& spectrum);
// The same by chromaticity.
[[nodiscard]] Vec3d colour_of_chromaticity(double x, double y);
// The colour of white light (D65) after a factor with this spectrum, at least 0: 1 gives (1, 1, 1).
[[nodiscard]] Vec3d colour_of_factor(const SpectrumFunction& spectrum);
// Mean over wavelengths by luminance.
[[nodiscard]] double luminous_mean(const SpectrumFunction& spectrum);

// Of light with this spectrum, in relative units.
[[nodiscard]] Vec3d xyz_of_light(const SpectrumFunction& spectrum);
[[nodiscard]] Vec3d xyz_to_rgb(const Vec3d& xyz);

}  // namespace candela
