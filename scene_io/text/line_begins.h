// Where the lines of a text begin.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace candela::text {

class LineBegins {
 public:
  explicit LineBegins(std::string_view text) {
    for (std::size_t at = text.find('\n'); at != std::string_view::npos;
         at = text.find('\n', at + 1))
      begins_.push_back(at + 1);
  }

  [[nodiscard]] std::size_t count() const { return begins_.size(); }
  // Of the line with this number, from 0.
  [[nodiscard]] std::size_t operator[](std::size_t line) const { return begins_[line]; }
  // The number of the line, from 0, that has this byte of the text.
  [[nodiscard]] std::size_t line_of(std::size_t offset) const {
    const auto next = std::upper_bound(begins_.begin(), begins_.end(), offset);
    return static_cast<std::size_t>(next - begins_.begin()) - 1;
  }

 private:
  std::vector<std::size_t> begins_{0};
};

}  // namespace candela::text
