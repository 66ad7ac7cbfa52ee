#include "scene_io/pbrt/lights.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "renderer/math/constants.h"
#include "scene_io/image_encoding.h"
#include "scene_io/pbrt/map_axes.h"
#include "scene_io/pbrt/spectrum.h"
#include "scene_io/pbrt/textures.h"
#include "scene_io/pbrt/transforms.h"

namespace candela::pbrt {
namespace {

using description::ConstantEnvironment;

Vec3d unit_or(const Vec3d& v, const Vec3d& otherwise) {
  const double largest = max_component(glm::abs(v));
  return largest > 0 && std::isfinite(largest) ? normalize(v / largest) : otherwise;
}

// Whether it stands behind candela's own mark on its line.
bool is_own(const Place& place) {
  const std::string_view before = place.file->source().text.substr(0, place.offset);
  const std::size_t begin = before.find_last_of("\r\n");
  return before.substr(begin == std::string_view::npos ? 0 : begin).find(own_mark) !=
         std::string_view::npos;
}

constexpr double unset = -1;  // as pbrt-v4 writes a power or illuminance that is none

// What light is multiplied by: at least 0. pbrt-v3 gives a colour.
double scale_of(Arguments& arguments) {
  const Parameter* given = arguments.find("scale");
  if (!given) return 1;
  const bool is_colour = given->type == ParameterType::Rgb && given->numbers.size() == 3;
  const double factor = is_colour ? (given->numbers[0] + given->numbers[1] + given->numbers[2]) / 3
                                  : arguments.number("scale").value_or(1);
  if (factor >= 0) return factor;
  arguments.error(*given, fmt::format("is {}, expected at least 0", factor));
  return 0;
}

// One light being read.
class LightReader {
 public:
  LightReader(Context& context, LightStatement& light)
      : context_(context), light_(light), arguments_(light.statement, context.report) {}

  void read() {
    const std::string& type = light_.statement.type;
    if (type == "point")
      point();
    else if (type == "spot")
      spot();
    else if (type == "distant")
      distant();
    else if (type == "infinite" || type == "exinfinite")
      infinite();
    else if (type == "goniometric")
      goniometric();
    else if (type == "projection")
      projection();
    else
      return refuse();
    arguments_.warn_of_unknown();
  }

 private:
  void refuse() {
    const std::string& type = light_.statement.type;
    context_.report.error(light_.statement.place,
                          fmt::format("{} is no light{}", text::quoted(type),
                                      nearest_or_all(type, {"point", "spot", "distant", "infinite",
                                                            "goniometric", "projection"})));
  }

  // Factors of factors may overflow.
  void check(const Vec3d& brightness, const Vec3d& position = Vec3d(0.0)) const {
    if (!is_finite(brightness) || !is_finite(position))
      context_.report.error(light_.statement.place,
                            "the light's brightness or place is not finite");
  }

  template <class Kind>
  void add(Kind kind) {
    context_.scene.lights.push_back({light_.statement.place.span(), std::move(kind)});
  }

  // The light's colour times `scale`, as the film sees it.
  Vec3d colour(std::string_view name) {
    const auto given = light_colour(arguments_, name, context_.scene);
    return given.value_or(Vec3d(1.0)) * (scale_of(arguments_) * context_.imaging_ratio);
  }
  Vec3d place(const Vec3d& p) const { return light_.world_from_light.point(p); }
  // From -> to.
  Vec3d axis(const Vec3d& from, const Vec3d& to) {
    const Vec3d along = light_.world_from_light.vector(to - from);
    if (along == Vec3d(0.0) && !arguments_.has_errors())
      context_.report.error(light_.statement.place, "\"from\" and \"to\" are the same point");
    return unit_or(along, Vec3d(0, 0, 1));
  }

  void point() {
    Vec3d intensity = colour("I");
    if (const auto power = arguments_.positive("power", unset))
      intensity *= *power / (4 * pi_double);
    const Vec3d position = place(arguments_.point("from").value_or(Vec3d(0.0)));
    check(intensity, position);
    add(description::PointLight{position, intensity});
  }

