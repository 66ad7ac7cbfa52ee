#include "scene_io/pbrt/write/write_media.h"

#include "scene_io/pbrt/write/directive.h"

namespace candela::pbrt {

std::string MediaWriter::interface_of(const description::MediumInterface& sides) {
  if (sides.inside == sides.outside) return "";
  const std::string inside = in_quotes(name_of(sides.inside));
  const std::string outside = in_quotes(name_of(sides.outside));
  return "MediumInterface " + inside + " " + outside + "\n";
}

std::string MediaWriter::name_of(description::MediumHandle handle) {
  if (!handle) return "";
  const auto [at, is_new] = names_.try_emplace(handle.index);
  if (!is_new) return at->second;
  const description::Medium& medium = context_.scene.media[handle.index];
  at->second = context_.unique_name("medium", medium.name.empty() ? "unnamed" : medium.name);
  text_ += Directive("MakeNamedMedium", at->second)
               .add("string type", "homogeneous")
               .add("rgb sigma_a", medium.absorption)
               .add("rgb sigma_s", medium.scattering)
               .add("float g", medium.asymmetry)
               .text();
  return at->second;
}

}  // namespace candela::pbrt
