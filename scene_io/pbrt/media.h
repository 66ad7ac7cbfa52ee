// Media: homogeneous ones. All others are as clear as air, with a warning.
#pragma once

#include <map>
#include <string>

#include "scene_io/pbrt/context.h"

namespace candela::pbrt {

class Media {
 public:
  explicit Media(Context& context) : context_(context) {}

  // The medium in the scene, made when it is first asked for; invalid: none.
  [[nodiscard]] description::MediumHandle of(const MediumUse& use);
  // Of those that were not asked for; nothing of them comes to the scene.
  void check_unused() const;

 private:
  description::MediumHandle find(const MediumUse& use);
  void warn_of_type(const Statement& statement, const std::string& type, const std::string& name);
  description::MediumHandle read(Statement& statement, const std::string& name);

  Context& context_;
  std::map<std::string, description::MediumHandle> read_;
};

}  // namespace candela::pbrt
