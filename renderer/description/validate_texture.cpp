#include "renderer/description/validate_texture.h"

#include <cmath>

#include <fmt/format.h>

namespace candela::description {
namespace {

bool is_finite_pair(const Vec2d& v) {
  return std::isfinite(v.x) && std::isfinite(v.y);
}

// Says everything about one texture.
class Check {
 public:
  Check(const SceneDescription& scene, std::size_t index, Diagnostics& diagnostics)
      : scene_(scene), index_(index), diagnostics_(diagnostics) {}

  void operator()(const ImageTexture& t) const {
    if (t.image.index >= scene_.images.size()) error("its image does not exist");
    mapping(t.mapping);
    if (!(t.factor >= 0 && std::isfinite(t.factor)))
      error(fmt::format("its factor is {}, expected at least 0", t.factor));
  }
  void operator()(const ProductTexture& t) const {
    input(t.first);
    input(t.second);
  }
  void operator()(const MixTexture& t) const {
    input(t.first);
    input(t.second);
    input(t.amount);
  }
  void operator()(const CheckerboardTexture& t) const {
    mapping(t.mapping);
    input(t.even);
    input(t.odd);
  }
  void operator()(const DotsTexture& t) const {
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
  }
  void value(const Vec3d& v) const {
    for (int c = 0; c < 3; ++c)
      if (!(v[c] >= 0 && std::isfinite(v[c])))
        return error(fmt::format("a value is {}, expected finite numbers of at least 0", v[c]));
  }
  void input(const ColourInput& i) const {
    value(i.factor);
    if (i.map && i.map.index >= scene_.images.size()) error("an image does not exist");
    if (i.texture && i.texture.index >= index_)
      error("a texture that it uses does not stand before it");
  }

  const SceneDescription& scene_;
  std::size_t index_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_textures(const SceneDescription& scene, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < scene.textures.size(); ++i)
    std::visit(Check(scene, i, diagnostics), scene.textures[i].kind);
}

}  // namespace candela::description
