// Small environment maps, written as files into the tests' output folder.
#pragma once

#include <functional>
#include <string>

#include "renderer/description/scene_description.h"
#include "renderer/light/build_environment.h"

namespace candela::light_test {

// The value of texel (x, y), row 0 at the top.
using TexelFunction = std::function<Vec3f(int x, int y)>;

// A float EXR; also infinite and NaN values are written as they are.
[[nodiscard]] description::Image write_float_map(const std::string& name, int width, int height,
                                                 const TexelFunction& texel);
// An 8-bit PNG of values 0..255, to be decoded by lab3's gamma.
[[nodiscard]] description::Image write_byte_map(const std::string& name, int width, int height,
                                                const TexelFunction& texel);

// An environment with the store that it looks into.
struct MapEnvironment {
  TextureStore textures;
  Environment environment;
  Diagnostics diagnostics;

  [[nodiscard]] Rgb radiance(const Vec3f& d) const {
    return environment_radiance(environment, textures, d);
  }
  [[nodiscard]] double pdf(const Vec3f& d) const {
    return static_cast<double>(environment_pdf(environment, d));
  }
};

[[nodiscard]] MapEnvironment lat_long(const description::Image& image,
                                      const Mat3d& world_from_map = Mat3d(1.0),
                                      std::size_t max_cells = default_environment_cells);
[[nodiscard]] MapEnvironment equal_area(const description::Image& image,
                                        const Mat3d& world_from_map = Mat3d(1.0),
                                        std::size_t max_cells = default_environment_cells);
[[nodiscard]] MapEnvironment cube(const std::array<description::Image, 6>& faces,
                                  std::size_t max_cells = default_environment_cells);

}  // namespace candela::light_test
