#include "tools/candela/json_reports.h"

#include <nlohmann/json.hpp>

#include "tools/candela/option_values.h"

namespace candela::cli {
namespace {

using Json = nlohmann::ordered_json;

// Paths may be any bytes; what is not UTF-8 is replaced and never an exception.
std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json vec_json(const Vec3d& v) {
  return Json::array({v.x, v.y, v.z});
}

Json seconds_json(const StageSeconds& seconds) {
  return {{"load", seconds.load},
          {"compile", seconds.compile},
          {"build", seconds.build},
          {"render", seconds.render},
          {"write", seconds.write}};
}

Json first_invalid_json(const std::optional<InvalidSample>& first) {
  if (!first) return nullptr;
  return {{"x", first->x}, {"y", first->y}, {"sample", first->sample}};
}

Json crop_json(const PixelRect& crop) {
  return Json::array({crop.x0, crop.y0, crop.x1, crop.y1});
}

Json guiding_json(const RenderReport& report) {
  if (report.options.guiding == Guiding::Off) return nullptr;
  const GuidingDone& done = report.statistics.guiding;
  return {{"training_samples", done.training_samples},
          {"cells", done.cells},
          {"guided_cells", done.guided_cells}};
}

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json stop_json(const RenderReport& report) {
  return {{"by", stop_name(report.statistics.stop)},
          {"target_relmse", or_null(report.options.target_relmse)},
          {"time_limit", or_null(report.options.time_limit_seconds)}};
}

Json error_json(const std::optional<ErrorEstimate>& error) {
  if (!error) return nullptr;
  return {{"relmse", error->relmse},
          {"rmse", error->rmse},
          {"interval95", {error->interval95.low, error->interval95.high}},
          {"heavy_tails", error->heavy_tails},
          {"looked_at", {{"pixels", error->looked_at}, {"samples", error->look_samples}}}};
}

void add_options(Json& json, const RenderReport& report) {
  const RenderOptions& options = report.options;
  json["integrator"] = integrator_name(options);
  json["width"] = options.width;
  json["height"] = options.height;
  json["crop"] = crop_json(report.rect());
  json["camera"] = options.camera;
  json["spp"] = report.has_sample_limit() ? Json(options.samples_per_pixel) : Json(nullptr);
  json["min_samples"] = report.min_samples;
  json["max_samples"] = report.max_samples;
  json["mean_samples"] = report.mean_samples;
  json["interrupted"] = report.is_interrupted();
  json["stop"] = stop_json(report);
  json["replicates"] = report.replicates;
  json["adaptive"] = options.adaptive;
  json["splitting"] = report.statistics.plan.splitting;
  json["reuse"] = report.statistics.plan.reuses_paths;
  json["guiding"] = guiding_json(report);
  json["biased"] = biases_of(report);
  json["max_depth"] = or_null(options.max_depth);
  if (is_lab_shading(options.integrator)) {
    json["specular"] = name_of(options.specular, specular_choices());
    json["lab_normals"] = options.lab_normals;
  }
  if (!is_lab_shading(options.integrator)) {
    json["sampling"] = sampling_name(options);
    if (options.integrator == IntegratorKind::Path) {
      json["roulette"] = report.statistics.plan.roulette_threshold;
      json["roulette_bounce"] = report.statistics.plan.roulette().first_bounce;
      json["roulette_samples"] = report.statistics.roulette_samples;
      json["reuse_samples"] = report.statistics.reuse_samples;
      json["heuristic"] = name_of(options.heuristic, heuristic_choices());
      json["sampler"] = name_of(options.sampler, sampler_choices());
      json["sky_samples"] = options.samples_constant_sky;
      json["sky_compensation"] = options.compensates_sky;
      json["lamp_rays"] = options.lamp_rays;
      json["light_sampling"] = name_of(options.light_sampling, light_sampling_choices());
      json["light_cells"] = options.light_cells;
    }
  }
  if (options.integrator == IntegratorKind::Report) json["rr"] = options.report_p_rr;
  json["filter"] = name_of(options.filter, filter_choices());
  json["filter_radius"] = make_filter(options).radius();
  json["white_balance"] = or_null(options.white_balance_kelvins);
  json["transparent"] = options.transparent;
  json["seed"] = options.seed;
  json["threads"] = report.threads;
  json["accel"] = name_of(report.accelerator, accelerator_choices());
  json["robust"] = report.is_robust;
  json["without"] = savings_text(report.without);
  json["kernel"] = report.statistics.kernel;
}

void add_results(Json& json, const RenderReport& report) {
  const RenderStatistics& statistics = report.statistics;
  json["error"] = error_json(report.error);
  json["seconds"] = seconds_json(report.seconds);
  json["cpu_seconds"] = seconds_json(report.cpu_seconds);
  json["cpu_seconds"]["decoding"] = report.decoding_cpu_seconds;
  json["rays"] = {{"camera", statistics.rays.camera},
                  {"indirect", statistics.rays.indirect},
                  {"shadow", statistics.rays.shadow},
                  {"lamp", statistics.rays.lamp},
                  {"segment", statistics.rays.segment}};
  json["skipped"] = {{"shadow_rays", statistics.skipped.shadow_rays},
                     {"textures", report.skipped_textures},
                     {"samples", statistics.skipped.samples}};
  json["invalid_samples"] = statistics.invalid_samples;
  json["first_invalid_sample"] = first_invalid_json(statistics.first_invalid);
  json["triangles"] = report.triangles;
  json["peak_memory_bytes"] = report.peak_memory_bytes;
  if (report.ray_limit) {
    json["limit_ratio"] = report.ray_limit->ratio();
    json["ray_limit"] = {{"render_cpu_seconds", report.ray_limit->render_seconds},
                         {"rays_cpu_seconds", report.ray_limit->rays_seconds},
                         {"rays", report.ray_limit->rays}};
  }
  json["warnings"] = report.warnings;
  json["outputs"] = report.outputs;
}

Json texture_json(const TextureRow& row) {
  return {{"path", row.path},         {"width", row.width}, {"height", row.height},
          {"channels", row.channels}, {"bytes", row.bytes}, {"used", row.is_used},
          {"decoded", row.is_decoded}};
}

template <class Value, class As = std::identity>
Json by_ray_class(const std::array<Value, ray_class_names.size()>& values, As as = {}) {
  Json json;
  for (std::size_t i = 0; i < values.size(); ++i)
    json[std::string(ray_class_names[i])] = as(values[i]);
  return json;
}

Json spread_json(const Spread& spread) {
  return {{"median", spread.median}, {"least", spread.least}, {"most", spread.most}};
}

Json back_end_json(const BackEndFigures& figures) {
  return {{"build_seconds", figures.build_seconds},
          {"bytes", figures.bytes},
          {"mrays_per_second_one_thread", by_ray_class(figures.mrays_one_thread)},
          {"mrays_per_second", by_ray_class(figures.mrays_all_threads)}};
}

}  // namespace

std::string to_json(const RenderReport& report) {
  Json json;
  json["version"] = CANDELA_VERSION;
  json["command"] = report.command;
  json["scene"] = report.scene;
  json["scene_hash"] = report.scene_hash;
  add_options(json, report);
  add_results(json, report);
  return text_of(json);
}

std::string to_json(const SceneInfo& info) {
  Json json;
  json["version"] = CANDELA_VERSION;
  json["scene"] = info.path;
  json["scene_hash"] = info.scene_hash;
  json["triangles"] = info.triangles;
  json["instanced_triangles"] = info.instanced_triangles;
  json["spheres"] = info.spheres;
  json["geometries"] = info.geometries;
  json["instances"] = info.instances;
  json["cameras"] = info.cameras;
  json["materials"] = info.materials;
  json["media"] = Json::array();
  for (const MediumRow& row : info.media)
    json["media"].push_back({{"name", row.name},
                             {"absorption", vec_json(row.absorption)},
                             {"scattering", vec_json(row.scattering)},
                             {"asymmetry", row.asymmetry}});
  json["textures"] = Json::array();
  for (const TextureRow& row : info.textures) json["textures"].push_back(texture_json(row));
  json["lights"] = info.lights;
  json["light_cells"] = info.light_cells;
  json["bounds"] = {{"min", vec_json(info.bounds_min)}, {"max", vec_json(info.bounds_max)}};
  json["memory_bytes"] = {{"meshes", info.mesh_bytes}, {"textures", info.texture_bytes}};
  if (info.accelerator_bytes) json["memory_bytes"][info.accelerator] = *info.accelerator_bytes;
  json["dropped"] = Json::array();
  for (const Dropped& dropped : info.dropped)
    json["dropped"].push_back({{"what", dropped.what}, {"count", dropped.count}});
  json["kernel"] = info.kernel;
  json["faces"] = info.faces;
  json["listed_spheres"] = info.listed_spheres;
  json["boxes"] = info.boxes;
  return text_of(json);
}

std::string to_json(const std::string& scene, const RayBenchResult& result,
                    const NumberFigures& numbers) {
  const AgreementCounts& agreement = result.agreement;
  Json json;
  json["version"] = CANDELA_VERSION;
  json["scene"] = scene;
  json["embree_version"] = result.embree_version;
  json["threads"] = result.threads;
  json["triangles"] = result.triangles;
  json["rays"] = by_ray_class(result.ray_counts);
  json["embree"] = back_end_json(result.embree);
  json["bvh"] = back_end_json(result.bvh);
  json["embree_over_bvh"] = by_ray_class(result.embree_over_bvh, spread_json);
  json["agreement"] = {{"rays", agreement.rays},
                       {"disagreeing", agreement.disagreeing},
                       {"same_distance", agreement.same_distance},
                       {"at_edge", agreement.at_edge}};
  json["number_nanoseconds"] = {{"block", numbers.block_ns}, {"single", numbers.single_ns}};
  return text_of(json);
}

std::string to_json(const ImageComparison& comparison) {
  Json json;
  json["relmse"] = comparison.relmse;
  json["relmse_trimmed"] = comparison.relmse_trimmed;
  json["rmse"] = comparison.rmse;
  json["psnr"] = comparison.psnr;
  json["mean_ratio"] = comparison.mean_ratio;
  json["worst_pixel"] = {
      {"x", comparison.worst_x}, {"y", comparison.worst_y}, {"error", comparison.worst_error}};
  json["invalid_values"] = comparison.invalid_values;
  return text_of(json);
}

}  // namespace candela::cli
