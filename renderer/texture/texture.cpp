#include "renderer/texture/texture.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <tuple>

#include <fmt/format.h>

#include "renderer/image/codecs.h"
#include "renderer/math/transcendental.h"
#include "renderer/texture/footprint_ranges.h"
#include "renderer/texture/one_texture.h"
#include "renderer/texture/uv_range.h"

namespace candela {

struct TextureStore::Files {
  // By path, and by whether the image shines.
  std::map<std::pair<std::string, bool>, std::unique_ptr<TextureFile>> by_path;
  std::vector<std::unique_ptr<TextureFile>> calculated;
  std::map<std::tuple<const TextureFile*, Encoding, Wrap>, TextureHandle> handle_of;
  // Of images that shine, in the order in which they came: where each was asked for as such first.
  std::vector<std::pair<const TextureFile*, SourceSpan>> lights;
};

TextureStore::TextureStore() : files_(std::make_unique<Files>()) {}
TextureStore::TextureStore(TextureStore&&) noexcept = default;
TextureStore& TextureStore::operator=(TextureStore&&) noexcept = default;
TextureStore::~TextureStore() = default;

namespace {

void warn_of(const Result<ImageHeader>& header, const SourceSpan& span, Diagnostics& diagnostics) {
  for (const Diagnostic& found : header.diagnostics.list())
    diagnostics.warning(
        span, fmt::format("texture {}{}", found.message, header ? "" : "; it is magenta"));
}

}  // namespace

// Values below 0, which are no light, only files of floats have: all uses share the others.
TextureFile& TextureStore::file_of(const description::Image& image, bool is_light,
                                   Diagnostics& diagnostics) {
  const std::string path = std::filesystem::path(image.path).lexically_normal().string();
  const auto other = files_->by_path.find({path, !is_light});
  if (other != files_->by_path.end() && !other->second->holds_floats()) return *other->second;
  std::unique_ptr<TextureFile>& file = files_->by_path[{path, is_light}];
  if (file) return *file;
  const Result<ImageHeader> header = read_image_header(image.path, DecodeLimits{});
  // A broken image is magenta, but codecs that are not there end the run.
  const Diagnostics missing = header ? Diagnostics{} : why_codecs_are_missing();
  for (const Diagnostic& reason : missing.list())
    diagnostics.error(image.span, fmt::format("texture '{}' {}", image.path, reason.message));
  const bool is_told_as_light = is_light && !header;  // by broken_lights()
  if (!missing.has_errors() && !is_told_as_light) warn_of(header, image.span, diagnostics);
  file = std::make_unique<TextureFile>(image.path, image.span, header, is_light);
  return *file;
}

TextureHandle TextureStore::add(TextureFile& file, const description::Image& image) {
  const auto [at, is_new] = files_->handle_of.try_emplace({&file, image.encoding, image.wrap},
                                                          TextureHandle(textures_.size()));
  if (is_new) textures_.push_back(std::make_unique<Texture>(file, image.encoding, image.wrap));
  return at->second;
}

TextureHandle TextureStore::add(const description::Image& image, Diagnostics& diagnostics) {
  return add(file_of(image, false, diagnostics), image);
}

TextureHandle TextureStore::add_light(const description::Image& image, Diagnostics& diagnostics) {
  TextureFile& file = file_of(image, true, diagnostics);
  const bool is_known =
      std::ranges::any_of(files_->lights, [&](const auto& light) { return light.first == &file; });
  if (!is_known) files_->lights.emplace_back(&file, image.span);
  return add(file, image);
}

Diagnostics TextureStore::broken_lights() const {
  Diagnostics found;
  for (const auto& [file, span] : files_->lights)
    if (file->is_broken()) found.error(span, fmt::format("a light's image {}", file->complaint()));
  return found;
}

void TextureStore::check_brightness(TextureHandle light, double factor, double most,
                                    Diagnostics& diagnostics) const {
  TextureFile& used = textures_[light.index]->file();
  for (const auto& [file, span] : files_->lights) {
    if (file != &used) continue;
    if (double{used.largest()} * factor > most)
      diagnostics.error(span, fmt::format("a light's image '{}' holds {:g}, which its scale makes "
                                          "more than {:g}",
                                          file->path(), used.largest(), most));
  }
}

TextureHandle TextureStore::add(const std::string& name, TexelArray texels, Wrap wrap) {
  files_->calculated.push_back(std::make_unique<TextureFile>(name, std::move(texels)));
  textures_.push_back(
      std::make_unique<Texture>(*files_->calculated.back(), Encoding::Linear, wrap));
  return TextureHandle(textures_.size() - 1);
}

namespace {

// As fine as the finest of its inputs, where it looks at them.
TextureInfo info_of(const Procedural& procedural, const TextureStore& textures) {
  const bool is_pattern = procedural.kind == ProceduralKind::Checkerboard ||
                          procedural.kind == ProceduralKind::Dots || procedural.is_by_place();
  constexpr float pattern_size = 1024;  // patterns have edges that no texel is fine enough for
  Vec2f size(is_pattern ? pattern_size : 1.0f);
  for (const TextureValue& input : procedural.inputs) {
    if (!input.texture) continue;
    const TextureInfo& info = textures.info(input.texture);
    size = glm::max(size, Vec2f(static_cast<float>(info.width), static_cast<float>(info.height)));
  }
  constexpr float largest = 1 << 20;
  const Vec2f seen = glm::clamp(size * glm::abs(procedural.uv_scale), Vec2f(1), Vec2f(largest));
  return {static_cast<int>(seen.x), static_cast<int>(seen.y), 4, false, 0};
}

}  // namespace

TextureHandle TextureStore::add(const Procedural& procedural) {
  textures_.push_back(std::make_unique<Texture>(procedural, info_of(procedural, *this)));
  return TextureHandle(textures_.size() - 1);
}

bool TextureStore::is_image(TextureHandle texture) const {
  return textures_[texture.index]->is_image();
}

Vec4f TextureStore::lookup(TextureHandle texture, Vec2f uv) const {
  return textures_[texture.index]->lookup(*this, uv, nullptr);
}

TextureStore::Stored TextureStore::lookup_stored(TextureHandle image, Vec2f uv) const {
  return textures_[image.index]->lookup_stored(*this, uv, nullptr);
}

TextureStore::Stored TextureStore::lookup_stored_at(TextureHandle texture,
                                                    const TexturePoint& at) const {
  return textures_[texture.index]->lookup_stored(*this, at.uv, &at);
}

std::optional<Vec2f> TextureStore::slope(TextureHandle texture, Vec2f uv) const {
  return textures_[texture.index]->slope(uv);
}

void TextureStore::prefetch(TextureHandle texture, Vec2f uv) const {
  textures_[texture.index]->prefetch(uv);
}

Vec4f TextureStore::lookup_at(TextureHandle texture, const TexturePoint& at) const {
  return textures_[texture.index]->lookup(*this, at.uv, &at);
}

float TextureStore::lookup_alpha_at(TextureHandle texture, const TexturePoint& at) const {
  return textures_[texture.index]->lookup_alpha(*this, at);
}

bool TextureStore::is_by_place(TextureHandle texture) const {
  return textures_[texture.index]->is_by_place(*this);
}

Vec4f TextureStore::texel(TextureHandle texture, int x, int y) const {
  return textures_[texture.index]->texel(x, y);
}

std::vector<Vec4f> TextureStore::texels(TextureHandle texture, int row) const {
  return textures_[texture.index]->texels(row);
}

namespace {

// The file's channel behind one of lookup()'s; none: alpha of a file that has none.
std::optional<int> stored_channel(const TexelArray& texels, int channel) {
  const int colours = texels.channels <= 2 ? 1 : 3;
  if (channel < 3) return std::min(channel, colours - 1);
  if (texels.has_alpha()) return texels.channels - 1;
  return {};
}

TextureStore::Range widened_by_rounding(const ValueRange& range) {
  const float rounding = (range.high - range.low) * 0x1p-22f;  // of the filter between the two
  return {range.low - rounding, range.high + rounding};
}

}  // namespace

TextureStore::Range TextureStore::range_in_triangle(TextureHandle texture, const Vec2f (&uv)[3],
                                                    int channel) const {
  const Texture& used = *textures_[texture.index];
  if (!used.is_image()) return {0, std::numeric_limits<float>::infinity()};
  const TexelArray& texels = used.file().texels();
  const std::optional<int> stored = stored_channel(texels, channel);
  if (!stored) return {1, 1};
  if (used.is_single_texel(texels)) {
    const float value = stored_value(texels, 0, 0, *stored);
    return {value, value};
  }
  return widened_by_rounding(
      range_over_triangle(used.file(), {uv[0], uv[1], uv[2]}, *stored, used.wrap()));
}

TextureStore::RangeGrid TextureStore::range_grid(TextureHandle texture, int channel,
                                                 int cell_side) const {
  const Texture& used = *textures_[texture.index];
  if (!used.is_image()) return {1, 1, Wrap::Repeat, {}};
  const TexelArray& texels = used.file().texels();
  const std::optional<int> stored = stored_channel(texels, channel);
  if (!stored) return {1, 1, Wrap::Repeat, {{1, 1}}};
  if (used.is_single_texel(texels)) {
    const float value = stored_value(texels, 0, 0, *stored);
    return {1, 1, Wrap::Repeat, {{value, value}}};
  }
  RangeGrid grid{texels.width, texels.height, used.wrap(), {}};
  if (used.wrap() == Wrap::Black) return grid;
  for (const ValueRange& range : footprint_ranges(texels, *stored, used.wrap(), cell_side))
    grid.cells.push_back(widened_by_rounding(range));
  return grid;
}

TextureStore::ScalarKind TextureStore::scalar_kind(TextureHandle texture) const {
  const Texture& used = *textures_[texture.index];
  if (!used.is_image() || used.info().channels == 1) return ScalarKind::First;
  const TexelArray& texels = used.file().texels();        // which may turn out to be broken
  if (used.file().is_broken()) return ScalarKind::Alpha;  // 1: what is opaque stays so
  if (texels.has_alpha() && !is_opaque(texels)) return ScalarKind::Alpha;
  return is_grey(texels) ? ScalarKind::First : ScalarKind::Mean;
}

bool TextureStore::may_exceed_one(TextureHandle texture) const {
  return textures_[texture.index]->file().holds_floats();
}

const TextureInfo& TextureStore::info(TextureHandle texture) const {
  return textures_[texture.index]->info();
}

const std::string& TextureStore::path(TextureHandle texture) const {
  return textures_[texture.index]->file().path();
}

Encoding TextureStore::encoding(TextureHandle texture) const {
  return textures_[texture.index]->encoding();
}

std::size_t TextureStore::size() const {
  return textures_.size();
}

void TextureStore::decode(TextureHandle texture) const {
  std::vector<bool> is_known(textures_.size());
  std::vector<TextureHandle> left{texture};
  while (!left.empty()) {
    const TextureHandle next = left.back();
    left.pop_back();
    if (!next || is_known[next.index]) continue;
    is_known[next.index] = true;
    textures_[next.index]->decode();
    for (const TextureValue& input : textures_[next.index]->inputs()) left.push_back(input.texture);
  }
}

bool TextureStore::is_decoded(TextureHandle texture) const {
  const Texture& used = *textures_[texture.index];
  return !used.is_image() || used.file().is_decoded();
}

std::size_t TextureStore::decoded_bytes() const {
  std::size_t bytes = 0;
  for (const auto& [key, file] : files_->by_path)
    if (file->is_decoded()) bytes += file->texels().bytes();
  for (const auto& file : files_->calculated) bytes += file->texels().bytes();
  return bytes;
}

double TextureStore::decoding_seconds() const {
  double seconds = 0;
  for (const auto& [key, file] : files_->by_path) seconds += file->decoding_seconds();
  return seconds;
}

Diagnostics TextureStore::decoding_diagnostics() const {
  Diagnostics found;
  for (const auto& [key, file] : files_->by_path) found.append(file->decoding_diagnostics());
  return found;
}

}  // namespace candela
