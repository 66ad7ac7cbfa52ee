// The last net: what nobody caught becomes a sentence and an exit code.
#pragma once

#include <functional>

#include "tools/candela/exit_code.h"

namespace candela::cli {

// The code that `work` returns; Limit where memory ran out, Bug for any other exception.
[[nodiscard]] ExitCode guarded(const std::function<ExitCode()>& work);

}  // namespace candela::cli
