#include "scene_io/pbrt/write/write_context.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "renderer/base/letter_case.h"
#include "scene_io/text/file.h"

namespace candela::pbrt {
namespace {

std::string_view last_part(std::string_view path) {
  return path.substr(path.find_last_of("/\\") + 1);
}

// With its dot; names that begin with their only dot have none.
std::size_t extension_begin(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  return dot == 0 || dot == std::string_view::npos ? name.size() : dot;
}

}  // namespace

std::string WriteContext::unique_name(const std::string& kind, const std::string& wish) {
  if (names.insert(kind + '\n' + wish).second) return wish;
  const std::size_t dot = extension_begin(wish);
  int& number = next_numbers.try_emplace(kind + '\n' + wish, 2).first->second;
  for (;;) {
    const std::string name =
        fmt::format("{}-{}{}", wish.substr(0, dot), number++, wish.substr(dot));
    if (names.insert(kind + '\n' + name).second) return name;
  }
}

std::string stem_of(std::string_view path) {
  constexpr std::size_t longest = 64;
  const std::string_view name = text::without_gzip_extension(last_part(path));
  std::string stem(name.substr(0, std::min(extension_begin(name), longest)));
  for (char& c : stem)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_') c = '_';
  return stem.empty() ? "unnamed" : stem;
}

std::string lower_extension_of(std::string_view path) {
  const std::string_view name = last_part(path);
  return to_lower(std::string(name.substr(extension_begin(name))));
}

}  // namespace candela::pbrt
