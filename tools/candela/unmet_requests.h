// What a command line asks for by name and a render has none of. What candela itself decides
// (`auto`, and what nobody said) is no request.
#pragma once

#include <string>
#include <vector>

#include "tools/candela/arguments.h"
#include "tools/candela/render_report.h"

namespace candela::cli {

inline constexpr AovSet layers_of_errors =
    aov_bit(Aov::Variance) | aov_bit(Aov::Interval) | aov_bit(Aov::HeavyTail);

// A sentence for each that the scene and the options tell beforehand.
[[nodiscard]] std::vector<std::string> unmet_requests(const RenderArguments& arguments,
                                                      const Scene& scene,
                                                      const RenderOptions& options);

// What the finished render alone tells: guides that were asked for have learned nothing.
[[nodiscard]] bool lacks_guides(const Scene& scene, const RenderReport& report);

}  // namespace candela::cli
