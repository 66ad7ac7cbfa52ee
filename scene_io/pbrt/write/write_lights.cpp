#include "scene_io/pbrt/write/write_lights.h"

#include <algorithm>
#include <cmath>

#include "renderer/math/constants.h"
#include "scene_io/image_encoding.h"
#include "scene_io/pbrt/map_axes.h"
#include "scene_io/pbrt/textures.h"

namespace candela::pbrt {
namespace {

using description::Encoding;
using description::ImageHandle;

constexpr double degrees = 180 / pi_double;

// Of an image of equal areas that holds what an image of so many texels holds. Even, as the
// octahedron's edges cross in the middle.
int sky_side(double texels) {
  const double side = std::clamp(std::sqrt(texels), 64.0, 4096.0);
  return 2 * static_cast<int>(std::ceil(side / 2));
}

// The directive in a block with the transform, where there is one.
std::string placed(const Mat3d& linear, const Directive& directive,
                   const Vec3d& translation = Vec3d(0.0)) {
  const Transform transform{linear, translation};
  if (transform.is_identity()) return directive.text();
  return "AttributeBegin\n  Transform " + matrix_text(transform) + "\n" + directive.text("  ") +
         "AttributeEnd\n";
}

struct LightWriter {
  WriteContext& context;
  TextureWriter& textures;
  const SourceSpan& span;
  std::size_t index;

  std::string operator()(const description::PointLight& light) const {
    return Directive("LightSource", "point")
        .add("rgb I", light.intensity)
        .add("point3 from", light.position)
        .text();
  }

  std::string operator()(const description::SpotLight& light) const {
    const double outer = light.outer_angle_radians * degrees;
    return Directive("LightSource", "spot")
        .add("rgb I", light.intensity)
        .add("point3 from", light.position)
        .add("point3 to", light.position + light.axis)
        .add("float coneangle", outer)
        .add("float conedeltaangle", outer - light.inner_angle_radians * degrees)
        .text();
  }

  std::string operator()(const description::GoniometricLight& light) const {
    Directive out("LightSource", "goniometric");
    out.add("rgb I", light.intensity);
    if (light.image) add_image(light.image, out);
    if (light.power) out.add("float power", *light.power);
    return placed(light.world_from_map * light_from_goniometric_map, out, light.position);
  }

  // pbrt scales by one number.
  std::string operator()(const description::ProjectionLight& light) const {
    const double mean = (light.intensity.x + light.intensity.y + light.intensity.z) / 3;
    if (light.intensity != Vec3d(mean))
      context.warn(span, "lost: the colour that the projected image is multiplied by");
    Directive out("LightSource", "projection");
    add_image(light.image, out);
    out.add("float fov", light.angle_degrees).add("float scale", mean);
    if (light.power) out.add("float power", *light.power);
    return placed(light.world_from_map, out, light.position);
  }

  std::string operator()(const description::DirectionalLight& light) const {
    return Directive("LightSource", "distant")
        .add("rgb L", light.irradiance)
        .add("point3 from", light.to_light)
        .add("point3 to", Vec3d(0.0))
        .text();
  }

  // Its surface is among the shapes.
  std::string operator()(const description::TriangleLight& /*light*/) const { return ""; }

  std::string operator()(const description::ConstantEnvironment& light) const {
    Directive out("LightSource", "infinite");
    out.add("rgb L", light.radiance);
    add_visibility(light.is_seen_by_camera, out);
    return out.text();
  }

  // Every face's encoding is that of the first.
  std::string operator()(const description::CubeEnvironment& light) const {
    std::vector<std::string> files;
    double texels = 0;
    for (const ImageHandle face : light.faces) {
      files.push_back(textures.file_of(face));
      if (const auto facts = textures.facts_of(face))
        texels += static_cast<double>(facts->width) * facts->height;
    }
    Directive out = sky(texels, Mat3d(1.0));
    if (std::find(files.begin(), files.end(), "") == files.end()) {
      out.add_own("string cube", files);
      add_encoding(light.faces[0], files[0], out);
    }
    return out.text();
  }

  // The image made for pbrt lies in the space that pbrt-v3's latitudes and longitudes lie in.
  std::string operator()(const description::LatLongEnvironment& light) const {
    const Mat3d world_from_light = light.world_from_map * glm::transpose(light_from_lat_long_map);
    const auto facts = textures.facts_of(light.image);
    const std::string file = textures.file_of(light.image);
    Directive out =
        sky(facts ? static_cast<double>(facts->width) * facts->height : 1, world_from_light);
    if (!file.empty()) {
      out.add_own("string mapname", file);
      add_encoding(light.image, file, out);
      if (light.scale != Vec3d(1.0)) out.add_own("rgb L", light.scale);
    }
    add_visibility(light.is_seen_by_camera, out);
    return placed(world_from_light, out);
  }

  // pbrt scales by one number.
  std::string operator()(const description::EqualAreaEnvironment& light) const {
    const std::string file = textures.file_of(light.image);
    if (file.empty()) return placed(light.world_from_map, sky(1, light.world_from_map));
    Directive out("LightSource", "infinite");
    out.add("string filename", file);
    const double mean = (light.scale.x + light.scale.y + light.scale.z) / 3;
    if (mean != 1) out.add("float scale", mean);
    if (light.scale != Vec3d(mean)) {
      context.warn(span, "lost for pbrt: the colour that the sky's image is multiplied by");
      out.add_own("rgb L", light.scale / mean);
    }
    add_encoding(light.image, file, out);
    add_visibility(light.is_seen_by_camera, out);
    return placed(light.world_from_map, out);
  }

 private:
  // An infinite light by an image that is to be made.
  [[nodiscard]] Directive sky(double texels, const Mat3d& world_from_light) const {
    const std::string name = context.options.folder + "/" + context.unique_name("file", "sky.exr");
    context.written.skies.push_back({name, sky_side(texels), world_from_light, index});
    return Directive("LightSource", "infinite").add("string filename", name);
  }

  void add_visibility(bool is_seen, Directive& out) const {
    if (is_seen) return;
    context.warn(span, "lost for pbrt: cameras see its sky");
    out.add_own("bool seen", false);
  }

  void add_image(ImageHandle image, Directive& out) const {
    const std::string file = textures.file_of(image);
    if (file.empty()) return;
    out.add("string filename", file);
    add_encoding(image, file, out);
  }

  void add_encoding(ImageHandle image, const std::string& file, Directive& out) const {
    const Encoding encoding = context.scene.images[image.index].encoding;
    if (encoding != encoding_of_colours(file))
      out.add_own("string encoding", std::string(name_of(encoding)));
  }
};

}  // namespace

std::string area_light(const Vec3d& radiance, bool emits_both_sides) {
  Directive out("AreaLightSource", "diffuse");
  out.add("rgb L", radiance);
  if (emits_both_sides) out.add("bool twosided", true);
  return out.text();
}

std::string write_lights(WriteContext& context, TextureWriter& textures) {
  std::string text;
  const auto& lights = context.scene.lights;
  for (std::size_t i = 0; i < lights.size(); ++i)
    text += std::visit(LightWriter{context, textures, lights[i].span, i}, lights[i].kind);
  return text;
}

}  // namespace candela::pbrt
