#include "tools/candela/guarded.h"

#include <cstdio>
#include <exception>
#include <new>
#include <string_view>
#include <system_error>

namespace candela::cli {
namespace {

// The system has no memory for one more thread's stack, or allows no more threads.
bool lacks_threads(const std::exception& exception) {
  const auto* failure = dynamic_cast<const std::system_error*>(&exception);
  if (failure) return failure->code() == std::errc::resource_unavailable_try_again;
  return std::string_view(exception.what()).starts_with("pthread_create");  // oneTBB's own
}

}  // namespace

// Plain stdio: nothing here may need memory.
ExitCode guarded(const std::function<ExitCode()>& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    std::fputs("error: out of memory\n", stderr);
    return ExitCode::Limit;
  } catch (const std::exception& exception) {
    if (lacks_threads(exception)) {
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
