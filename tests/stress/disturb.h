// The same scene elsewhere, larger, or turned: what a picture must not depend on.
#pragma once

#include "renderer/description/scene_description.h"

namespace candela::test {

// Whether the numbers of the vertices change, or the instances' transforms.
enum class Where : std::uint8_t { Vertices, Instances };

// Lengths times `factor`, radiant intensities by its square: the same radiance everywhere.
[[nodiscard]] description::SceneDescription scaled(description::SceneDescription scene,
                                                   double factor, Where where = Where::Vertices);

[[nodiscard]] description::SceneDescription moved(description::SceneDescription scene,
                                                  const Vec3d& offset,
                                                  Where where = Where::Vertices);

// By an angle about an axis through the origin. Environments that are images are left as they are.
[[nodiscard]] description::SceneDescription rotated(description::SceneDescription scene,
                                                    double angle_radians, const Vec3d& axis);

// The longest side of the box of everything in it.
[[nodiscard]] double diameter_of(const description::SceneDescription& scene);

}  // namespace candela::test
