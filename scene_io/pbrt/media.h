// Media, as far as candela has them: what glass holds may absorb.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "scene_io/pbrt/context.h"

namespace candela::pbrt {

class Media {
 public:
  explicit Media(Context& context) : context_(context) {}

  // Absorption a unit of length; 0, with a warning, of media that candela has not.
  [[nodiscard]] Vec3d absorption_of(const MediumUse& use);

 private:
  Vec3d read(Statement& statement, const std::string& name);

  Context& context_;
  std::map<std::string, Vec3d> read_;
};

}  // namespace candela::pbrt
