// Where the scene's own centre and unit lie: what is rendered is moved there and scaled by a power
// of two, so that no place and no unit of a file costs accuracy.
#pragma once

#include "renderer/description/scene_description.h"
#include "renderer/scene/scene.h"

namespace candela {

// The centre of the scene's geometry and the power of two that brings its half extent into
// [0.5, 1). One far outlier does not spoil the rest: where the bounds are more than a hundred times
// the box that holds all but the outermost 2 % of the vertices on each axis (three at either end at
// the least), that box counts if a quarter of them lie near it. Nor does one far mesh or sphere as
// a whole, however many points it has at its end of an axis: one that is more than ten thousand
// times farther from all others than they are wide does not count. Multiplying the file's
// coordinates by a power of two gives the same normalised scene, bit by bit.
[[nodiscard]] Normalisation normalisation_of(const description::SceneDescription& description);

// The same of a mesh alone: the space of an object that instances share. Its unit is its own and
// not the scene's, so that a mesh in micrometres may be placed a million times enlarged.
[[nodiscard]] Normalisation normalisation_of(const description::Mesh& mesh);

// Radiant intensity has a squared length in it: irradiance at the same place must stay the same.
// Infinite where floats do not hold it.
[[nodiscard]] Rgb normalised_intensity(const Normalisation& n, const Vec3d& intensity);

}  // namespace candela
