#include "renderer/light/build_environment.h"

#include <fmt/format.h>

#include "renderer/base/parallel.h"
#include "renderer/light/luminance_map.h"
#include "renderer/math/colour.h"

namespace candela {
namespace {

struct GridSize {
  std::uint32_t columns = 1;
  std::uint32_t rows = 1;
};

// As many cells as texels, or fewer of the same shape.
GridSize grid_size(std::uint32_t width, std::uint32_t height, std::size_t max_cells) {
  const double texels = static_cast<double>(width) * height;
  const double shrink = std::min(1.0, std::sqrt(static_cast<double>(max_cells) / texels));
  const auto shrunk = [&](std::uint32_t n) {
    return std::max(1u, static_cast<std::uint32_t>(n * shrink));
  };
  return {shrunk(width), shrunk(height)};
}

struct LoadedFace {
  TextureHandle texture;
  LuminanceMap luminance;  // filtered
};

LoadedFace load_face(description::Image image, description::Wrap wrap, TextureStore& textures,
                     Diagnostics& diagnostics) {
  image.wrap = wrap;
  const TextureHandle texture = textures.add(image, diagnostics);
  const LuminanceMap texels = decode_luminance(textures, texture);
  if (texels.invalid_count > 0)
    diagnostics.warning(
        image.span,
        fmt::format("'{}' has {} texels that are negative, infinite or not a number; they "
                    "count as 0 in the environment",
                    image.path, texels.invalid_count));
  return {texture, bilinear_means(texels, wrap == description::Wrap::Repeat)};
}

Vec2f half_texel(const LuminanceMap& map) {
  return {0.5f / static_cast<float>(map.width), 0.5f / static_cast<float>(map.height)};
}

// Weights are radiance times solid angle: they sum to the mean times 4 pi.
void set_distribution(Environment& environment, GridSize size, const std::vector<double>& weights) {
  double sum = 0;
  for (const double w : weights) sum += w;
  environment.distribution = GridDistribution(size.columns, size.rows, weights);
  environment.mean_luminance = sum / (4 * pi_double) * luminance(Vec3d(environment.scale));
}

// Of the cell's centre, near enough to the mean over the cell: (s, t) in [-1, 1]^2 on the face at
// distance 1 has the solid angle ds dt / r^3.
double cube_cell_solid_angle(std::uint32_t column, std::uint32_t row, GridSize face_size) {
  const double s = (2.0 * column + 1) / face_size.columns - 1;
  const double t = (2.0 * row + 1) / face_size.rows - 1;
  const double r2 = 1 + s * s + t * t;
  return 4.0 / (static_cast<double>(face_size.columns) * face_size.rows * r2 * std::sqrt(r2));
}

// The rows are those of `world_from_map`'s columns, made orthonormal.
std::array<Vec3f, 3> orthonormal_rows(const Mat3d& world_from_map) {
  const Vec3d x = normalize(world_from_map[0]);
  const Vec3d y = normalize(world_from_map[1] - x * dot(x, world_from_map[1]));
  const Vec3d z = cross(x, y) * (dot(cross(x, y), world_from_map[2]) < 0 ? -1.0 : 1.0);
  return {Vec3f(x), Vec3f(y), Vec3f(z)};
}

}  // namespace

Environment build_environment(const description::ConstantEnvironment& constant) {
  Environment environment;
  environment.is_seen_by_camera = constant.is_seen_by_camera;
  environment.scale = Rgb(constant.radiance);
  environment.mean_luminance = luminance(constant.radiance);
  return environment;
}

Environment build_environment(const description::CubeEnvironment& cube,
                              std::span<const description::Image> images, TextureStore& textures,
                              Diagnostics& diagnostics, std::size_t max_cells) {
  Environment environment;
  environment.mapping = EnvironmentMapping::Cube;
  environment.scale = Rgb(1);
  std::array<LuminanceMap, 6> faces;
  GridSize size;
  for (std::size_t i = 0; i < 6; ++i) {
    LoadedFace face =
        load_face(images[cube.faces[i].index], description::Wrap::Clamp, textures, diagnostics);
    environment.faces[i] = face.texture;
    environment.half_texel[i] = half_texel(face.luminance);
    faces[i] = std::move(face.luminance);
    const GridSize wanted = grid_size(faces[i].width, faces[i].height, max_cells / 6);
    size = {std::max(size.columns, wanted.columns), std::max(size.rows, wanted.rows)};
  }
  std::vector<double> weights(std::size_t{size.columns} * size.rows * 6);
  parallel_for(std::size_t{size.rows} * 6, [&](std::size_t grid_row) {
    const auto row = static_cast<std::uint32_t>(grid_row % size.rows);
    for (std::uint32_t column = 0; column < size.columns; ++column)
      weights[grid_row * size.columns + column] =
          cell_mean(faces[grid_row / size.rows], column, row, size.columns, size.rows) *
          cube_cell_solid_angle(column, row, size);
  });
  set_distribution(environment, {size.columns, size.rows * 6}, weights);
  return environment;
}

Environment build_environment(const description::LatLongEnvironment& map,
                              std::span<const description::Image> images, TextureStore& textures,
                              Diagnostics& diagnostics, std::size_t max_cells) {
  Environment environment;
  environment.mapping = EnvironmentMapping::LatLong;
  environment.is_seen_by_camera = map.is_seen_by_camera;
  environment.scale = Rgb(map.scale);
  environment.map_from_world = orthonormal_rows(map.world_from_map);
  const LoadedFace face =
      load_face(images[map.image.index], description::Wrap::Repeat, textures, diagnostics);
  environment.faces[0] = face.texture;
  environment.half_texel[0] = half_texel(face.luminance);
  const GridSize size = grid_size(face.luminance.width, face.luminance.height, max_cells);
  std::vector<double> weights(std::size_t{size.columns} * size.rows);
  parallel_for(size.rows, [&](std::size_t grid_row) {
    const auto row = static_cast<std::uint32_t>(grid_row);
    const double solid_angle = 4 * pi_double / size.columns *
                               std::sin(pi_double * (row + 0.5) / size.rows) *
                               std::sin(0.5 * pi_double / size.rows);
    for (std::uint32_t column = 0; column < size.columns; ++column)
      weights[grid_row * size.columns + column] =
          cell_mean(face.luminance, column, row, size.columns, size.rows) * solid_angle;
  });
  set_distribution(environment, size, weights);
  return environment;
}

}  // namespace candela
