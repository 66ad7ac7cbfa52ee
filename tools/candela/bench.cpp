// candela bench SCENE
#include <fmt/format.h>

#include "integrators/ray_bench/number_bench.h"
#include "integrators/ray_bench/ray_bench.h"
#include "renderer/base/counted.h"
#include "renderer/base/parallel.h"
#include "renderer/base/printable.h"
#include "tools/candela/commands.h"
#include "tools/candela/console.h"
#include "tools/candela/json_reports.h"
#include "tools/candela/read_scene.h"

namespace candela::cli {
namespace {

std::string back_end_line(std::string_view name, const BackEndFigures& figures) {
  std::string text = fmt::format("  {:<8}{:>9.3f}{:>9.1f}", name, figures.build_seconds,
                                 static_cast<double>(figures.bytes) * 1e-6);
  for (std::size_t i = 0; i < ray_class_names.size(); ++i)
    text += figures.mrays_one_thread[i] > 0
                ? fmt::format("{:>9.2f}{:>9.2f}", figures.mrays_one_thread[i],
                              figures.mrays_all_threads[i])
                : fmt::format("{:>9}{:>9}", "-", "-");  // no such rays
  return text + "\n";
}

std::string ratio_line(const std::array<Spread, ray_class_names.size()>& embree_over_bvh) {
  std::string text = fmt::format("  {:<26}", "embree / bvh");
  for (const Spread& ratio : embree_over_bvh)
    text += fmt::format(
        "{:>18}", ratio.median > 0
                      ? fmt::format("{:.2f} ({:.2f}-{:.2f})", ratio.median, ratio.least, ratio.most)
                      : "-");
  return text + "   on one thread, median (range) of rounds\n";
}

std::string to_text(const std::string& scene, const RayBenchResult& result,
                    const NumberFigures& numbers) {
  std::string text = fmt::format("{}: {} triangles, Embree {}, {}\n", printable(scene),
                                 result.triangles, result.embree_version,
                                 counted(static_cast<std::size_t>(result.threads), "thread"));
  text += fmt::format("  {:<8}{:>9}{:>9}", "", "build s", "MB");
  for (const std::string_view name : ray_class_names) text += fmt::format("{:>18}", name);
  text += fmt::format("   Mray/s on one thread, on all\n");
  text += back_end_line("embree", result.embree) + back_end_line("bvh", result.bvh) +
          ratio_line(result.embree_over_bvh);
  text += "  rays   ";
  for (std::size_t i = 0; i < ray_class_names.size(); ++i)
    text += fmt::format(" {} {}", result.ray_counts[i], ray_class_names[i]);
  const AgreementCounts& agreement = result.agreement;
  text += fmt::format("\n  agree   {} of {} rays; {} disagree, {} at one distance, {} at an edge\n",
                      agreement.rays - agreement.disagreeing, agreement.rays, agreement.disagreeing,
                      agreement.same_distance, agreement.at_edge);
  text += fmt::format("  numbers {:.2f} ns a dimension in blocks of sixteen, {:.2f} one by one\n",
                      numbers.block_ns, numbers.single_ns);
  return text;
}

}  // namespace

ExitCode run_bench(const BenchArguments& arguments) {
  Console console(false);
  const ReadScene read = read_scene(arguments.scene, console);
  if (!read.is_usable()) return read.refusal;
  const int threads = arguments.threads > 0 ? arguments.threads : available_threads();
  RayBenchOptions options;
  options.seconds_each = arguments.seconds_each;
  const RayBenchResult result = run_ray_bench(*read.scene, options, threads);
  const NumberFigures numbers = run_number_bench(arguments.seconds_each);
  return print_result(arguments.as_json ? to_json(arguments.scene.path, result, numbers)
                                        : to_text(arguments.scene.path, result, numbers),
                      console);
}

}  // namespace candela::cli
