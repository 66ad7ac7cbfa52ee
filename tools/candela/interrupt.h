// What SIGINT (Ctrl-C) and SIGTERM do at each stage of a run.
//
//   EndAtOnce  the process ends with 130, nothing was written (loading, compiling, building); a
//              temporary file that was there to try whether one can be is gone, too
//   Cancel     the first sets the flag that render() polls, so that the image so far is written;
//              the second ends the process at once
//   Finish     files are being written, or were: the first is kept for later, the second ends the
//              process at once and takes a half-written temporary file along
//
// The state is the process's (a signal handler can reach nothing else); everything that the handler
// does is async-signal-safe.
#pragma once

#include "renderer/base/progress.h"

namespace candela::cli {

enum class InterruptMode : int { EndAtOnce, Cancel, Finish };

// Installs the handlers and ignores SIGPIPE and SIGXFSZ, so that a closed pipe and a limit of
// files' sizes are write errors like any other. A signal that the parent had ignored (nohup, a
// shell's background job) stays ignored.
void install_signal_handlers();

void set_interrupt_mode(InterruptMode mode);

[[nodiscard]] CancelFlag& cancel_flag();
[[nodiscard]] bool was_interrupted();

}  // namespace candela::cli
