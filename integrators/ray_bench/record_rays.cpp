#include "integrators/ray_bench/record_rays.h"

#include "renderer/light/sample_light.h"
#include "renderer/math/frame.h"
#include "renderer/sampling/sampler.h"
#include "renderer/sampling/warp.h"
#include "renderer/scene/light_tables.h"
#include "renderer/scene/met_point.h"

namespace candela {
namespace {

const Light* pick_light(const Scene& scene, std::uint32_t bits) {
  const LightSampler& table = scene.light_sampler;
  const std::uint32_t always = static_cast<std::uint32_t>(table.always().size());
  const std::uint32_t choices = always + (table.has_table() ? 1 : 0);
  if (choices == 0) return nullptr;
  const std::uint32_t choice = bits % choices;
  const std::uint32_t light =
      choice < always ? table.always()[choice] : table.pick(mix_bits(bits) & 0xffffffffu).light;
  return &scene.lights[light];
}

// A flat lamp does not light itself: such rays lie in its plane, up to rounding.
void record_shadow_ray(const Scene& scene, const Hit& hit, const SurfacePoint& from,
                       const Sampler& sampler, std::uint32_t bounce, std::vector<Ray>& rays) {
  const Light* light = pick_light(scene, sampler.sample_1d_bits(bounce, Dimension::LightChoice));
  if (!light || light->geometry == hit.geometry) return;
  const LightSample sample = sample_light(light_tables(scene), *light, from,
                                          sampler.sample_2d(bounce, Dimension::LightPoint));
  if (!sample.is_valid() || !(dot(sample.wi, from.geometric_normal) > 0)) return;
  Ray ray = sample.shadow_ray;
  if (ray.t_max < infinity) {  // to a finite light: unit, and well short of its own surface
    const float distance = length(ray.direction);
    ray = {ray.origin, ray.direction / distance, distance * (1 - 0x1p-12f)};
  }
  if (is_traceable(ray)) rays.push_back(ray);
}

void record_path(const Scene& scene, const EmbreeAccel& accelerator, const RecordOptions& options,
                 Ray ray, const Sampler& sampler, RecordedRays& rays) {
  rays[static_cast<std::size_t>(RayClass::Camera)].push_back(ray);
  for (int bounce = 0; bounce <= options.bounces; ++bounce) {
    const Hit hit = accelerator.intersect(ray);
    if (!hit.is_hit()) return;
    const SurfacePoint from = met_point(scene, hit, -ray.direction);
    if (!is_finite(from.geometric_normal)) return;  // no area
    const auto dimension_bounce = static_cast<std::uint32_t>(bounce);
    record_shadow_ray(scene, hit, from, sampler, dimension_bounce,
                      rays[static_cast<std::size_t>(RayClass::Shadow)]);
    if (bounce == options.bounces) return;
    const Vec3f local =
        square_to_cosine_hemisphere(sampler.sample_2d(dimension_bounce, Dimension::Direction));
    ray = spawn_ray(from, normalize(frame_from_normal(from.geometric_normal).to_world(local)));
    if (!is_traceable(ray)) return;
    rays[static_cast<std::size_t>(RayClass::Bounce)].push_back(ray);
  }
}

}  // namespace

RecordedRays record_rays(const Scene& scene, const EmbreeAccel& accelerator,
                         const RecordOptions& options) {
  RecordedRays rays;
  if (options.camera >= scene.cameras.size()) return rays;
  const Camera& camera = scene.cameras[options.camera];
  for (int y = 0; y < options.height; ++y) {
    for (int x = 0; x < options.width; ++x) {
      const Sampler sampler(options.seed, static_cast<std::uint32_t>(x),
                            static_cast<std::uint32_t>(y), 0);
      const Vec2f pixel(static_cast<float>(x), static_cast<float>(y));
      const Vec2f film =
          (pixel + sampler.sample_2d(0, Dimension::Filter)) /
          Vec2f(static_cast<float>(options.width), static_cast<float>(options.height));
      const Ray ray = camera.generate_ray(film, sampler.sample_2d(0, Dimension::Lens));
      if (is_traceable(ray)) record_path(scene, accelerator, options, ray, sampler, rays);
    }
  }
  return rays;
}

}  // namespace candela
