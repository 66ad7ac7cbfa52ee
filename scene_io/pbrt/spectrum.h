// Parameters that are colours: rgb, xyz, blackbody, named and sampled spectra, .spd files.
// candela renders linear Rec.709, so a spectrum becomes the colour that it has
// (renderer/math/cie.h). Files that are read join the scene's.
#pragma once

#include <array>
#include <optional>

#include "renderer/description/scene_description.h"
#include "scene_io/pbrt/arguments.h"

namespace candela::pbrt {

// Whether it is the name of a spectrum that candela knows, of whatever kind.
[[nodiscard]] bool names_a_spectrum(const Parameter& parameter);

// For light: rgb as it is; all other spectra scaled to luminance 1, as pbrt does
// (docs/pbrt.md, Lights). Nothing where it is absent or, after an error, no colour.
[[nodiscard]] std::optional<Vec3d> light_colour(Arguments& arguments, std::string_view name,
                                                description::SceneDescription& scene);

// For a reflectance, a transmittance or an index of refraction: the colour of white light after it.
[[nodiscard]] std::optional<Vec3d> factor_colour(const Parameter& parameter,
                                                 description::SceneDescription& scene,
                                                 const Report& report);

// For the index of a dielectric: one number, so without dispersion.
[[nodiscard]] std::optional<double> mean_value(const Parameter& parameter,
                                               description::SceneDescription& scene,
                                               const Report& report);

// eta and k of a metal whose spectra are given, a channel each: eta as factor_colour() has it, and
// k so that white light that falls straight on it has the colour that it has by the reflectance of
// each wavelength, of each channel at most largest_metal_reflectance, if eta alone reflects no
// more. Nothing where one of them is no list of samples, and after an error.
[[nodiscard]] std::optional<std::array<Vec3d, 2>> metal_of_spectra(
    const Parameter& eta, const Parameter& k, description::SceneDescription& scene,
    const Report& report);

// eta and k of a metal by name, e.g. for "metal-Au-eta" and "metal-Au-k" alike.
[[nodiscard]] std::optional<std::array<Vec3d, 2>> metal_named(std::string_view spectrum);

}  // namespace candela::pbrt
