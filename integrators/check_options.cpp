#include "integrators/check_options.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "renderer/math/white_balance.h"

namespace candela {
namespace {

class Check {
 public:
  explicit Check(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  // NaN is in no range.
  template <class Number>
  void within(std::string_view what, Number value, Number low, Number high) const {
    if (!(value >= low && value <= high))
      error(fmt::format("{} is {}, expected {} to {}", what, value, low, high));
  }
  template <class Number>
  void at_least_zero(std::string_view what, Number value) const {
    if (!(value >= 0)) error(fmt::format("{} is {}, expected at least 0", what, value));
  }
  // `high`: infinity where any number is right.
  void above_zero(std::string_view what, double value, double high) const {
    if (!(value > 0 && value <= high))
      error(fmt::format("{} is {}, expected above 0{}", what, value,
                        std::isfinite(high) ? fmt::format(" and at most {}", high) : ""));
  }
  // `last`: of the kinds that there are.
  template <class Kind>
  void exists(std::string_view what, Kind kind, Kind last) const {
    if (kind > last) error(fmt::format("{} is none that there is", what));
  }
  void error(std::string message) const { diagnostics_.error({}, std::move(message)); }

 private:
  Diagnostics& diagnostics_;
};

bool is_part(const PixelRect& crop, int width, int height) {
  return crop.x0 >= 0 && crop.y0 >= 0 && crop.x0 < crop.x1 && crop.y0 < crop.y1 &&
         crop.x1 <= width && crop.y1 <= height;
}

void check_picture(const Scene& scene, const RenderOptions& options, const Check& check) {
  check.within("the width", options.width, 1, max_side);
  check.within("the height", options.height, 1, max_side);
  check.within("the tiles' side", options.tile_size, 1, max_side);
  if (options.camera >= scene.cameras.size())
    check.error(
        fmt::format("camera {} of a scene that has {}", options.camera, scene.cameras.size()));
  if (options.crop && !is_part(*options.crop, options.width, options.height))
    check.error(fmt::format("the crop {},{},{},{} is no part of {} x {} pixels", options.crop->x0,
                            options.crop->y0, options.crop->x1, options.crop->y1, options.width,
                            options.height));
  check.exists("the filter", options.filter, FilterKind::Sinc);
  constexpr double widest = description::RenderDefaults::widest_filter;
  // A box without a width is the pixel's middle.
  if (options.filter_radius && options.filter == FilterKind::Box)
    check.within("the filter's radius", static_cast<double>(*options.filter_radius), 0.0, widest);
  else if (options.filter_radius)
    check.above_zero("the filter's radius", static_cast<double>(*options.filter_radius), widest);
  if (options.white_balance_kelvins)
    check.within("the white balance", *options.white_balance_kelvins, coolest_kelvins,
                 hottest_kelvins);
}

void check_sampling(const RenderOptions& options, const Check& check) {
  check.exists("the integrator", options.integrator, IntegratorKind::Report);
  check.exists("the strategy of sampling", options.sampling, SamplingStrategy::Uniform);
  check.exists("the heuristic", options.heuristic, Heuristic::Balance);
  check.exists("the sampler", options.sampler, SamplerKind::Independent);
  check.exists("the light sampling", options.light_sampling, LightSampling::SolidAngle);
  check.exists("the guiding", options.guiding, Guiding::On);
  check.exists("the specular model", options.specular, SpecularModel::Phong);
  check.within("the number of samples a pixel", options.samples_per_pixel, 1,
               max_samples_per_pixel);
  check.within("the number of replicates", options.replicates, 1, max_replicates);
  check.within("the number of rays for lamps", options.lamp_rays, 0, max_lamp_rays);
  if (options.target_relmse)
    check.above_zero("the relMSE to stop at", *options.target_relmse, INFINITY);
  if (options.time_limit_seconds)
    check.at_least_zero("the limit of time", *options.time_limit_seconds);
}

void check_paths(const RenderOptions& options, const Check& check) {
  check.within("splitting", options.plan.splitting, 1u, max_splitting);
  check.above_zero("the roulette's threshold", static_cast<double>(options.plan.roulette_threshold),
                   1);
  check.above_zero("the report's probability to go on", static_cast<double>(options.report_p_rr),
                   1);
  check.above_zero("what samples are dimmed to", static_cast<double>(options.clamp), INFINITY);
  if (options.max_depth) check.at_least_zero("the depth", *options.max_depth);
}

}  // namespace

Diagnostics check_options(const Scene& scene, const RenderOptions& options) {
  Diagnostics diagnostics;
  const Check check(diagnostics);
  check_picture(scene, options, check);
  check_sampling(options, check);
  check_paths(options, check);
  return diagnostics;
}

void require_valid(const Scene& scene, const RenderOptions& options) {
  const Diagnostics found = check_options(scene, options);
  if (found.has_errors())
    throw std::invalid_argument("RenderOptions: " + found.list().front().message);
}

}  // namespace candela
