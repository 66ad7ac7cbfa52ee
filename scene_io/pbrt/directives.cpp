#include "scene_io/pbrt/directives.h"

#include <algorithm>
#include <array>

#include "scene_io/pbrt/parser.h"

namespace candela::pbrt {
namespace {

using Where = Directive::Where;

// TransformBegin is AttributeBegin in pbrt-v4. SurfaceIntegrator, VolumeIntegrator, Renderer and
// WorldEnd are of earlier versions.
constexpr std::array<Directive, 44> directives{
    {{"Accelerator", &Parser::accelerator},
     {"ActiveTransform", &Parser::active_transform},
     {"AreaLightSource", &Parser::area_light_source, Where::InWorld},
     {"Attribute", &Parser::attribute},
     {"AttributeBegin", &Parser::attribute_begin, Where::InWorld},
     {"AttributeEnd", &Parser::attribute_end, Where::InWorld},
     {"Camera", &Parser::camera, Where::BeforeWorld},
     {"ColorSpace", &Parser::color_space},
     {"ConcatTransform", &Parser::concat_transform},
     {"CoordSysTransform", &Parser::coord_sys_transform},
     {"CoordinateSystem", &Parser::coordinate_system},
     {"Film", &Parser::film, Where::BeforeWorld},
     {"Identity", &Parser::identity},
     {"Import", &Parser::import, Where::InWorld},
     {"Include", &Parser::include},
     {"Integrator", &Parser::integrator, Where::BeforeWorld},
     {"LightSource", &Parser::light_source, Where::InWorld},
     {"LookAt", &Parser::look_at},
     {"MakeNamedMaterial", &Parser::make_named_material, Where::InWorld},
     {"MakeNamedMedium", &Parser::make_named_medium},
     {"Material", &Parser::material, Where::InWorld},
     {"MediumInterface", &Parser::medium_interface},
     {"NamedMaterial", &Parser::named_material, Where::InWorld},
     {"ObjectBegin", &Parser::object_begin, Where::InWorld},
     {"ObjectEnd", &Parser::object_end, Where::InWorld},
     {"ObjectInstance", &Parser::object_instance, Where::InWorld},
     {"Option", &Parser::option},
     {"PixelFilter", &Parser::pixel_filter, Where::BeforeWorld},
     {"Renderer", &Parser::accelerator, Where::BeforeWorld},
     {"ReverseOrientation", &Parser::reverse_orientation, Where::InWorld},
     {"Rotate", &Parser::rotate},
     {"Sampler", &Parser::sampler, Where::BeforeWorld},
     {"Scale", &Parser::scale},
     {"Shape", &Parser::shape, Where::InWorld},
     {"SurfaceIntegrator", &Parser::integrator, Where::BeforeWorld},
     {"Texture", &Parser::texture, Where::InWorld},
     {"Transform", &Parser::transform},
     {"TransformBegin", &Parser::attribute_begin, Where::InWorld},
     {"TransformEnd", &Parser::attribute_end, Where::InWorld},
     {"TransformTimes", &Parser::transform_times, Where::BeforeWorld},
     {"Translate", &Parser::translate},
     {"VolumeIntegrator", &Parser::accelerator, Where::BeforeWorld},
     {"WorldBegin", &Parser::world_begin, Where::BeforeWorld},
     {"WorldEnd", &Parser::world_end}}};

}  // namespace

const Directive* directive_named(std::string_view name) {
  const auto found =
      std::find_if(directives.begin(), directives.end(),
                   [&](const Directive& directive) { return directive.name == name; });
  return found == directives.end() ? nullptr : &*found;
}

std::vector<std::string_view> directive_names() {
  std::vector<std::string_view> names;
  for (const Directive& directive : directives) names.push_back(directive.name);
  return names;
}

// All begin with a capital letter, numbers with none: of those there are most.
bool begins_directive(const Token& token) {
  return token.kind == TokenKind::Word && token.text[0] >= 'A' && token.text[0] <= 'Z' &&
         directive_named(token.text) != nullptr;
}

}  // namespace candela::pbrt
