#include "integrators/name_of_delta_light.h"

namespace candela {
namespace {

using namespace description;

struct Name {
  static std::string_view unless_black(const Vec3d& emission, std::string_view name) {
    return emission == Vec3d(0.0) ? "" : name;
  }
  std::string_view operator()(const PointLight& light) const {
    return unless_black(light.intensity, "a point light");
  }
  std::string_view operator()(const SpotLight& light) const {
    return unless_black(light.intensity, "a spot light");
  }
  std::string_view operator()(const GoniometricLight& light) const {
    return unless_black(light.intensity, "a goniometric light");
  }
  std::string_view operator()(const ProjectionLight& light) const {
    return unless_black(light.intensity, "a projection light");
  }
  std::string_view operator()(const DirectionalLight& light) const {
    return unless_black(light.irradiance, "a directional light");
  }
  std::string_view operator()(const TriangleLight&) const { return ""; }
  std::string_view operator()(const ConstantEnvironment&) const { return ""; }
  std::string_view operator()(const CubeEnvironment&) const { return ""; }
  std::string_view operator()(const LatLongEnvironment&) const { return ""; }
  std::string_view operator()(const EqualAreaEnvironment&) const { return ""; }
};

}  // namespace

std::string_view name_of_delta_light(const Light& light) {
  return std::visit(Name{}, light.kind);
}

}  // namespace candela
