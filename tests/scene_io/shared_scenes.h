// Scenes that are not part of the repository: CANDELA_SCENES, or ../shared/scenes beside it.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace candela {

// The path of a file or folder of them, if it is there.
inline std::optional<std::string> shared_scene(const std::string& name) {
  const char* const named = std::getenv("CANDELA_SCENES");
  const std::filesystem::path folder =
      named != nullptr ? named : CANDELA_SOURCE_DIR "/../shared/scenes";
  const std::filesystem::path path = folder / name;
  if (!std::filesystem::exists(path)) return std::nullopt;
  return path.string();
}

}  // namespace candela
