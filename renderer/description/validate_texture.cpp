#include "renderer/description/validate_texture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace candela::description {
namespace {

constexpr std::uint32_t most_depth = 64;
constexpr std::uint32_t most_lookups = 1024;

bool is_finite_pair(const Vec2d& v) {
  return std::isfinite(v.x) && std::isfinite(v.y);
}

// What looking a texture up takes.
struct Cost {
  std::uint32_t depth = 1;
  std::uint32_t lookups = 1;
};

// Says everything about one texture, and sums up what its inputs take.
class Check {
 public:
  // `costs` of the textures before it.
  Check(const SceneDescription& scene, const std::vector<Cost>& costs, Diagnostics& diagnostics)
      : scene_(scene), costs_(costs), index_(costs.size()), diagnostics_(diagnostics) {}

  [[nodiscard]] Cost cost() const { return cost_; }

  void operator()(const ImageTexture& t) const {
    if (t.image.index >= scene_.images.size()) error("its image does not exist");
    mapping(t.mapping);
    if (!std::isfinite(t.factor)) error("its factor is not finite");
  }
  void operator()(const ProductTexture& t) {
    input(t.first);
    input(t.second);
  }
  void operator()(const SquareRootTexture& t) { input(t.input); }
  void operator()(const MixTexture& t) {
    input(t.first);
    input(t.second);
    input(t.amount);
  }
  void operator()(const DirectionMixTexture& t) {
    input(t.first);
    input(t.second);
    if (!(std::abs(length(t.direction) - 1) < 1e-6)) error("its direction is not of length 1");
  }
  void operator()(const SolidCheckerboardTexture& t) {
    place(t.place_from_world);
    input(t.even);
    input(t.odd);
  }
  void operator()(const CheckerboardTexture& t) {
    mapping(t.mapping);
    input(t.even);
    input(t.odd);
  }
  void operator()(const DotsTexture& t) {
    mapping(t.mapping);
    input(t.inside);
    input(t.outside);
  }
  void operator()(const BilinearTexture& t) const {
    mapping(t.mapping);
    for (const Vec3d& corner : {t.v00, t.v01, t.v10, t.v11}) value(corner);
  }

 private:
  void error(std::string_view what) const {
    const Texture& texture = scene_.textures[index_];
    diagnostics_.error(texture.span, fmt::format("texture '{}': {}", texture.name, what));
  }
  void mapping(const UvMapping& m) const {
    if (!is_finite_pair(m.scale) || !is_finite_pair(m.offset))
      error("its mapping has numbers that are not finite");
    if (m.kind != MappingKind::Surface) place(m.place_from_world);
  }
  void place(const Transform& t) const {
    if (!is_finite(t.linear[0]) || !is_finite(t.linear[1]) || !is_finite(t.linear[2]) ||
        !is_finite(t.translation))
      error("the transform of its places has numbers that are not finite");
  }
  void value(const Vec3d& v) const {
    if (!is_finite(v)) error("a value is not finite");
  }
  void input(const ColourInput& i) {
    value(i.factor);
    if (i.map && i.map.index >= scene_.images.size()) error("an image does not exist");
    if (i.map && i.texture) error("an input has a map and a texture");
    if (!i.texture) return;
    if (i.texture.index >= index_) return error("a texture that it uses does not stand before it");
    const Cost& inner = costs_[i.texture.index];
    cost_ = {std::max(cost_.depth, inner.depth + 1),
             std::min(cost_.lookups + inner.lookups, 2 * most_lookups)};
  }

  const SceneDescription& scene_;
  const std::vector<Cost>& costs_;
  Cost cost_;
  std::size_t index_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_textures(const SceneDescription& scene, Diagnostics& diagnostics) {
  std::vector<Cost> costs;
  costs.reserve(scene.textures.size());
  for (const Texture& texture : scene.textures) {
    Check check(scene, costs, diagnostics);
    std::visit(check, texture.kind);
    costs.push_back(check.cost());
    if (costs.back().depth > most_depth || costs.back().lookups > most_lookups)
      diagnostics.error(texture.span,
                        fmt::format("texture '{}' is made of more than {} others, or nested deeper "
                                    "than {}",
                                    texture.name, most_lookups, most_depth));
  }
}

}  // namespace candela::description
