// Reports as JSON texts for other programs. The only door to nlohmann-json in the tools.
// docs/stats.schema.json describes the first.
#pragma once

#include <string>

#include "integrators/ray_bench/number_bench.h"
#include "integrators/ray_bench/ray_bench.h"
#include "renderer/image/compare.h"
#include "tools/candela/render_report.h"
#include "tools/candela/scene_info.h"

namespace candela::cli {

[[nodiscard]] std::string to_json(const RenderReport& report);
[[nodiscard]] std::string to_json(const SceneInfo& info);
[[nodiscard]] std::string to_json(const std::string& scene, const RayBenchResult& result,
                                  const NumberFigures& numbers);
// What is not finite becomes null: PSNR of equal images, ratios of black ones.
[[nodiscard]] std::string to_json(const ImageComparison& comparison);

}  // namespace candela::cli
