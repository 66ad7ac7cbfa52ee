// Rays that accelerators must answer alike, ordinary and awkward ones.
#pragma once

#include <vector>

#include "renderer/geometry/sphere.h"
#include "renderer/math/ray.h"
#include "tests/scenes/soups.h"
#include "tests/stress/ray_random.h"

namespace candela::test {

// From points about the soup towards points within it; every other one ends before infinity.
[[nodiscard]] std::vector<Ray> random_rays(const Soup& soup, std::size_t count, std::uint32_t seed);

// Along an axis, the other components +0 or -0; every other one starts at a vertex's coordinates,
// in the planes of boxes.
[[nodiscard]] std::vector<Ray> axis_rays(const Soup& soup, std::size_t count, std::uint32_t seed);

// Within a triangle's own plane, as far as floats allow.
[[nodiscard]] std::vector<Ray> in_plane_rays(const Soup& soup, std::size_t count,
                                             std::uint32_t seed);

// Towards vertices and points of edges, from points about the soup.
[[nodiscard]] std::vector<Ray> edge_rays(const Soup& soup, std::size_t count, std::uint32_t seed);

// From points of triangles, in all directions.
[[nodiscard]] std::vector<Ray> surface_rays(const Soup& soup, std::size_t count,
                                            std::uint32_t seed);

// `count` rays of each.
[[nodiscard]] std::vector<Ray> rays_of_all_sets(const Soup& soup, std::size_t count);

// With radii from 10^-5 to 1.
[[nodiscard]] Sphere random_sphere(RayRandom& random);

// At spheres, from around and within them, and along their limbs to 10^-6.
[[nodiscard]] std::vector<Ray> sphere_rays(const std::vector<Sphere>& spheres, std::size_t count,
                                           std::uint32_t seed);

}  // namespace candela::test
