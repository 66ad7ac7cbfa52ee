// "A, B or C", for sentences that name what is expected.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace candela {

// At least one word.
[[nodiscard]] inline std::string one_of(std::span<const std::string_view> words) {
  std::string text(words[0]);
  for (std::size_t i = 1; i < words.size(); ++i) {
    text += i + 1 < words.size() ? ", " : " or ";
    text += words[i];
  }
  return text;
}

}  // namespace candela
