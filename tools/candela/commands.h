// The commands beside `render` (whose five verbs main.cpp calls), one a file.
#pragma once

#include "tools/candela/arguments.h"
#include "tools/candela/exit_code.h"

namespace candela::cli {

[[nodiscard]] ExitCode run_info(const InfoArguments& arguments);
[[nodiscard]] ExitCode run_check(const CheckArguments& arguments);
[[nodiscard]] ExitCode run_compare(const CompareArguments& arguments);
[[nodiscard]] ExitCode run_convert(const ConvertArguments& arguments);
[[nodiscard]] ExitCode run_bench(const BenchArguments& arguments);

}  // namespace candela::cli
