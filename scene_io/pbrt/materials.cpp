#include "scene_io/pbrt/materials.h"

#include <algorithm>

#include <fmt/format.h>

#include "renderer/description/validate_material.h"
#include "renderer/math/reflectance.h"
#include "scene_io/pbrt/own_materials.h"
#include "scene_io/pbrt/parameter_key.h"
#include "scene_io/pbrt/spectrum.h"

namespace candela::pbrt {
namespace {

using description::ColourInput;
using description::Material;
using description::ScalarInput;

constexpr std::size_t deepest = description::deepest_mixture;

// Of types that candela knows; those of pbrt-v3 are not suggested.
constexpr std::string_view type_names[] = {
    "diffuse",    "coateddiffuse",  "conductor",           "coatedconductor",
    "dielectric", "thindielectric", "diffusetransmission", "interface",
    "mix"};

// [Pharr23, section 9.6]: the square root of what the author writes.
ScalarInput width_of(MaterialReader& reader, const ScalarInput& input, bool remaps) {
  return remaps ? reader.textures.square_root(input, reader.arguments.statement().place) : input;
}

// pbrt takes what is smoother than this for smooth.
constexpr double smooth = 1e-3;

// Of the second part. pbrt-v3's may be a colour.
ScalarInput mix_amount(Arguments& arguments, Textures& textures, bool is_v3) {
  ScalarInput amount{0.5, {}, 0, {}};
  const Parameter* given = arguments.find("amount");
  if (given && is_v3 && given->type == ParameterType::Rgb && given->numbers.size() == 3)
    amount.factor = (given->numbers[0] + given->numbers[1] + given->numbers[2]) / 3;
  else
    amount = textures.scalar(arguments, "amount").value_or(amount);
  amount.factor = arguments.clamped("amount", amount.factor, 0, 1);
  return amount;
}

// Of a mix of pbrt-v3; without a name where it is absent or in error.
MaterialUse named_part(Arguments& arguments, std::string_view name) {
  const auto part = arguments.string(name);
  return part ? MaterialUse{none, *part, arguments.find(name)->place} : MaterialUse{};
}

// Of a metal by two lists of samples and nothing else.
std::optional<std::array<Vec3d, 2>> read_metal_spectra(MaterialReader& reader,
                                                       std::string_view prefix) {
  Arguments& arguments = reader.arguments;
  const Parameter* eta = arguments.find(fmt::format("{}eta", prefix));
  const Parameter* k = arguments.find(fmt::format("{}k", prefix));
  const auto is_sampled = [](const Parameter* parameter) {
    return parameter && parameter->type == ParameterType::Spectrum && !names_a_spectrum(*parameter);
  };
  if (!is_sampled(eta) || !is_sampled(k) || arguments.has("reflectance")) return std::nullopt;
  return metal_of_spectra(*eta, *k, reader.context.scene, arguments.report())
      .value_or(*metal_named("metal-Cu-eta"));
}

}  // namespace

bool is_interface(const Material& material) {
  return std::holds_alternative<description::InterfaceMaterial>(material.model);
}

bool has_holes(const Material& material) {
  return !material.opacity.is_constant() || material.opacity.factor != 1;
}

ColourInput MaterialReader::reflectance(std::string_view name, double otherwise) {
  ColourInput input =
      textures.colour(arguments, name).value_or(ColourInput{Vec3d(otherwise), {}, {}});
  if (!input.is_constant()) return input;
  if (max_component(input.factor) > 1)
    arguments.warning(*arguments.find(name), "is above 1: surfaces reflect at most all light");
  // Of textures as in pbrt, silently; numbers below 0 are told of by validation.
  const Parameter* given = arguments.find(name);
  const bool is_texture = given != nullptr && given->type == ParameterType::Texture;
  input.factor = glm::min(is_texture ? glm::max(input.factor, 0.0) : input.factor, Vec3d(1.0));
  return input;
}

double MaterialReader::scalar(std::string_view name, double otherwise) {
  const Parameter* parameter = arguments.find(
      name,
      {ParameterType::Float, ParameterType::Rgb, ParameterType::Spectrum, ParameterType::Texture});
  if (!parameter) return otherwise;
  if (parameter->type == ParameterType::Texture) {
    const auto input = textures.scalar_texture(*parameter);
    if (input && input->is_constant()) return input->factor;
    if (input)
      arguments.warning(*parameter, fmt::format("must be a number here: {} is used", otherwise));
    return otherwise;
  }
  const auto mean = mean_value(*parameter, context.scene, context.report);
  const bool has_colour =
      parameter->type == ParameterType::Rgb || parameter->type == ParameterType::Spectrum;
  if (mean && has_colour)
    context.warn_once("dispersion", parameter->place,
                      "a colour or a spectrum here counts as one number: light is not dispersed");
  return mean.value_or(otherwise);
}

Widths read_widths(MaterialReader& reader, std::string_view prefix) {
  const auto read = [&](std::string_view suffix) {
    const std::string name = fmt::format("{}{}", prefix, suffix);
    auto width = reader.textures.scalar(reader.arguments, name);
    if (width && width->is_constant())
      width->factor = reader.arguments.clamped(name, width->factor, 0, 1);
    return width;
  };
  const ScalarInput both = read("roughness").value_or(ScalarInput{0.0, {}, 0, {}});
  const ScalarInput u = read("uroughness").value_or(both);
  const ScalarInput v = read("vroughness").value_or(both);
  const bool remaps = reader.arguments.flag("remaproughness", true);
  const bool is_same = u == v;
  Widths widths{width_of(reader, u, remaps), {}};
  const ScalarInput across = is_same ? widths.along : width_of(reader, v, remaps);
  if (!is_same) widths.across = across;
  const bool is_smooth = widths.along.is_constant() && across.is_constant() &&
                         std::max(widths.along.factor, across.factor) < smooth;
  if (is_smooth) widths = {ScalarInput{0.0, {}, 0, {}}, {}};
  return widths;
}

// By a reflectance r: n = 1 and k = 2 sqrt(r) / sqrt(1 - r), as pbrt has it.
std::array<Vec3d, 2> read_metal(MaterialReader& reader, std::string_view prefix) {
  const auto colour = [&](std::string_view name) -> std::optional<ColourInput> {
    return reader.textures.colour(reader.arguments, fmt::format("{}{}", prefix, name));
  };
  const auto copper = *metal_named("metal-Cu-eta");
  const auto constant = [&](const std::optional<ColourInput>& input, const Vec3d& otherwise) {
    if (!input) return otherwise;
    if (input->is_constant()) return input->factor;
    reader.context.warn_once("metal texture", reader.arguments.statement().place,
                             "metals of a colour by a texture are not supported: one colour is "
                             "used");
    return otherwise;
  };
  if (const auto metal = read_metal_spectra(reader, prefix)) return *metal;
  const auto eta = colour("eta");
  const auto k = colour("k");
  const auto reflectance = reader.textures.colour(reader.arguments, "reflectance");
  if (!reflectance) return {constant(eta, copper[0]), constant(k, copper[1])};
  if (eta || k)
    reader.arguments.warning(*reader.arguments.find("reflectance"),
                             "says how the metal reflects: its eta and k are ignored");
  const Vec3d r =
      glm::clamp(constant(reflectance, Vec3d(0.5)), Vec3d(0.0), Vec3d(largest_metal_reflectance));
  return {Vec3d(1.0), extinction_of_reflectance(r)};
}

std::size_t Materials::index_of(const MaterialUse& use) {
  if (use.name.empty()) return first_equal(use.index);
  const auto& named = context_.program.material_named;
  const auto found = named.find(use.name);
  if (found != named.end()) return found->second;
  if (context_.warned.insert("no material " + use.name).second)
    context_.report.error(use.place,
                          fmt::format("there is no material {}{}", text::quoted(use.name),
                                      context_.report.did_you_mean_key(use.name, named)));
  return grey;
}

std::size_t Materials::first_equal(std::size_t index) {
  if (index == grey) return grey;
  const auto known = first_equal_.find(index);
  if (known != first_equal_.end()) return known->second;
  const std::string text = text_of(context_.program.materials[index].statement);
  return first_equal_[index] = index_of_text_.try_emplace(text, index).first->second;
}

std::string Materials::text_of(const Statement& statement) const {
  std::string text = statement.type;
  for (const Parameter& parameter : statement.parameters) {
    const bool may_name_file =
        parameter.type == ParameterType::Spectrum || parameter.name == "normalmap";
    text += key_of(parameter, may_name_file, context_.scene.path);
  }
  return text;
}

const Material& Materials::of(const MaterialUse& use) {
  return at(index_of(use));
}

const Material& Materials::at(std::size_t index) {
  const auto known = made_.find(index);
  if (known != made_.end()) return known->second;
  if (index == grey) {
    Material& material = made_[grey];
    material.model = description::DiffuseMaterial{};
    material.name = "grey";
    return material;
  }
  in_progress_.insert(index);
  Made made = make(context_.program.materials[index]);
  in_progress_.erase(index);
  Material& material = made_[index] = std::move(made.material);
  if (made.parts) parts_[&material] = *made.parts;
  return material;
}

const MixParts* Materials::parts_of(const Material& material) const {
  const auto found = parts_.find(&material);
  return found == parts_.end() ? nullptr : &found->second;
}

void Materials::read_all() {
  for (std::size_t i = 0; i < context_.program.materials.size(); ++i)
    if (!context_.program.materials[i].name.empty() || first_equal(i) == i) (void)at(i);
}

// The type of a named material is a parameter.
Materials::Made Materials::make(MaterialStatement& statement) {
  Arguments arguments(statement.statement, context_.report);
  const auto named_type = statement.name.empty() ? arguments.string("type")
                                                 : arguments.type_of("material", statement.name);
  if (statement.statement.type.empty()) statement.statement.type = named_type.value_or("");
  const std::string& type = statement.statement.type;
  Material material;
  material.name = statement.name.empty() ? type : statement.name;
  material.span = statement.statement.place.span();
  material.model = description::DiffuseMaterial{};
  if (!statement.name.empty() && !named_type) return {material, {}};
  if (type == "mix" && !arguments.has("model")) {
    Made made = mix(arguments).value_or(Made{material, {}});
    made.material.name = material.name;
    made.material.span = material.span;
    return made;
  }
  MaterialReader reader{arguments, context_, textures_};
  if (!set_own_model(reader, material) && !set_model(reader, type, material) &&
      !set_v3_model(reader, type, material)) {
    if (!type.empty())
      context_.report.error(
          statement.statement.place,
          fmt::format("{} is no material{}", text::quoted(type),
                      nearest_or_all(type, {std::begin(type_names), std::end(type_names)})));
    return {material, {}};
  }
  add_own_parameters(reader, material);
  set_surface(arguments, material);
  arguments.warn_of_unknown();
  return {material, {}};
}

// Of pbrt's own parameters a map of normals stands in the place of heights.
void Materials::set_surface(Arguments& arguments, Material& material) {
  if (const auto normals = textures_.normal_map(arguments)) {
    material.normal_map = normals;
    material.normal_map_is_right_handed = !arguments.flag("normalsalongv", false);
  }
  if (material.normal_map && !arguments.has("heights"))
    arguments.ignore("displacement", "the material has a normalmap");
  else
    textures_.set_heights(arguments, material);
}

Materials::Made Materials::made(const Material& material) const {
  const MixParts* parts = parts_of(material);
  return {material, parts ? std::optional(*parts) : std::nullopt};
}

std::optional<Materials::Made> Materials::mix(Arguments& arguments) {
  const Statement& statement = arguments.statement();
  const Parameter* names = arguments.find("materials", {ParameterType::String});
  const bool is_v3 = !names && arguments.has("namedmaterial1");
  const ScalarInput amount = mix_amount(arguments, textures_, is_v3);
  std::array<MaterialUse, 2> uses;
  if (names && names->strings.size() == 2) {
    for (std::size_t i = 0; i < 2; ++i) uses[i] = {none, names->strings[i], names->place};
  } else if (is_v3) {  // where the amount is that of the first
    uses = {named_part(arguments, "namedmaterial2"), named_part(arguments, "namedmaterial1")};
  }
  arguments.warn_of_unknown();
  if (uses[0].name.empty() || uses[1].name.empty()) {
    if (!arguments.has_errors())
      context_.report.error(statement.place,
                            "a mix without its two materials: expected \"string materials\"");
    return std::nullopt;
  }
  const std::array<std::size_t, 2> parts{index_of(uses[0]), index_of(uses[1])};
  for (const std::size_t part : parts)
    if (in_progress_.contains(part) || in_progress_.size() > deepest)
      return refuse_depth(statement.place);
  const Material& first = at(parts[0]);
  return mixed(amount, first, at(parts[1]), statement.place);
}

std::nullopt_t Materials::refuse_depth(const Place& place) const {
  context_.report.error(
      place, fmt::format("mixtures of mixtures more than {} deep, or of themselves", deepest));
  return std::nullopt;
}

std::optional<Materials::Made> Materials::mixed(const ScalarInput& amount, const Material& first,
                                                const Material& second, const Place& place) {
  if (&first == &second || (amount.is_constant() && amount.factor <= 0)) return made(first);
  if (amount.is_constant() && amount.factor >= 1) return made(second);
  if (is_interface(first)) return with_hole(amount, second, place);
  if (is_interface(second)) return with_hole(textures_.complement(amount, place), first, place);
  if (has_holes(first) || has_holes(second))
    context_.warn_once("hole", place,
                       "an interface in a mixture within a mixture is not supported: there it is "
                       "as if it were not mixed in");
  const auto depth_of = [this](const Material& part) {
    const MixParts* within = parts_of(part);
    return within ? within->depth : 0;
  };
  const std::size_t depth = 1 + std::max(depth_of(first), depth_of(second));
  if (depth > deepest) return refuse_depth(place);
  Material material;
  material.model = description::MixMaterial{{}, {}, amount};
  return Made{material, MixParts{&first, &second, depth}};
}

// A part that is not there is a hole.
Materials::Made Materials::with_hole(const ScalarInput& opacity, const Material& material,
                                     const Place& place) {
  Made holey = made(material);
  if (is_interface(material)) return holey;
  ScalarInput& own = holey.material.opacity;
  if (!has_holes(material))
    own = opacity;
  else if (opacity.is_constant() && own.is_constant())
    own.factor *= opacity.factor;
  else
    context_.warn_once("hole", place,
                       "an interface in a mixture within a mixture is not supported: there it is "
                       "as if it were not mixed in");
  return holey;
}

}  // namespace candela::pbrt
