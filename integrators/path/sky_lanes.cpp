#include "integrators/path/sky_lanes.h"

#include "integrators/path/reflectance_lanes.h"
#include "renderer/base/floating_point_traps.h"
#include "renderer/base/vector_widths.h"

namespace candela {
namespace {

// Cells of the sky's table, and places in them.
struct CellLanes {
  [[nodiscard]] GridDistribution::Cell operator[](std::size_t i) const {
    return {column[i], row[i], {x[i], y[i]}, probability[i]};
  }
  void set(std::size_t i, const GridDistribution::Cell& cell) {
    column[i] = cell.column;
    row[i] = cell.row;
    x[i] = cell.offset.x;
    y[i] = cell.offset.y;
    probability[i] = cell.probability;
  }

  Lanes<std::uint32_t> column{}, row{};
  Lanes<float> x{}, y{}, probability{};
};

struct SkyPlaceLanes {
  [[nodiscard]] SkyPlace operator[](std::size_t i) const { return {column[i], row[i], density[i]}; }
  void set(std::size_t i, const SkyPlace& place) {
    column[i] = place.column;
    row[i] = place.row;
    density[i] = place.density;
  }

  Lanes<std::uint32_t> column, row;
  Lanes<float> density;
};

// Each into lanes of its own, which nothing that is read can be.
template <class Find>
inline void find_points_by(const Environment& sky, const Vec3Lanes& directions,
                           SkyPointLanes& points, const Find& find) {
  SkyPointLanes found;
  for (std::uint32_t i = 0; i < block_size; ++i) found.set(i, find(sky, directions[i]));
  points = found;
}
CANDELA_LANES void find_on_cube(const Environment& sky, const Vec3Lanes& directions,
                                SkyPointLanes& points) {
  find_points_by(sky, directions, points, environment_detail::point_on_cube);
}
CANDELA_LANES void find_on_lat_long(const Environment& sky, const Vec3Lanes& directions,
                                    SkyPointLanes& points) {
  find_points_by(sky, directions, points, environment_detail::point_on_lat_long);
}
CANDELA_LANES void find_on_equal_area(const Environment& sky, const Vec3Lanes& directions,
                                      SkyPointLanes& points) {
  find_points_by(sky, directions, points, environment_detail::point_on_equal_area);
}

CANDELA_LANES void sample_in_cells(const Environment& sky, const CellLanes& cells,
                                   const LaneFlags& is_sky, PlainLanes& plain) {
  Vec3Lanes directions;
  Lanes<float> pdf;
  for (std::uint32_t i = 0; i < block_size; ++i) {
    const EnvironmentSample sample = sample_in_cell(sky, cells[i]);
    directions.set(i, sample.direction);
    pdf[i] = sample.pdf;
  }
  LightSampleLanes& samples = plain.light_samples;
  for (std::uint32_t i = 0; i < block_size; ++i) {
    const LightSample sample = sky_sample({directions[i], pdf[i]}, point_of(plain.met, i));
    samples.set(i, is_sky[i] != 0 ? sample : samples[i]);
  }
}

CANDELA_LANES void find_places(const Environment& sky, const Vec3Lanes& directions,
                               SkyPlaceLanes& places) {
  SkyPlaceLanes found;
  for (std::uint32_t i = 0; i < block_size; ++i)
    found.set(i, environment_place(sky, directions[i]));
  places = found;
}

// Of environment_pdf().
void find_pdfs(const Environment& sky, LaneMask lanes, const Vec3Lanes& directions,
               Lanes<float>& pdf) {
  if (sky.is_constant()) {
    for_each_lane(lanes, [&](std::uint32_t i) { pdf[i] = environment_pdf(sky, directions[i]); });
    return;
  }
  SkyPlaceLanes places;
  find_places(sky, directions, places);
  for_each_lane(lanes, [&](std::uint32_t i) { pdf[i] = sky.distribution.pdf(places[i]); });
}

CANDELA_LANES void add_met_radiance(const Lanes<float>& pdf, float choice,
                                    const Vec3Lanes& radiance, const LaneFlags& is_met,
                                    PathLanes& paths) {
  for (std::uint32_t i = 0; i < block_size; ++i) {
    PathState path = paths[i];
    add_met_light<lane_features>({}, radiance[i], pdf[i] * choice, path);
    paths.radiance.set(i, is_met[i] != 0 ? path.radiance : paths.radiance[i]);
  }
}

}  // namespace

void find_sky_points(const Environment& sky, const Vec3Lanes& directions, SkyPointLanes& points) {
  const FloatingPointTraps traps(Traps::Off);  // lanes that nothing is in
  switch (sky.mapping) {
    case EnvironmentMapping::Constant:
      return points.face.fill(0);
    case EnvironmentMapping::Cube:
      return find_on_cube(sky, directions, points);
    case EnvironmentMapping::LatLong:
      return find_on_lat_long(sky, directions, points);
    case EnvironmentMapping::EqualArea:
      return find_on_equal_area(sky, directions, points);
  }
}

void find_sky_radiance(const Environment& sky, const TextureStore& textures, LaneMask lanes,
                       const Vec3Lanes& directions, Coherence coherence, Vec3Lanes& radiance) {
  SkyPointLanes points;
  find_sky_points(sky, directions, points);
  if (coherence == Coherence::Incoherent)
    for_each_lane(lanes, [&](std::uint32_t i) { prefetch_radiance(sky, textures, points[i]); });
  LaneMask lacks_gamma = 0;
  for_each_lane(lanes, [&](std::uint32_t i) {
    const auto stored = textures.lookup_stored(sky.faces[points.face[i]], points[i].uv);
    radiance.set(i, Rgb(stored.value));
    if (stored.lacks_gamma) lacks_gamma |= 1u << i;
  });
  if (lacks_gamma != 0) decode_gamma(lacks_gamma, radiance);
  for_each_lane(lanes, [&](std::uint32_t i) {
    radiance.set(i, sky.scale * valid_radiance(Vec4f(radiance[i], 1)));
  });
}

void sample_sky_in_lanes(const Environment& sky, LaneMask lanes, PlainLanes& plain) {
  CellLanes cells;
  for_each_lane(lanes, [&](std::uint32_t i) {
    cells.set(i, sky.distribution.cells().sample({plain.lamps.u_x[i], plain.lamps.u_y[i]}));
  });
  sample_in_cells(sky, cells, flags_of(lanes), plain);
}

void add_met_sky(const Scene& scene, LaneMask lanes, const Vec3Lanes& directions,
                 const Vec3Lanes& radiance, PathLanes& paths) {
  const FloatingPointTraps traps(Traps::Off);  // lanes that nothing is in
  Lanes<float> pdf{};
  const LaneMask sampled =
      scene.environment_light == Light::none ? 0 : lanes & ~mask_of(paths.is_delta);
  if (sampled != 0) find_pdfs(*scene.environment, sampled, directions, pdf);
  const float choice = sampled == 0 ? 0 : scene.light_sampler.probability(scene.environment_light);
  add_met_radiance(pdf, choice, radiance, flags_of(lanes), paths);
}

}  // namespace candela
