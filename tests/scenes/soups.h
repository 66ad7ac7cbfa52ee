// Compiled Scenes straight from triangles, for tests of the accelerators: no compile() between, so
// that every awkward float arrives as it is.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "renderer/scene/scene.h"

namespace candela::test {

using Triangle = std::array<Vec3f, 3>;
using Soup = std::vector<Triangle>;

// Each triangle has three vertices of its own.
[[nodiscard]] Geometry geometry_of(const Soup& soup);

// All in the world, with one opaque diffuse material.
[[nodiscard]] Scene scene_of(std::vector<Geometry> geometries);
[[nodiscard]] Scene scene_of(const Soup& soup);

// A material of constant opacity, and one more geometry that has it.
void add_cutout(Scene& scene, const Soup& soup, float opacity);

// An object of the soup (one geometry), placed by every one of the instances, whose `object` is
// set.
void add_instances(Scene& scene, const Soup& soup, std::vector<Instance> instances);

// Opaque triangles, cut-outs, and two instances of cut-outs, all across each other.
[[nodiscard]] Scene scene_of_all_kinds();

// A placement with the normals' columns filled in.
[[nodiscard]] Instance placement(const Vec3f& x, const Vec3f& y, const Vec3f& z,
                                 const Vec3f& translation);

// Uniform in [0, 1), the same on every platform.
[[nodiscard]] float uniform(std::mt19937& random);
[[nodiscard]] Vec3f uniform_in_cube(std::mt19937& random);  // [-1, 1]^3

// Triangles about uniform points of [-1, 1]^3 with corners up to `size` away on each axis.
[[nodiscard]] Soup random_soup(std::size_t count, float size, std::uint32_t seed);
// Two corners nearly on a line with the third; some exactly, some with two equal corners.
[[nodiscard]] Soup sliver_soup(std::size_t count, std::uint32_t seed);
// Every triangle of a random soup two to four times, some with corners rotated or wound backwards.
[[nodiscard]] Soup duplicate_soup(std::size_t count, std::uint32_t seed);
// Overlapping triangles in a few common planes, axis-aligned and tilted.
[[nodiscard]] Soup coplanar_soup(std::size_t count, std::uint32_t seed);
// Sizes over nine orders of magnitude, small ones far from the origin too.
[[nodiscard]] Soup mixed_scale_soup(std::size_t count, std::uint32_t seed);
// A closed bumpy surface about the origin, each triangle sharing its edges with its neighbours.
[[nodiscard]] Soup closed_surface(int subdivisions, float bumps, std::uint32_t seed);

[[nodiscard]] Soup scaled(Soup soup, float factor);

}  // namespace candela::test