  void spot() {
    const Vec3d from = arguments_.point("from").value_or(Vec3d(0.0));
    const Vec3d to = arguments_.point("to").value_or(Vec3d(0, 0, 1));
    const double outer =
        arguments_.clamped("coneangle", arguments_.number("coneangle").value_or(30), 0, 180);
    const double delta =
        arguments_.clamped("conedeltaangle", arguments_.number("conedeltaangle").value_or(5), 0);
    description::SpotLight light{place(from), axis(from, to), colour("I"), 0, 0};
    light.outer_angle_radians = outer * (pi_double / 180);
    // pbrt knows the cosine alone of where the fall begins, which a negative angle has as well.
    const double inner = std::min(std::abs(outer - delta), outer);
    light.inner_angle_radians = inner * (pi_double / 180);
    // Between the angles the intensity is half of the whole in the mean over cosines.
    const double start = std::cos(light.inner_angle_radians);
    const double end = std::cos(light.outer_angle_radians);
    const double share = (1 - start) + (start - end) / 2;
    // A cone without an inside has none to give.
    if (const auto power = arguments_.positive("power", unset))
      light.intensity *= share > 0 ? *power / (2 * pi_double * share) : 0.0;
    check(light.intensity, light.position);
    if (similarity_scale(light_.world_from_light, seen_stretch) == 0)
      context_.report.warning(light_.statement.place,
                              "the light's transform stretches its cone, which stays round");
    add(light);
  }

  // Without an image it is a point light.
  void goniometric() {
    description::GoniometricLight light;
    light.position = place(Vec3d(0.0));
    light.intensity = colour("I");
    light.power = arguments_.positive("power", unset);
    if (const Parameter* file = arguments_.find("filename", {ParameterType::String})) {
      light.world_from_map = map_axes(light_from_goniometric_map);
      light.image = light_image(*file);
      if (!light.image) return;
    }
    check(light.intensity, light.position);
    add(light);
  }

  void projection() {
    description::ProjectionLight light;
    light.position = place(Vec3d(0.0));
    light.intensity = Vec3d(scale_of(arguments_) * context_.imaging_ratio);
    light.power = arguments_.positive("power", unset);
    light.angle_degrees = arguments_.number("fov").value_or(90);
    light.world_from_map = map_axes(Mat3d(1.0));
    const bool is_v3 = arguments_.has("mapname") && !arguments_.has("filename");
    const Parameter* file = arguments_.file(is_v3 ? "mapname" : "filename", "a projection");
    if (!file) return;
    if (!(light.angle_degrees > 0 && light.angle_degrees < 180))
      return arguments_.error(
          *arguments_.find("fov"),
          fmt::format("is {}, expected degrees above 0 and below 180", light.angle_degrees));
    light.image = light_image(*file);
    if (!light.image) return;
    check(light.intensity, light.position);
    add(light);
  }

  void distant() {
    const Vec3d from = arguments_.point("from").value_or(Vec3d(0.0));
    const Vec3d to = arguments_.point("to").value_or(Vec3d(0, 0, 1));
    Vec3d irradiance = colour("L");
    if (const auto illuminance = arguments_.positive("illuminance", unset))
      irradiance *= *illuminance;
    check(irradiance);
    add(description::DirectionalLight{-axis(from, to), irradiance});
  }

  void infinite() {
    arguments_.ignore("portal", "light comes from all of the sky");
    arguments_.accept({"samples", "nsamples"});
    const auto illuminance = arguments_.positive("illuminance", unset);
    const Parameter* file = arguments_.find("filename", {ParameterType::String});
    const Parameter* v3_file = arguments_.find("mapname", {ParameterType::String});
    const Vec3d colour_and_scale = colour("L");
    is_seen_by_camera_ = arguments_.flag("seen", true);  // candela's own
    if (const Parameter* faces = arguments_.find("cube", {ParameterType::String}))
      return add_cube(*faces);
    if (file || v3_file) {
      if (illuminance)
        arguments_.warning(*arguments_.find("illuminance"),
                           "is ignored: the image's own radiance counts");
      const Parameter* L = arguments_.find("L");
      if (file && L && !is_own(L->place))
        arguments_.warning(*L, "multiplies the image, as in pbrt-v3; pbrt-v4 takes one of them");
      return v3_file ? add_map<description::LatLongEnvironment>(*v3_file, colour_and_scale)
                     : add_map<description::EqualAreaEnvironment>(*file, colour_and_scale);
    }
    const Vec3d radiance = colour_and_scale * (illuminance ? *illuminance / pi_double : 1.0);
    check(radiance);
    add(ConstantEnvironment{radiance, is_seen_by_camera_});
  }

  // "encoding" is candela's own.
  description::Encoding encoding_of_light(const Parameter& file) {
    if (const auto name = arguments_.string("encoding"))
      if (const auto encoding = encoding_named(*name)) return *encoding;
    return encoding_of_colours(file.strings.empty() ? "" : file.strings[0]);
  }

