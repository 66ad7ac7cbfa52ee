// What directives change and AttributeEnd brings back.
#pragma once

#include <array>
#include <memory>

#include "renderer/math/transform.h"
#include "scene_io/pbrt/parameter.h"
#include "scene_io/pbrt/program.h"

namespace candela::pbrt {

enum class AttributeTarget : std::uint8_t { Shape, Light, Material, Medium, Texture };
inline constexpr std::array<std::string_view, 5> attribute_targets{"shape", "light", "material",
                                                                   "medium", "texture"};

struct GraphicsState {
  Transform transform;         // current object -> world, at the shutter's opening
  bool sets_transform = true;  // ActiveTransform: false for EndTime
  bool is_reversed = false;    // ReverseOrientation
  MediaUse media;
  std::size_t area_light = none;  // of Program::area_lights
  MaterialUse material;
  // Of the directive Attribute, by target; null where there are none.
  std::array<std::shared_ptr<const ParameterList>, attribute_targets.size()> defaults;
};

}  // namespace candela::pbrt
