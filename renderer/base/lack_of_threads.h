// How a lack of threads is told, which like one of memory says nothing of the work at hand.
#pragma once

#include <exception>
#include <string_view>
#include <system_error>

namespace candela {

// The system has no memory for one more thread's stack, or allows no more threads.
[[nodiscard]] inline bool is_lack_of_threads(const std::exception& exception) {
  const auto* failure = dynamic_cast<const std::system_error*>(&exception);
  if (failure) return failure->code() == std::errc::resource_unavailable_try_again;
  return std::string_view(exception.what()).starts_with("pthread_create");  // oneTBB's own
}

}  // namespace candela
