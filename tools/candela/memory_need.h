// Whether the memory suffices for a picture.
#pragma once

#include <optional>
#include <string>

#include "integrators/render_options.h"

namespace candela::cli {

// Bytes that a render holds at least at one time, beside the scene.
[[nodiscard]] double needed_memory(const RenderOptions& options);

// A sentence where that cannot fit: an overcommitting kernel would end us without a word.
[[nodiscard]] std::optional<std::string> missing_memory(const RenderOptions& options);

}  // namespace candela::cli
