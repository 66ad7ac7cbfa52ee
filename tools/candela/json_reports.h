// Reports as JSON texts for other programs. The only door to nlohmann-json in the tools.
// docs/stats.schema.json describes the first.
#pragma once

#include <string>

#include "tools/candela/render_report.h"
#include "tools/candela/scene_info.h"

namespace candela::cli {

[[nodiscard]] std::string to_json(const RenderReport& report);
[[nodiscard]] std::string to_json(const SceneInfo& info);

}  // namespace candela::cli
