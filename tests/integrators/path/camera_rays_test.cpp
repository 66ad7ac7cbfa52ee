// The camera rays of a block at once against those of single samples.
#include "integrators/path/camera_rays.h"

#include <gtest/gtest.h>

#include "renderer/base/floating_point_traps.h"

namespace candela {
namespace {

// A pixel of its own for each ray.
PixelLanes some_pixels() {
  PixelLanes pixels{{}, {}, 20, 10};
  for (int i = 0; i < 16; ++i) {
    pixels.x[static_cast<std::size_t>(i)] = i;
    pixels.y[static_cast<std::size_t>(i)] = 9 - i / 2;
  }
  return pixels;
}

Camera camera_of(CameraKind kind, float lens_radius) {
  Camera camera;
  camera.kind = kind;
  camera.eye = {0.1f, 0.2f, 0.3f};
  camera.look = normalize(Vec3f(0.2f, -0.1f, -1));
  camera.right = {0.9f, 0, 0.1f};
  camera.up = {0, 0.5f, -0.05f};
  camera.lens_radius = lens_radius;
  camera.focus_distance = 2;
  return camera;
}

CameraNumbers some_numbers(const Camera& camera) {
  CameraNumbers numbers;
  const PixelSampler pixel(7, 3, 5, 4);
  numbers.draw(camera, SamplerBlock(pixel, 16), Dimension::Filter, Dimension::Lens);
  return numbers;
}

void expect_same(const Vec3f& a, const Vec3f& b) {
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.y, b.y);
  EXPECT_EQ(a.z, b.z);
}

TEST(Unit_CameraRays, AreThoseOfSingleSamples) {
  constexpr FilterPart part{{0.25f, 0.5f}, {0.5f, 0.125f}};
  for (const Camera& camera :
       {camera_of(CameraKind::Perspective, 0), camera_of(CameraKind::Perspective, 0.1f),
        camera_of(CameraKind::Orthographic, 0), camera_of(CameraKind::LatLong, 0)}) {
    for (const FilterKind kind : {FilterKind::Box, FilterKind::Gaussian, FilterKind::Mitchell}) {
      const Filter filter(kind, default_radius(kind));
      const CameraNumbers numbers = some_numbers(camera);
      const PlaceLanes places = sample_places(filter, part, numbers);
      RayBlock rays;
      EXPECT_EQ(aim_camera_rays(camera, some_pixels(), places, numbers, all_lanes, rays),
                all_lanes);
      for (std::size_t i = 0; i < block_size; ++i) {
        const Vec2f place = filter.sample(part.number(unit_point(numbers.filter, i)));
        const Ray ray =
            camera.generate_ray(some_pixels()[i].on_film(place), unit_point(numbers.lens, i));
        expect_same(rays.origin[i], ray.origin);
        expect_same(rays.direction[i], ray.direction);
        EXPECT_EQ(rays.t_max[i], ray.t_max);
      }
    }
  }
}

TEST(Unit_CameraRays, OnlyThoseThatCanBeTracedAreTold) {
  const Filter filter(FilterKind::Box, 0.5f);
  Camera camera = camera_of(CameraKind::Perspective, 0);
  const CameraNumbers numbers = some_numbers(camera);
  const PlaceLanes places = sample_places(filter, {}, numbers);
  RayBlock rays;
  constexpr LaneMask lanes = 0b110010;
  EXPECT_EQ(aim_camera_rays(camera, some_pixels(), places, numbers, lanes, rays), lanes);
  camera.eye.y = 1e16f;
  EXPECT_EQ(aim_camera_rays(camera, some_pixels(), places, numbers, lanes, rays), 0u);
  const FloatingPointTraps traps(Traps::Off);  // comparisons with NaN raise them
  camera.eye.y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(aim_camera_rays(camera, some_pixels(), places, numbers, lanes, rays), 0u);
}

}  // namespace
}  // namespace candela
