// What shapes wear: materials with all that their shapes add to them (alpha, media, light).
#pragma once

#include <array>
#include <compare>
#include <map>

#include "scene_io/pbrt/lights.h"
#include "scene_io/pbrt/materials.h"
#include "scene_io/pbrt/media.h"
#include "scene_io/pbrt/shape.h"
#include "scene_io/pbrt/textures.h"

namespace candela::pbrt {

// Shapes that add the same share a material.
class ShapeMaterials {
 public:
  ShapeMaterials(Context& context, Textures& textures, Materials& materials, Media& media)
      : context_(context), textures_(textures), materials_(materials), media_(media) {}

  // `count`: of the shapes that pbrt has in the mesh's place.
  description::MaterialHandle of(ShapeStatement& shape, const description::Mesh& mesh,
                                 std::size_t count);

 private:
  struct Key {
    const description::Material* base = nullptr;
    std::array<double, 3> emission{};
    bool emits_both_sides = false;
    std::uint32_t emission_map = Handle<int>::none;
    bool emission_is_maps_mean = false;
    std::uint32_t inside = Handle<int>::none, outside = Handle<int>::none;  // media
    // Of the shape's alpha.
    double opacity = 1;
    std::uint32_t opacity_map = Handle<int>::none, opacity_texture = Handle<int>::none;
    auto operator<=>(const Key&) const = default;
  };

  // `place`: of the first shape that has it.
  description::MaterialHandle of(const Key& key, const Place& place);
  // lab3's material knows of its holes itself.
  void read_alpha(ShapeStatement& shape, Key& key);
  [[nodiscard]] static bool has_alpha(const Key& key);
  // Whether it is to rays as if it were not there.
  [[nodiscard]] static bool is_absent(const Key& key);
  // Of holes between media, past which rays stay in the medium that they are in.
  void warn_of_holes(const Key& key, const Place& place);
  // `area`: of each of pbrt's shapes, which are lights of their own, in the mean.
  void read_emission_of(const ShapeStatement& shape, double area, Key& key);
  // pbrt gives each triangle the whole power, and so each a radiance of its own.
  void warn_of_uneven_power(const ShapeStatement& shape, const description::Mesh& mesh,
                            std::size_t count);
  description::MaterialHandle add(const Key& key, const Place& place);
  // The parts stand before it in the scene.
  description::MixMaterial mix_of(const MixParts& parts, description::MixMaterial mix,
                                  const Place& place);
  // The shape's alpha, and what a mixture with an interface leaves.
  void set_opacity(const Key& key, description::Material& material, const Place& place);

  Context& context_;
  Textures& textures_;
  Materials& materials_;
  Media& media_;
  std::map<Key, description::MaterialHandle> made_;
  std::map<std::size_t, Emission> emissions_;
};

}  // namespace candela::pbrt
