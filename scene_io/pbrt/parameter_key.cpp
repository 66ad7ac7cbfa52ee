#include "scene_io/pbrt/parameter_key.h"

#include <fmt/format.h>

#include "scene_io/pbrt/source_files.h"

namespace candela::pbrt {

std::string key_of(const Parameter& parameter, bool names_files, const std::string& scene_path) {
  Diagnostics unsaid;  // what there is to say of a file is said as it is read
  const Report report(unsaid);
  std::string key = fmt::format("\n{} {}", name_of(parameter.type), parameter.name);
  for (const double number : parameter.numbers) key += fmt::format(" {}", number);
  for (const std::string& string : parameter.strings) {
    const std::string meant =
        names_files ? resolve_file(scene_path, parameter.place, string, report) : string;
    key += fmt::format(" {}:{}", meant.size(), meant);
  }
  return key;
}

}  // namespace candela::pbrt
