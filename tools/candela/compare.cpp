// candela compare IMAGE REFERENCE
#include "tools/candela/commands.h"
#include "tools/candela/console.h"

namespace candela::cli {

ExitCode run_compare(const CompareArguments&) {
  Console console(false);
  console.error("compare is not built into this version yet");
  return ExitCode::Bug;
}

}  // namespace candela::cli
