#include "tools/candela/guarded.h"

#include <cstdio>
#include <exception>
#include <new>

#include "renderer/base/lack_of_threads.h"

namespace candela::cli {

// Plain stdio: nothing here may need memory.
ExitCode guarded(const std::function<ExitCode()>& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    std::fputs("error: out of memory\n", stderr);
    return ExitCode::Limit;
  } catch (const std::exception& exception) {
    if (is_lack_of_threads(exception)) {
      std::fputs("error: no more threads can be started\n", stderr);
      return ExitCode::Limit;
    }
    std::fprintf(stderr, "error: this is a bug in candela: %s\n", exception.what());
  } catch (...) {
    std::fputs("error: this is a bug in candela\n", stderr);
  }
  return ExitCode::Bug;
}

}  // namespace candela::cli
