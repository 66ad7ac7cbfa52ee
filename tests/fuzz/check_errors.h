// What holds for the diagnostics of every reader.
#pragma once

#include <string>

#include "renderer/base/diagnostic.h"

namespace candela::fuzz {

// "" where each has something to say, on one line.
inline std::string fault_of(const Diagnostics& diagnostics) {
  if (diagnostics.list().size() > 3 * Diagnostics::limit) return "too many diagnostics";
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    if (diagnostic.message.empty()) return "a diagnostic says nothing";
    if (diagnostic.message.find('\n') != std::string::npos) return "a message of several lines";
  }
  return "";
}

// The same of a reader that gave no result: it must say why.
inline std::string fault_of_failure(const Diagnostics& diagnostics) {
  return diagnostics.has_errors() ? fault_of(diagnostics) : "no result and no error";
}

}  // namespace candela::fuzz
