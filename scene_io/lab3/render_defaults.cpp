#include "scene_io/lab3/render_defaults.h"

#include <limits>

#include <fmt/format.h>

#include "renderer/math/white_balance.h"
#include "scene_io/text/number.h"

namespace candela::lab3 {
namespace {

using description::RenderDefaults;

constexpr std::string_view keys[] = {"Width",    "Height",      "SamplesPerPixel", "spp",
                                     "MaxDepth", "Seed",        "Integrator",      "Filter",
                                     "Exposure", "WhiteBalance"};
constexpr std::string_view integrators[] = {"path", "report", "whitted", "raster"};
constexpr std::string_view filters[] = {"box",      "gaussian", "blackman_harris",
                                        "triangle", "mitchell", "sinc"};
constexpr Range kelvins{coolest_kelvins, hottest_kelvins, false, false,
                        "a white balance in kelvins from 100 to 1e9"};
constexpr Range stops{-100, 100, false, false, "an exposure in stops from -100 to 100"};

std::optional<int> to_int(const std::optional<std::int64_t>& number) {
  if (!number) return std::nullopt;
  return static_cast<int>(*number);
}

bool is_none(const Entry& entry) {
  return entry.value->is_scalar() && is_same_name(entry.value->text, "none");
}

std::optional<int> read_max_depth(const Fields& fields) {
  const Entry* entry = fields.find("MaxDepth");
  if (!entry || is_none(*entry)) return std::nullopt;
  return to_int(fields.integer("MaxDepth", 0, RenderDefaults::deepest, " or none"));
}

template <std::size_t n>
std::optional<std::string> word_of(const Fields& fields, std::string_view key,
                                   const std::string_view (&words)[n]) {
  const auto index = fields.choice(key, words);
  if (!index) return std::nullopt;
  return std::string(words[*index]);
}

// What the scene's own integrator makes nothing of; the command line, which may name another one,
// has rules of its own.
void warn_of_idle_keys(Reader& reader, const Fields& fields, const RenderDefaults& defaults) {
  const bool is_raster = defaults.integrator == "raster";
  if (!is_raster && defaults.integrator != "whitted") return;
  const auto warn = [&](const Entry* entry, std::string_view reason) {
    reader.warning(entry->key_offset, fmt::format("{} has no effect: {} {}", entry->key,
                                                  *defaults.integrator, reason));
  };
  if (defaults.filter && defaults.filter != "box")
    warn(fields.find("Filter"), "averages its grid of samples, which is a box filter");
  const Entry* depth = fields.find("MaxDepth");
  if (depth && is_raster) warn(depth, "follows no ray beyond the first surface");
  if (depth && !is_raster && is_none(*depth)) warn(depth, "needs a limit, which is 5 then");
}

}  // namespace

void read_render_defaults(Reader& reader, const Fields& root) {
  const Entry* entry = root.find("Render");
  if (!entry) return;
  reader.is_extended = true;
  if (entry->value->is_null()) return;  // as {}: all keys may be absent
  const Fields fields(reader, *entry->value, "Render", keys);
  static constexpr std::string_view sample_names[] = {"SamplesPerPixel", "spp"};
  RenderDefaults& defaults = reader.scene.defaults;
  defaults.width = to_int(fields.integer("Width", 1, RenderDefaults::largest_side));
  defaults.height = to_int(fields.integer("Height", 1, RenderDefaults::largest_side));
  if (fields.last_of(sample_names))
    defaults.samples_per_pixel = to_int(fields.integer(
        fields.has("spp") ? "spp" : "SamplesPerPixel", 1, RenderDefaults::most_samples));
  defaults.max_depth = read_max_depth(fields);
  defaults.integrator = word_of(fields, "Integrator", integrators);
  defaults.filter = word_of(fields, "Filter", filters);
  defaults.exposure = fields.number("Exposure", stops);
  defaults.white_balance_kelvins = fields.number("WhiteBalance", kelvins);
  const auto seed = fields.integer("Seed", 0, std::numeric_limits<std::int64_t>::max());
  if (seed) defaults.seed = static_cast<std::uint64_t>(*seed);
  warn_of_idle_keys(reader, fields, defaults);
}

}  // namespace candela::lab3
