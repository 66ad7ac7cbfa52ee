// A pbrt scene as its directives leave it: what was declared, with the transforms and attributes
// that held at each place. Parsing fills it; build_scene() makes a SceneDescription of it, so that
// materials may name textures, and shapes materials, that follow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "renderer/math/transform.h"
#include "scene_io/pbrt/arguments.h"

namespace candela::pbrt {

inline constexpr std::size_t none = static_cast<std::size_t>(-1);

struct TextureStatement {
  Statement statement;
  Transform world_from_texture;
};

struct MaterialStatement {
  std::string name;  // empty where it has none
  Statement statement;
};

// The material in force: one of Program::materials, or one by name that may come later.
struct MaterialUse {
  std::size_t index = none;
  std::string name;
  Place place;
};

// A medium by its name; empty: none.
struct MediumUse {
  std::string name;
  Place place;
};

// MediumInterface: what is on both sides of a surface.
struct MediaUse {
  MediumUse inside;
  MediumUse outside;

  [[nodiscard]] bool is_transition() const { return inside.name != outside.name; }
};

struct LightStatement {
  Statement statement;
  Transform world_from_light;
};

struct ShapeStatement {
  Statement statement;
  Transform world_from_object;
  bool is_reversed = false;  // ReverseOrientation
  MaterialUse material;
  std::size_t area_light = none;  // of Program::area_lights
  MediaUse media;
};

struct ObjectUse {
  std::string name;
  Place place;
  Transform world_from_instance;
};

struct Program {
  std::optional<Statement> camera, film, sampler, integrator, filter;
  Transform camera_from_world;
  MediumUse around_camera;
  std::optional<std::uint64_t> seed;  // Option's
  std::map<std::string, TextureStatement> float_textures, spectrum_textures;
  std::vector<MaterialStatement> materials;
  std::map<std::string, std::size_t> material_named;
  std::map<std::string, Statement> media;
  std::vector<LightStatement> lights;
  std::vector<Statement> area_lights;
  std::deque<ShapeStatement> shapes;
  std::map<std::string, std::deque<ShapeStatement>> objects;
  std::vector<ObjectUse> object_uses;
  std::vector<std::string> files;  // all that were read
};

}  // namespace candela::pbrt
