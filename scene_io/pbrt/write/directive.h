// A directive of a pbrt file being written: its words, then its parameters. Numbers have the digits
// that give them back exactly. Parameters that only candela knows stand on a line of their own that
// begins with `#candela:`, a comment to pbrt (scene_io/pbrt/token.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "renderer/math/transform.h"
#include "renderer/math/vec.h"

namespace candela::pbrt {

// In quotes, with escapes.
[[nodiscard]] std::string in_quotes(std::string_view text);

[[nodiscard]] std::string value_text(double number);
[[nodiscard]] std::string value_text(int number);
[[nodiscard]] std::string value_text(bool truth);
[[nodiscard]] std::string value_text(const Vec3d& triple);
[[nodiscard]] std::string value_text(const std::vector<double>& numbers);
[[nodiscard]] std::string value_text(const char* text);
[[nodiscard]] std::string value_text(const std::string& text);
[[nodiscard]] std::string value_text(const std::vector<std::string>& texts);

// The sixteen numbers of a Transform directive, column by column.
[[nodiscard]] std::string matrix_text(const Transform& transform);

// "texture reflectance" and "wood", with its quotes.
struct WrittenParameter {
  std::string declaration;
  std::string value;
};

class Directive {
 public:
  // `name` "word": as in Camera "perspective".
  Directive(std::string_view name, std::string_view word);

  // A parameter by its declaration: add("float fov", 60.0).
  template <class Value>
  Directive& add(std::string_view declaration, const Value& value) {
    known_ += " \"" + std::string(declaration) + "\" " + value_text(value);
    return *this;
  }
  Directive& add(const WrittenParameter& parameter) {
    known_ += " \"" + parameter.declaration + "\" " + parameter.value;
    return *this;
  }
  // One that pbrt is not to see.
  template <class Value>
  Directive& add_own(std::string_view declaration, const Value& value) {
    own_ += " \"" + std::string(declaration) + "\" " + value_text(value);
    return *this;
  }
  Directive& add_own(const WrittenParameter& parameter) {
    own_ += " \"" + parameter.declaration + "\" " + parameter.value;
    return *this;
  }
  [[nodiscard]] bool has_own() const { return !own_.empty(); }

  // With the end of its last line.
  [[nodiscard]] std::string text(std::string_view indentation = "") const;

 private:
  std::string known_;
  std::string own_;
};

}  // namespace candela::pbrt
