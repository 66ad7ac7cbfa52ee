// Renders a scene file with candela as a library: the five doors, one after another.
#include <cstdio>

#include "integrators/render.h"
#include "renderer/accel/any_accel.h"
#include "renderer/image/image_io.h"
#include "renderer/scene/compile.h"
#include "scene_io/load.h"

int give_up(const candela::Diagnostics& reasons) {
  for (const auto& reason : reasons.list()) std::puts(to_string(reason).c_str());
  return 1;
}

int main(int, char** arguments) {
  const auto description = candela::load(arguments[1], {});
  if (!description) return give_up(description.diagnostics);
  candela::RenderOptions options = candela::usual_options();
  options.width = options.height = 64;
  options.samples_per_pixel = 4;
  const auto scene = candela::compile(*description, candela::compile_options(options));
  if (!scene) return give_up(scene.diagnostics);
  const auto accelerator = build_accelerator(*scene, candela::AcceleratorKind::Auto);
  const auto result = candela::render(*scene, accelerator, options, nullptr, nullptr);
  std::printf("%ju camera rays\n", std::uintmax_t{result.statistics.rays.camera});
  const auto written = candela::write_image(arguments[2], result.film.to_image(false), {});
  return written.has_errors() ? give_up(written) : 0;
}
