// candela info SCENE

#include "integrators/render.h"
#include "renderer/accel/any_accel.h"
#include "renderer/accel/few_faces.h"
#include "tools/candela/commands.h"
#include "tools/candela/console.h"
#include "tools/candela/json_reports.h"
#include "tools/candela/option_values.h"
#include "tools/candela/read_scene.h"
#include "tools/candela/scene_hash.h"

namespace candela::cli {

ExitCode run_info(const InfoArguments& arguments) {
  Console console(false);
  const ReadScene read = read_scene(arguments.scene, console);
  if (!read.is_usable()) return read.refusal;
  SceneInfo info = describe_scene(*read.description, *read.scene);
  info.scene_hash = scene_hash(*read.description);
  info.kernel = kernel_name(*read.scene, read.options);
  if (!find_few_faces(*read.scene).faces.is_empty()) {
    const EmbreeAccel accelerator(*read.scene, {.faces = true});
    info.faces = accelerator.face_count();
    info.listed_spheres = accelerator.sphere_count();
    info.boxes = accelerator.box_count();
  }
  if (arguments.accelerator) {
    info.accelerator = name_of(*arguments.accelerator, accelerator_choices());
    info.accelerator_bytes = memory_bytes(build_accelerator(*read.scene, *arguments.accelerator));
  }
  return print_result(arguments.as_json ? to_json(info) : to_text(info), console);
}

}  // namespace candela::cli
