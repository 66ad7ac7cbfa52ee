#include "integrators/check_media.h"

#include <fmt/format.h>

namespace candela {

Diagnostics check_media(const description::SceneDescription& scene, std::string_view integrator) {
  Diagnostics diagnostics;
  if (!scene.media.empty())
    diagnostics.warning(scene.media.front().span,
                        fmt::format("medium '{}': {} leaves media out; expected path",
                                    scene.media.front().name, integrator));
  return diagnostics;
}

}  // namespace candela
