// How the program ends. docs/cli.md has the table for users.
#pragma once

namespace candela::cli {

enum class ExitCode : int {
  Done = 0,
  Bug = 1,
  Usage = 2,
  Scene = 3,       // scene or asset invalid or missing; with --strict: a warning
  Output = 4,      // cannot be written
  Limit = 5,       // a limit or the memory exceeded
  Comparison = 6,  // a threshold failed
  Interrupted = 130,
};

}  // namespace candela::cli