  // candela's own: lab3's six faces, in the world's space.
  void add_cube(const Parameter& faces) {
    if (faces.strings.size() != 6)
      return arguments_.error(faces,
                              fmt::format("has {}, expected 6 image files", describe_count(faces)));
    description::CubeEnvironment environment;
    const description::Encoding encoding = encoding_of_light(faces);
    for (std::size_t i = 0; i < 6; ++i) {
      Parameter face = faces;
      face.strings = {faces.strings[i]};
      environment.faces[i] = add_light_image(context_, face, encoding);
      if (!environment.faces[i]) return;
    }
    add(environment);
  }

  description::ImageHandle light_image(const Parameter& file) {
    return add_light_image(context_, file, encoding_of_light(file));
  }

  // The axes of a map in the world, unit.
  Mat3d map_axes(const Mat3d& light_from_map) const {
    Mat3d axes = light_.world_from_light.linear * light_from_map;
    for (int c = 0; c < 3; ++c) axes[c] = unit_or(axes[c], Vec3d(0, 0, 1));
    const Mat3d gram = glm::transpose(axes) * axes;
    if (std::max({std::abs(gram[0][1]), std::abs(gram[0][2]), std::abs(gram[1][2])}) > 1e-4)
      context_.report.warning(light_.statement.place,
                              "the light's transform is no rotation: its axes are not at right "
                              "angles");
    else if (similarity_scale(light_.world_from_light, seen_stretch) == 0)
      context_.report.warning(light_.statement.place,
                              "the light's transform stretches its picture, which is left out");
    return axes;
  }

  template <class Map>
  void add_map(const Parameter& file, const Vec3d& factor) {
    Map environment;
    environment.image = light_image(file);
    if (!environment.image) return;
    check(factor);
    environment.scale = factor;
    environment.is_seen_by_camera = is_seen_by_camera_;
    const bool is_lat_long = std::is_same_v<Map, description::LatLongEnvironment>;
    environment.world_from_map = map_axes(is_lat_long ? light_from_lat_long_map : Mat3d(1.0));
    add(environment);
  }

  Context& context_;
  LightStatement& light_;
  Arguments arguments_;
  bool is_seen_by_camera_ = true;  // of skies
};

}  // namespace

void read_lights(Context& context) {
  for (LightStatement& light : context.program.lights) LightReader(context, light).read();
}

Emission read_emission(Context& context, Statement& statement) {
  Arguments arguments(statement, context.report);
  if (statement.type != "diffuse" && statement.type != "area")  // pbrt-v2 says area
    context.report.error(statement.place, fmt::format("{} is no area light, expected diffuse",
                                                      text::quoted(statement.type)));
  Emission emission;
  emission.radiance = light_colour(arguments, "L", context.scene).value_or(Vec3d(1.0));
  emission.emits_both_sides = arguments.flag("twosided", false);
  arguments.accept({"samples", "nsamples"});
  bool has_own_radiance = false;  // candela's own beside an image, whatever scale and power say
  if (const Parameter* file = arguments.find("filename", {ParameterType::String})) {
    const Parameter* L = arguments.find("L");
    has_own_radiance = L && is_own(L->place);
    if (L && !has_own_radiance) {
      arguments.warning(*L, "is ignored: the image says what is emitted");
      emission.radiance = Vec3d(1.0);
    }
    const std::string name = file->strings.size() == 1 ? file->strings[0] : "";
    emission.map = add_light_image(context, *file, encoding_of_colours(name),
                                   wrap_of(arguments, description::Wrap::Clamp));  // candela's own
  }
  const double scale = scale_of(arguments);
  emission.radiance *= (has_own_radiance ? 1 : scale) * context.imaging_ratio;
  emission.power = arguments.positive("power", unset);
  emission.is_maps_mean = emission.map && emission.power;
  if (has_own_radiance) emission.power.reset();
  arguments.warn_of_unknown();
  if (!is_finite(emission.radiance)) {
    context.report.error(statement.place, "the emission is not finite");
    emission.radiance = Vec3d(0.0);
  }
  return emission;
}

Vec3d Emission::radiance_on(double area) const {
  if (!power || !(area > 0)) return radiance;
  return radiance * (*power / (area * pi_double * (emits_both_sides ? 2 : 1)));
}

}  // namespace candela::pbrt
