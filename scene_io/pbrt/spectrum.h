// Parameters that are colours: rgb, xyz, blackbody, named and sampled spectra, .spd files.
// candela renders linear Rec.709, so a spectrum becomes the colour that it has
// (renderer/math/cie.h). Files that are read join the scene's.
#pragma once

#include <array>
#include <optional>

#include "renderer/description/scene_description.h"
#include "scene_io/pbrt/arguments.h"

namespace candela::pbrt {

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

// eta and k of a metal by name, e.g. for "metal-Au-eta" and "metal-Au-k" alike.
[[nodiscard]] std::optional<std::array<Vec3d, 2>> metal_named(std::string_view spectrum);

}  // namespace candela::pbrt
