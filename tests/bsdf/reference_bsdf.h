// The models once more, as plainly as their papers print them and in double: what the renderer's
// own forms, which are written for float, are held against. All colours by their green channel.
// (Not the compensated model, which is a table.)
#pragma once

#include <complex>

#include "renderer/bsdf/bsdf.h"
#include "renderer/math/vec.h"

namespace candela::tests {

// Fresnel's reflectance from the amplitudes with a complex index; `eta` of the far side over the
// near side.
[[nodiscard]] double exact_fresnel(double cos_theta, std::complex<double> eta);

// f |cos(theta_i)| of the lobes that are not delta lobes. Unit vectors, wo.z > 0.
[[nodiscard]] double reference_value(const Bsdf& bsdf, const Vec3d& wo, const Vec3d& wi);

// The share of the energy from wo that leaves, without radiance's 1 / eta^2; delta lobes, too. By
// midpoints over microfacet normals of the density D cos, `steps` squared of them: good to a few
// 1e-5 with 256, whatever the roughness and the angle.
[[nodiscard]] double reference_albedo(const Bsdf& bsdf, const Vec3d& wo, int steps = 256);

}  // namespace candela::tests
