// The words as one line that a shell reads back as the same words.
#pragma once

#include <string>
#include <vector>

namespace candela::cli {

// `words`: the command line without the program's name, which comes first.
[[nodiscard]] std::string quoted_command_line(const std::vector<std::string>& words);

}  // namespace candela::cli
