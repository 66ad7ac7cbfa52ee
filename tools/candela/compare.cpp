// candela compare IMAGE REFERENCE
#include "renderer/image/compare.h"

#include <cmath>

#include <fmt/format.h>

#include "renderer/image/decode.h"
#include "renderer/image/image_format.h"
#include "renderer/image/image_io.h"
#include "tools/candela/commands.h"
#include "tools/candela/console.h"
#include "tools/candela/interrupt.h"
#include "tools/candela/json_reports.h"
#include "tools/candela/output_files.h"

namespace candela::cli {
namespace {

std::string to_text(const ImageComparison& comparison) {
  const auto& ratio = comparison.mean_ratio;
  return fmt::format(
      "relMSE          {:.6g}\n"
      "relMSE trimmed  {:.6g}  (without the worst 0.1 % of the pixels)\n"
      "rMSE            {:.4g} %\n"
      "PSNR            {:.2f} dB\n"
      "mean ratio      {:.5f} {:.5f} {:.5f}  (R G B)\n"
      "worst pixel     {},{}: {:.6g}\n",
      comparison.relmse, comparison.relmse_trimmed, 100 * comparison.rmse, comparison.psnr,
      ratio[0], ratio[1], ratio[2], comparison.worst_x, comparison.worst_y, comparison.worst_error);
}

// Files that cannot be read or do not fit each other.
template <class T>
bool is_printed_error(const Result<T>& result, Console& console) {
  console.print(result.diagnostics);
  return !result;
}

ExitCode write_heatmap(const std::string& path, const Image& image, const Image& reference,
                       Console& console) {
  const Result<Image> heatmap = error_heatmap(image, reference);
  if (is_printed_error(heatmap, console)) return ExitCode::Scene;
  set_interrupt_mode(InterruptMode::Finish);
  const Diagnostics problems = write_image(path, *heatmap, {});
  console.print(problems);
  return problems.has_errors() ? ExitCode::Output : ExitCode::Done;
}

// Before any work; Done where it can be written and is none of the images that are compared.
ExitCode check_heatmap(const CompareArguments& arguments, Console& console) {
  const OutputCheck check = check_outputs({*arguments.heatmap}, {});
  console.print(check.diagnostics);
  if (check.exit_code != ExitCode::Done) return check.exit_code;
  const Diagnostics overwritten = check_inputs_are_spared(
      {*arguments.heatmap}, {arguments.image, arguments.reference}, "this command");
  console.print(overwritten);
  return overwritten.has_errors() ? ExitCode::Output : ExitCode::Done;
}

// Of parts of pictures, which may be of one size and yet show other things. Only EXR files remember
// where they lie.
void warn_of_places(const CompareArguments& arguments, Console& console) {
  for (const std::string& path : {arguments.image, arguments.reference})
    if (format_of_extension(path) != ImageFormat::Exr) return;
  const Result<ImageHeader> image = read_image_header(arguments.image, {});
  const Result<ImageHeader> reference = read_image_header(arguments.reference, {});
  if (!image || !reference) return;
  if (image->left == reference->left && image->top == reference->top) return;
  console.warning(
      fmt::format("the images are parts of pictures, and of different places: their first pixels "
                  "are {},{} and {},{}",
                  image->left, image->top, reference->left, reference->top));
}

ExitCode judge(const CompareArguments& arguments, const ImageComparison& comparison,
               Console& console) {
  if (comparison.invalid_values > 0)
    console.warning(fmt::format(
        "{} values are not finite, and so relMSE, rMSE and PSNR are not; the mean ratio leaves out "
        "these values, relMSE trimmed {}",
        comparison.invalid_values,
        std::isfinite(comparison.relmse_trimmed) ? "their pixels" : "not all of their pixels"));
  if (!arguments.max_relmse) return ExitCode::Done;
  if (comparison.relmse <= *arguments.max_relmse) return ExitCode::Done;  // false for NaN
  console.error(
      fmt::format("relMSE {:.6g} is not within {:g}", comparison.relmse, *arguments.max_relmse));
  return ExitCode::Comparison;
}

}  // namespace

ExitCode run_compare(const CompareArguments& arguments) {
  Console console(false);
  if (arguments.heatmap) {
    const ExitCode checked = check_heatmap(arguments, console);
    if (checked != ExitCode::Done) return checked;
  }
  const Result<Image> image = read_image(arguments.image);
  const Result<Image> reference = read_image(arguments.reference);
  const bool lacks_image = is_printed_error(image, console);
  const bool lacks_reference = is_printed_error(reference, console);
  if (lacks_image || lacks_reference) return ExitCode::Scene;
  const Result<ImageComparison> comparison = compare_images(*image, *reference);
  if (is_printed_error(comparison, console)) return ExitCode::Scene;
  warn_of_places(arguments, console);
  if (arguments.heatmap) {
    const ExitCode written = write_heatmap(*arguments.heatmap, *image, *reference, console);
    if (written != ExitCode::Done) return written;
  }
  const ExitCode printed =
      print_result(arguments.as_json ? to_json(*comparison) : to_text(*comparison), console);
  return printed != ExitCode::Done ? printed : judge(arguments, *comparison, console);
}

}  // namespace candela::cli
