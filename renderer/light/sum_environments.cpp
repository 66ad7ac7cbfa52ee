#include "renderer/light/sum_environments.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "renderer/base/parallel.h"
#include "renderer/light/build_environment.h"
#include "renderer/texture/texels.h"

namespace candela {
namespace {

constexpr double least_side = 64;
constexpr double largest_side = 4096;

bool have_same_grid(const Environment& a, const Environment& b, const TextureStore& textures) {
  const TextureInfo& size_a = textures.info(a.faces[0]);
  const TextureInfo& size_b = textures.info(b.faces[0]);
  return a.mapping == b.mapping && a.map_from_world == b.map_from_world &&
         size_a.width == size_b.width && size_a.height == size_b.height;
}

// Whether lookups are linear between texels. A cube's texels lie on six images.
bool is_linear(const Environment& map, const TextureStore& textures) {
  return map.mapping != EnvironmentMapping::Cube &&
         textures.encoding(map.faces[0]) != Encoding::LabGamma;
}

double texel_count(const Environment& map, const TextureStore& textures) {
  double count = 0;
  for (const TextureHandle face : map.faces) {
    if (!face) continue;
    const TextureInfo& info = textures.info(face);
    count += static_cast<double>(info.width) * info.height;
  }
  return count;
}

// Rows of `radiance(x, y)`; infinite sums count as the largest number.
template <class Radiance>
TexelArray texels_of(int width, int height, const Radiance& radiance) {
  const ImageHeader header{width, height, SampleType::Float, {"R", "G", "B"}};
  TexelArray texels{allocate_samples(header), width, height, 3, header.sample_type};
  parallel_for(static_cast<std::size_t>(height), [&](std::size_t row) {
    for (int x = 0; x < width; ++x) {
      const Vec3d most(std::numeric_limits<float>::max());
      const Rgb sum(glm::min(radiance(x, static_cast<int>(row)), most));
      const std::size_t i = row * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      std::memcpy(texels.samples.get() + i * sizeof(Rgb), &sum, sizeof(Rgb));
    }
  });
  return texels;
}

TexelArray sum_of_texels(const Vec3d& constant, std::span<const Environment> maps,
                         const TextureStore& textures) {
  const TextureInfo& size = textures.info(maps[0].faces[0]);
  return texels_of(size.width, size.height, [&](int x, int y) {
    Vec3d sum = constant;
    for (const Environment& map : maps)
      sum += Vec3d(map.scale) * Vec3d(valid_radiance(textures.texel(map.faces[0], x, y)));
    return sum;
  });
}

// The mean of all maps over each texel of a map of equal areas that lies as `frame` does, by
// `grid` x `grid` directions. A quarter of a texel apart they keep the light of a sun of one texel
// within 2 %, half a texel apart within 5 %.
TexelArray resampled_sum(const Vec3d& constant, std::span<const Environment> maps,
                         const Environment& frame, int side, int grid,
                         const TextureStore& textures) {
  return texels_of(side, side, [&](int x, int y) {
    Vec3d sum(0.0);
    for (int j = 0; j < grid; ++j)
      for (int i = 0; i < grid; ++i) {
        const Vec2d place((x + (i + 0.5) / grid) / side, (y + (j + 0.5) / grid) / side);
        const Vec3f direction =
            environment_detail::to_world(frame, square_to_equal_area_sphere(Vec2f(place)));
        for (const Environment& map : maps)
          sum += Vec3d(environment_radiance(map, textures, direction));
      }
    return constant + sum / static_cast<double>(grid * grid);
  });
}

constexpr const char* sum_name = "the sum of the scene's skies";

Environment exact_sum(const Vec3d& constant, std::span<const Environment> maps,
                      TextureStore& textures) {
  const bool is_lat_long = maps[0].mapping == EnvironmentMapping::LatLong;
  const TextureHandle sum = textures.add(sum_name, sum_of_texels(constant, maps, textures),
                                         is_lat_long ? Wrap::Repeat : Wrap::Clamp);
  return build_environment(maps[0].mapping, sum, maps[0].map_from_world, textures);
}

EnvironmentSum resampled(const Vec3d& constant, std::span<const Environment> maps,
                         TextureStore& textures) {
  const auto finest =
      std::max_element(maps.begin(), maps.end(), [&](const Environment& a, const Environment& b) {
        return texel_count(a, textures) < texel_count(b, textures);
      });
  const double finest_side = std::sqrt(texel_count(*finest, textures));
  const int side =
      static_cast<int>(std::ceil(std::clamp(2 * finest_side, least_side, largest_side)));
  const int grid = static_cast<int>(std::clamp(std::ceil(2 * finest_side / side), 2.0, 8.0));
  const TextureHandle sum = textures.add(
      sum_name, resampled_sum(constant, maps, *finest, side, grid, textures), Wrap::Clamp);
  return {build_environment(EnvironmentMapping::EqualArea, sum, finest->map_from_world, textures),
          side};
}

}  // namespace

EnvironmentSum sum_environments(const Vec3d& constant, std::span<const Environment> maps,
                                TextureStore& textures) {
  const bool is_exact = std::all_of(maps.begin(), maps.end(), [&](const Environment& map) {
    return is_linear(map, textures) && have_same_grid(map, maps[0], textures);
  });
  EnvironmentSum sum = is_exact ? EnvironmentSum{exact_sum(constant, maps, textures), 0}
                                : resampled(constant, maps, textures);
  sum.environment.is_seen_by_camera = maps[0].is_seen_by_camera;
  return sum;
}

}  // namespace candela
