// What the report's integrator cannot draw of a scene, in sentences (docs/report.md).
#pragma once

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"

namespace candela {

// Errors: lights that are no surfaces; delta lobes and other materials that the report does not
// have. Warnings: emitters that reflect, which the report takes for black. Materials that nothing
// wears do not matter.
[[nodiscard]] Diagnostics check_report(const description::SceneDescription& scene);

}  // namespace candela
