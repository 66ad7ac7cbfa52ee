// What ends a command before it begins.
#pragma once

#include <string>

#include "integrators/render_options.h"
#include "tools/candela/arguments.h"
#include "tools/candela/exit_code.h"

namespace candela::cli {

// A sentence and the code to end with; thrown.
struct Refusal {
  std::string sentence;
  ExitCode exit_code;
};

// Throws a Refusal (ExitCode::Usage) where the command line asks for what the settled `options`
// have no use for, or for what does not go together.
void refuse_what_does_not_fit(const RenderArguments& arguments, const RenderOptions& options);

}  // namespace candela::cli
