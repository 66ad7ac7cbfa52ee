// argv -> Arguments. The only door to CLI11.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/candela/arguments.h"
#include "tools/candela/exit_code.h"

namespace candela::cli {

// Either arguments to run, or texts to print and the code to end with (help, version, usage error).
struct ParsedArguments {
  std::optional<Arguments> arguments;
  std::string output;  // for stdout
  std::string error;   // for stderr
  ExitCode exit_code = ExitCode::Done;
};

// `words`: the command line without the program's name.
[[nodiscard]] ParsedArguments parse_arguments(const std::vector<std::string>& words);

[[nodiscard]] std::vector<std::string_view> command_names();

}  // namespace candela::cli
