// Materials of pbrt-v4, and the spellings of pbrt-v3 that still occur.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "scene_io/pbrt/context.h"
#include "scene_io/pbrt/textures.h"

namespace candela::pbrt {

// What a mixture mixes: materials that Materials made.
struct MixParts {
  const description::Material* first = nullptr;
  const description::Material* second = nullptr;
  std::size_t depth = 1;  // of mixtures within mixtures
};

// What rays meet nothing at, and what some of them pass through.
[[nodiscard]] bool is_interface(const description::Material& material);
[[nodiscard]] bool has_holes(const description::Material& material);

class Materials {
 public:
  Materials(Context& context, Textures& textures) : context_(context), textures_(textures) {}

  // The material of a shape, not in the scene yet. Made once. After an error a grey one.
  [[nodiscard]] const description::Material& of(const MaterialUse& use);
  // Null where it is no mixture. The handles of a mixture's MixMaterial lead nowhere yet.
  [[nodiscard]] const MixParts* parts_of(const description::Material& material) const;
  // Those that no shape uses, for their errors.
  void read_all();

 private:
  static constexpr std::size_t grey = none;

  [[nodiscard]] std::size_t index_of(const MaterialUse& use);
  [[nodiscard]] std::size_t first_equal(std::size_t index);
  [[nodiscard]] std::string text_of(const Statement& statement) const;
  [[nodiscard]] const description::Material& at(std::size_t index);
  struct Made {
    description::Material material;
    std::optional<MixParts> parts;
  };
  [[nodiscard]] Made make(MaterialStatement& statement);
  void set_surface(Arguments& arguments, description::Material& material);
  [[nodiscard]] Made made(const description::Material& material) const;
  [[nodiscard]] std::optional<Made> mix(Arguments& arguments);
  [[nodiscard]] std::optional<Made> mixed(const description::ScalarInput& amount,
                                          const description::Material& first,
                                          const description::Material& second, const Place& place);
  [[nodiscard]] std::nullopt_t refuse_depth(const Place& place) const;
  [[nodiscard]] Made with_hole(const description::ScalarInput& opacity,
                               const description::Material& material, const Place& place);

  Context& context_;
  Textures& textures_;
  std::map<std::size_t, description::Material> made_;
  // Exporters write the same material before each shape: shapes of one mesh and one material are
  // instances.
  std::map<std::string, std::size_t> index_of_text_;
  std::map<std::size_t, std::size_t> first_equal_;
  std::map<const description::Material*, MixParts> parts_;
  std::set<std::size_t> in_progress_;  // those whose parts are being made
};

// What a material function reads with.
struct MaterialReader {
  Arguments& arguments;
  Context& context;
  Textures& textures;

  // A colour that reflects: at most 1 a channel, with a warning above.
  description::ColourInput reflectance(std::string_view name, double otherwise);
  // Plain number of any type that pbrt takes there.
  double scalar(std::string_view name, double otherwise);
};

// GGX widths along dp/du and, where it differs, along dp/dv.
struct Widths {
  description::ScalarInput along;
  std::optional<description::ScalarInput> across;
};
// `prefix`uroughness, `prefix`vroughness and `prefix`roughness, remapped where asked for.
[[nodiscard]] Widths read_widths(MaterialReader& reader, std::string_view prefix = "");

// The model of a material type of pbrt-v4, or of pbrt-v3; nothing where there is none.
[[nodiscard]] bool set_model(MaterialReader& reader, std::string_view type,
                             description::Material& material);
[[nodiscard]] bool set_v3_model(MaterialReader& reader, std::string_view type,
                                description::Material& material);

// eta and k by `prefix`eta and `prefix`k, or by a reflectance; copper where there is neither.
[[nodiscard]] std::array<Vec3d, 2> read_metal(MaterialReader& reader, std::string_view prefix);

}  // namespace candela::pbrt
