#include "scene_io/pbrt/write/write_pbrt.h"

#include <algorithm>

#include <fmt/format.h>

#include "renderer/description/lamp_surfaces.h"
#include "renderer/description/validate.h"
#include "scene_io/pbrt/write/write_lights.h"
#include "scene_io/pbrt/write/write_materials.h"
#include "scene_io/pbrt/write/write_media.h"
#include "scene_io/pbrt/write/write_shapes.h"
#include "scene_io/pbrt/write/write_view.h"

namespace candela::pbrt {
namespace {

std::string section(std::string_view title, const std::string& text) {
  return text.empty() ? "" : fmt::format("\n# {}\n{}", title, text);
}

// What is asked for first is written last: shapes ask for materials, those for textures.
// `scene` has the surfaces of its triangle lights.
Result<WrittenScene> write_valid(const description::SceneDescription& scene,
                                 const WriteOptions& options) {
  WrittenScene written;
  Diagnostics diagnostics;
  WriteContext context{scene, options, written, diagnostics};
  TextureWriter textures(context);
  MaterialWriter materials(context, textures);
  MediaWriter media(context);
  const std::string shapes = write_shapes(context, textures, materials, media);
  const description::MediumHandle camera_medium = options.camera < scene.cameras.size()
                                                      ? scene.cameras[options.camera].medium
                                                      : description::MediumHandle();
  const std::string around_camera = media.interface_of({{}, camera_medium});
  const std::string lights = write_lights(context, textures);
  written.text = "# Written by candela from a scene named " + stem_of(scene.path) +
                 ".\n# Lines that begin with #candela: are read by candela alone.\n\n" +
                 media.text() + around_camera + write_view(context, !media.text().empty()) +
                 (around_camera.empty() ? "" : "MediumInterface \"\" \"\"\n") + "\nWorldBegin\n" +
                 section("Lights", lights) + section("Textures", textures.text()) +
                 section("Materials", materials.text()) + section("Shapes", shapes);
  return {std::move(written), std::move(diagnostics)};
}

}  // namespace

Result<WrittenScene> write_pbrt(const description::SceneDescription& scene,
                                const WriteOptions& options) {
  Diagnostics invalid = description::validate(scene);
  if (invalid.has_errors()) return invalid;
  if (options.camera > 0 && options.camera >= scene.cameras.size())
    return failure(
        fmt::format("camera {} of a scene that has {}", options.camera, scene.cameras.size()));
  if (std::ranges::none_of(scene.lights, description::is_triangle_light))
    return write_valid(scene, options);
  description::SceneDescription with_surfaces = scene;
  description::add_lamp_surfaces(with_surfaces);
  return write_valid(with_surfaces, options);
}

}  // namespace candela::pbrt
