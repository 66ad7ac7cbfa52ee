// MakeNamedMedium directives, each made when a surface or a camera first asks for it.
#pragma once

#include <map>
#include <string>

#include "scene_io/pbrt/write/write_context.h"

namespace candela::pbrt {

class MediaWriter {
 public:
  explicit MediaWriter(WriteContext& context) : context_(context) {}

  // A MediumInterface with its newline; "" where both sides are alike.
  [[nodiscard]] std::string interface_of(const description::MediumInterface& sides);

  // All directives so far.
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string name_of(description::MediumHandle medium);

  WriteContext& context_;
  std::string text_;
  std::map<std::uint32_t, std::string> names_;
};

}  // namespace candela::pbrt
