#include "renderer/description/validate_light.h"

#include <cmath>

#include <fmt/format.h>

#include "renderer/description/validate.h"
#include "renderer/math/constants.h"

namespace candela::description {
namespace {

bool has_area(const std::array<Vec3d, 3>& vertices) {
  const Vec3d a = vertices[1] - vertices[0];
  const Vec3d b = vertices[2] - vertices[0];
  const double size = std::max(max_component(glm::abs(a)), max_component(glm::abs(b)));
  return size > 0 && length(cross(a / size, b / size)) > 0;
}

// Says everything about one light.
class Check {
 public:
  Check(const SceneDescription& scene, const Light& light, Diagnostics& diagnostics)
      : scene_(scene), light_(light), diagnostics_(diagnostics) {}

  void error(std::string message) const { diagnostics_.error(light_.span, std::move(message)); }
  void place(const Vec3d& position) const {
    if (!is_finite(position)) error("the position of a light is not finite");
  }
  void colour(const Vec3d& c, std::string_view what) const {
    for (int i = 0; i < 3; ++i)
      if (!std::isfinite(c[i]) || c[i] < 0)
        return error(fmt::format("the {} of a light is {}, expected finite numbers of at least 0",
                                 what, c[i]));
  }
  // What the scene's size does not change.
  void radiance(const Vec3d& c, std::string_view what) const {
    colour(c, what);
    if (max_component(c) > largest_radiance && is_finite(c))
      error(fmt::format("the {} of a light is {}, expected at most {:g}", what, max_component(c),
                        largest_radiance));
  }
  void direction(const Vec3d& d) const {
    if (!(std::abs(length(d) - 1) < 1e-6))  // written as NaN-safe: what is not near 1 is wrong
      error("the direction of a light is not of length 1");
  }
  void image(ImageHandle handle) const {
    if (handle.index >= scene_.images.size()) error("the image of a light does not exist");
  }
  template <class Map>
  void map(const Map& light) const {
    image(light.image);
    radiance(light.scale, "scale");
    axes(light.world_from_map);
  }

  void operator()(const PointLight& light) const {
    place(light.position);
    colour(light.intensity, "intensity");
  }
  void operator()(const SpotLight& light) const {
    place(light.position);
    direction(light.axis);
    colour(light.intensity, "intensity");
    const double inner = light.inner_angle_radians;
    const double outer = light.outer_angle_radians;
    if (!(inner >= 0 && inner <= outer && outer <= pi_double))
      error(
          fmt::format("the half angles of a spot light are {} and {}, expected 0 <= inner <= "
                      "outer <= pi",
                      inner, outer));
  }
  // Of the axes' angles nothing is said: readers do, who know what to do about it.
  void axes(const Mat3d& world_from_map) const {
    for (int c = 0; c < 3; ++c) direction(world_from_map[c]);
  }
  void power(const std::optional<double>& flux) const {
    if (flux && !(*flux > 0 && std::isfinite(*flux)))
      error(fmt::format("the power of a light is {}, expected above 0", *flux));
  }
  void operator()(const GoniometricLight& light) const {
    place(light.position);
    colour(light.intensity, "intensity");
    if (light.image) image(light.image);
    axes(light.world_from_map);
    power(light.power);
  }
  void operator()(const ProjectionLight& light) const {
    place(light.position);
    colour(light.intensity, "intensity");
    image(light.image);
    axes(light.world_from_map);
    power(light.power);
    if (!(light.angle_degrees > 0 && light.angle_degrees < 180))
      error(
          fmt::format("the angle of a projection light is {} degrees, expected above 0 and below "
                      "180",
                      light.angle_degrees));
  }
  void operator()(const DirectionalLight& light) const {
    direction(light.to_light);
    radiance(light.irradiance, "irradiance");
  }
  void operator()(const TriangleLight& light) const {
    for (const Vec3d& vertex : light.vertices) place(vertex);
    radiance(light.radiance, "radiance");
    if (!has_area(light.vertices)) error("a triangle light has no area");
  }
  void operator()(const ConstantEnvironment& light) const { radiance(light.radiance, "radiance"); }
  void operator()(const CubeEnvironment& light) const {
    for (const ImageHandle face : light.faces) image(face);
  }
  void operator()(const LatLongEnvironment& light) const { map(light); }
  void operator()(const EqualAreaEnvironment& light) const { map(light); }

 private:
  const SceneDescription& scene_;
  const Light& light_;
  Diagnostics& diagnostics_;
};

struct Brightness {
  Vec3d operator()(const PointLight& light) const { return light.intensity; }
  Vec3d operator()(const SpotLight& light) const {
    return light.outer_angle_radians > 0 ? light.intensity : Vec3d(0.0);
  }
  Vec3d operator()(const GoniometricLight& light) const { return light.intensity; }
  Vec3d operator()(const ProjectionLight& light) const { return light.intensity; }
  Vec3d operator()(const DirectionalLight& light) const { return light.irradiance; }
  Vec3d operator()(const TriangleLight& light) const { return light.radiance; }
  Vec3d operator()(const ConstantEnvironment& light) const { return light.radiance; }
  Vec3d operator()(const CubeEnvironment&) const { return Vec3d(1.0); }
  Vec3d operator()(const LatLongEnvironment& light) const { return light.scale; }
  Vec3d operator()(const EqualAreaEnvironment& light) const { return light.scale; }
};

// Of environments.
struct Visibility {
  bool operator()(const ConstantEnvironment& light) const { return light.is_seen_by_camera; }
  bool operator()(const LatLongEnvironment& light) const { return light.is_seen_by_camera; }
  bool operator()(const EqualAreaEnvironment& light) const { return light.is_seen_by_camera; }
  template <class Other>
  bool operator()(const Other&) const {
    return true;
  }
};

bool is_seen(const Light& light) {
  return std::visit(Visibility{}, light.kind);
}

// Several are added up to one, which cameras see or not.
void check_environments(const SceneDescription& scene, Diagnostics& diagnostics) {
  const Light* first = nullptr;
  for (const Light& light : scene.lights) {
    if (!is_environment(light) || is_black(light)) continue;
    if (!first) first = &light;
    if (is_seen(light) != is_seen(*first))
      diagnostics.error(light.span,
                        fmt::format("this environment is {}seen by cameras, unlike the first: "
                                    "several are added up, expected all to be seen or none",
                                    is_seen(light) ? "" : "not "));
  }
}

}  // namespace

bool is_environment(const Light& light) {
  return std::holds_alternative<ConstantEnvironment>(light.kind) ||
         std::holds_alternative<CubeEnvironment>(light.kind) ||
         std::holds_alternative<LatLongEnvironment>(light.kind) ||
         std::holds_alternative<EqualAreaEnvironment>(light.kind);
}

bool is_seen_sky(const Light& light) {
  return is_environment(light) && is_seen(light) && !is_black(light);
}

bool is_black(const Light& light) {
  return std::visit(Brightness{}, light.kind) == Vec3d(0.0);
}

void check_lights(const SceneDescription& scene, Diagnostics& diagnostics) {
  for (const Light& light : scene.lights) std::visit(Check(scene, light, diagnostics), light.kind);
  check_environments(scene, diagnostics);
}

}  // namespace candela::description
