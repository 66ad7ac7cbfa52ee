#include "renderer/light/build_environment.h"

#include <fmt/format.h>

#include "renderer/base/parallel.h"
#include "renderer/light/cell_weights.h"
#include "renderer/light/luminance_rows.h"
#include "renderer/light/sky_cells.h"
#include "renderer/math/colour.h"

namespace candela {
namespace {

// One image of a map.
struct Face {
  TextureHandle texture;
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  bool columns_wrap = false;

  [[nodiscard]] Vec2f half_texel() const {
    return {0.5f / static_cast<float>(width), 0.5f / static_cast<float>(height)};
  }
};

Face face_of(TextureHandle texture, const TextureStore& textures) {
  const TextureInfo& info = textures.info(texture);
  return {texture, static_cast<std::uint32_t>(info.width), static_cast<std::uint32_t>(info.height),
          false};
}

Face add_face(description::Image image, description::Wrap wrap, TextureStore& textures,
              Diagnostics& diagnostics) {
  image.wrap = wrap;
  Face face = face_of(textures.add_light(image, diagnostics), textures);
  face.columns_wrap = wrap == description::Wrap::Repeat;
  return face;
}

// As many cells as texels, or fewer of about the same shape: the table takes no more memory than
// the map. Where they are fewer anyway, so many that merging them can go on for long.
GridSize grid_size(const Face& face, const TextureStore& textures, std::size_t max_cells) {
  constexpr std::size_t cell_bytes = 6;  // of a GridDistribution, at most
  const std::size_t affordable = textures.info(face.texture).bytes / cell_bytes;
  const double cells = static_cast<double>(std::min(max_cells, affordable));
  const double texels = static_cast<double>(face.width) * face.height;
  const double shrink = std::min(1.0, std::sqrt(cells / texels));
  const auto shrunk = [&](std::uint32_t n) {
    constexpr std::uint32_t often_even = 32;
    const auto m = std::max(1u, static_cast<std::uint32_t>(n * shrink));
    return m < n && m >= 8 * often_even ? m - m % often_even : m;
  };
  return {shrunk(face.width), shrunk(face.height)};
}

// Sets the face's rows of the cells, `size.rows` from `first_row` on, to luminance times
// `solid_angle(column, row)`; they sum to the mean luminance times 4 pi. Decodes the texture.
template <class SolidAngle>
void set_rows(const TextureStore& textures, const Face& face, GridSize size,
              std::uint32_t first_row, SolidAngle&& solid_angle, CellWeights& cells) {
  constexpr std::uint32_t block_rows = 32;
  parallel_for((size.rows + block_rows - 1) / block_rows, [&](std::size_t block) {
    const auto begin = static_cast<std::uint32_t>(block) * block_rows;
    const RowRange own{begin, std::min(begin + block_rows, size.rows)};
    const LuminanceRows map = filtered_luminance(
        textures, face.texture, touched_rows(own, size.rows, face.height), face.columns_wrap);
    for (std::uint32_t row = own.begin; row < own.end; ++row) {
      const RowRange texels = touched_rows({row, row + 1}, size.rows, face.height);
      for (std::uint32_t column = 0; column < size.columns; ++column)
        cells.at(column, first_row + row) =
            cell_mean(map, texels, column, size.columns) * solid_angle(column, row);
    }
  });
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

// Cubes' cells have the six faces' rows one below the other.
double cell_solid_angle(EnvironmentMapping mapping, std::uint32_t column, std::uint32_t row,
                        GridSize size) {
  if (mapping == EnvironmentMapping::Cube) {
    const GridSize face{size.columns, size.rows / 6};
    return cube_cell_solid_angle(column, row % face.rows, face);
  }
  if (mapping == EnvironmentMapping::EqualArea)
    return 4 * pi_double / (static_cast<double>(size.columns) * size.rows);
  return 4 * pi_double / size.columns * std::sin(pi_double * (row + 0.5) / size.rows) *
         std::sin(0.5 * pi_double / size.rows);
}

std::uint32_t index_of(float place, std::uint32_t count) {
  return std::min(static_cast<std::uint32_t>(place * static_cast<float>(count)), count - 1);
}

// The cell of the map, by its place among them all, that a direction in the map's axes lies in.
std::size_t cell_at(EnvironmentMapping mapping, GridSize size, const Vec3f& direction) {
  const auto& [columns, rows] = size;
  if (mapping == EnvironmentMapping::Cube) {
    const CubePoint point = cube_point(direction);
    const std::uint32_t row = point.face * (rows / 6) + index_of(point.st.y, rows / 6);
    return std::size_t{row} * columns + index_of(point.st.x, columns);
  }
  const Vec2f st = mapping == EnvironmentMapping::EqualArea ? equal_area_sphere_to_square(direction)
                                                            : lat_long_point(direction);
  return std::size_t{index_of(st.y, rows)} * columns + index_of(st.x, columns);
}

// The middle of a cell, in the map's axes; unit.
Vec3f direction_of(EnvironmentMapping mapping, GridSize size, std::uint32_t column,
                   std::uint32_t row) {
  const auto middle = [](std::uint32_t i, std::uint32_t count) {
    return (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
  };
  const float s = middle(column, size.columns);
  if (mapping == EnvironmentMapping::Cube) {
    const std::uint32_t rows = size.rows / 6;
    return normalize(cube_direction({row / rows, {s, middle(row % rows, rows)}}));
  }
  const Vec2f st(s, middle(row, size.rows));
  return mapping == EnvironmentMapping::EqualArea ? square_to_equal_area_sphere(st)
                                                  : lat_long_direction(st);
}

SkyPatches patches_of(EnvironmentMapping mapping, GridSize cells) {
  const auto& [columns, rows] = cells;
  const std::size_t count = std::size_t{columns} * rows;
  if (mapping == EnvironmentMapping::LatLong) return {count, columns, rows};
  const std::uint32_t faces = mapping == EnvironmentMapping::Cube ? 6 : 1;
  const std::uint32_t longest = std::max(columns, rows / faces);
  return faces == 6 ? SkyPatches{count, 4 * longest, 2 * longest}
                    : SkyPatches{count, 2 * longest, longest};
}

template <class Visit>
void for_each_cell(GridSize size, const Visit& visit) {
  for (std::uint32_t row = 0; row < size.rows; ++row)
    for (std::uint32_t column = 0; column < size.columns; ++column) visit(column, row);
}

// Each of the cell's `parts` with the cell's luminance.
void add_parts(EnvironmentMapping mapping, GridSize size, std::uint32_t column, std::uint32_t row,
               double luminance, GridSize parts, const AddSkyLight& add) {
  const GridSize fine{size.columns * parts.columns, size.rows * parts.rows};
  for (std::uint32_t x = column * parts.columns; x < (column + 1) * parts.columns; ++x)
    for (std::uint32_t y = row * parts.rows; y < (row + 1) * parts.rows; ++y)
      add({environment_detail::to_polar(mapping, direction_of(mapping, fine, x, y)),
           luminance * cell_solid_angle(mapping, x, y, fine)});
}

// `cells`: the light of cells of the map, which has `faces` of the same number of rows each.
void set_distribution(Environment& environment, CellWeights cells, std::uint32_t faces) {
  const EnvironmentMapping mapping = environment.mapping;
  const GridSize size = cells.size;
  const double all_light = total_weight(cells);
  environment.mean_luminance = all_light / (4 * pi_double) * luminance(Vec3d(environment.scale));
  const std::uint32_t merged = merged_cells(cells, faces);
  for_each_cell(size, [&](std::uint32_t column, std::uint32_t row) {
    cells.at(column, row) /= cell_solid_angle(mapping, column, row, size);
  });
  const auto luminance_at = [&](const Vec3f& polar) {
    return cells.values[cell_at(mapping, size, environment_detail::from_polar(mapping, polar))];
  };
  const SkyPatches patches = patches_of(mapping, size);
  const GridSize sky = sky_size(patches, merged);
  // Of cells with at least so much light, each in so many parts along its sides.
  const auto light_of = [&](double least, std::uint32_t least_parts) {
    // A patch may be a ring: two parts at least for each of the sky's cells along it.
    const GridSize parts{std::max(least_parts, 2 * sky.columns / patches.around),
                         std::max(least_parts, 2 * sky.rows / patches.down)};
    return [&, least, parts](const AddSkyLight& add) {
      for_each_cell(size, [&](std::uint32_t column, std::uint32_t row) {
        const double luminance = cells.at(column, row);
        const double flux = luminance * cell_solid_angle(mapping, column, row, size);
        if (flux > 0 && flux >= least) add_parts(mapping, size, column, row, luminance, parts, add);
      });
    };
  };
  constexpr double lamps_share = 0x1p-12;  // of all light: of no more than 4,096 cells
  environment.distribution = SkyDistribution(distribution_of(sky_cells(
      patches, merged, {luminance_at, light_of(lamps_share * all_light, 8), light_of(0, 1)})));
  if (environment.distribution.cells().is_empty()) environment.mean_luminance = 0;  // too dark
}

// Sets what follows from the one image of an environment that has its mapping and scale.
void set_map(Environment& environment, const Face& face, const TextureStore& textures,
             std::size_t max_cells) {
  environment.faces[0] = face.texture;
  environment.half_texel[0] = face.half_texel();
  const GridSize size = grid_size(face, textures, max_cells);
  const auto solid_angle = [&](std::uint32_t column, std::uint32_t row) {
    return cell_solid_angle(environment.mapping, column, row, size);
  };
  CellWeights cells(size);
  set_rows(textures, face, size, 0, solid_angle, cells);
  set_distribution(environment, std::move(cells), 1);
}

// Of one image.
template <class Map>
Environment build_map(const Map& map, EnvironmentMapping mapping, description::Wrap wrap,
                      std::span<const description::Image> images, TextureStore& textures,
                      Diagnostics& diagnostics, std::size_t max_cells) {
  Environment environment;
  environment.mapping = mapping;
  environment.is_seen_by_camera = map.is_seen_by_camera;
  environment.scale = Rgb(map.scale);
  environment.map_from_world = orthonormal_rows(map.world_from_map);
  const description::Image& image = images[map.image.index];
  const Face face = add_face(image, wrap, textures, diagnostics);
  if (mapping == EnvironmentMapping::EqualArea)
    warn_unless_square(textures, face.texture, image.span, diagnostics);
  set_map(environment, face, textures, max_cells);
  return environment;
}

}  // namespace

void warn_unless_square(const TextureStore& textures, TextureHandle map, const SourceSpan& span,
                        Diagnostics& diagnostics) {
  const TextureInfo& info = textures.info(map);
  if (info.width == info.height) return;
  diagnostics.warning(span, fmt::format("'{}' is {} x {}: maps of equal areas are square, those "
                                        "twice as wide as high hold latitudes and longitudes",
                                        textures.path(map), info.width, info.height));
}

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
  std::array<Face, 6> faces;
  GridSize size;
  for (std::size_t i = 0; i < 6; ++i) {
    faces[i] =
        add_face(images[cube.faces[i].index], description::Wrap::Clamp, textures, diagnostics);
    environment.faces[i] = faces[i].texture;
    environment.half_texel[i] = faces[i].half_texel();
    const GridSize wanted = grid_size(faces[i], textures, max_cells / 6);
    size = {std::max(size.columns, wanted.columns), std::max(size.rows, wanted.rows)};
  }
  parallel_for(6, [&](std::size_t i) { (void)textures.texel(faces[i].texture, 0, 0); });  // decodes
  const auto solid_angle = [&](std::uint32_t column, std::uint32_t row) {
    return cube_cell_solid_angle(column, row, size);
  };
  CellWeights cells({size.columns, size.rows * 6});
  for (std::uint32_t i = 0; i < 6; ++i)
    set_rows(textures, faces[i], size, i * size.rows, solid_angle, cells);
  set_distribution(environment, std::move(cells), 6);
  return environment;
}

Environment build_environment(const description::LatLongEnvironment& map,
                              std::span<const description::Image> images, TextureStore& textures,
                              Diagnostics& diagnostics, std::size_t max_cells) {
  return build_map(map, EnvironmentMapping::LatLong, description::Wrap::Repeat, images, textures,
                   diagnostics, max_cells);
}

Environment build_environment(const description::EqualAreaEnvironment& map,
                              std::span<const description::Image> images, TextureStore& textures,
                              Diagnostics& diagnostics, std::size_t max_cells) {
  return build_map(map, EnvironmentMapping::EqualArea, description::Wrap::Clamp, images, textures,
                   diagnostics, max_cells);
}

Environment build_environment(EnvironmentMapping mapping, TextureHandle map,
                              const std::array<Vec3f, 3>& map_from_world,
                              const TextureStore& textures, std::size_t max_cells) {
  Environment environment;
  environment.mapping = mapping;
  environment.scale = Rgb(1);
  environment.map_from_world = map_from_world;
  Face face = face_of(map, textures);
  face.columns_wrap = mapping == EnvironmentMapping::LatLong;
  set_map(environment, face, textures, max_cells);
  return environment;
}

}  // namespace candela
