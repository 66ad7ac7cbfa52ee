#include "scene_io/pbrt/shape.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "scene_io/pbrt/parameter_key.h"
#include "scene_io/pbrt/shape_kinds.h"

namespace candela::pbrt {
namespace {

using description::Mesh;

constexpr std::array<std::string_view, 7> kinds{"trianglemesh", "plymesh",      "sphere",    "disk",
                                                "cylinder",     "bilinearmesh", "loopsubdiv"};

MaybeMesh mesh_of(Arguments& arguments, const ShapeOptions& options) {
  const std::string& type = arguments.statement().type;
  if (type == "trianglemesh") return triangle_mesh(arguments);
  if (type == "plymesh") return ply_mesh(arguments, options);
  if (type == "sphere") return sphere(arguments, options);
  if (type == "disk") return disk(arguments, options);
  if (type == "cylinder") return cylinder(arguments, options);
  if (type == "bilinearmesh") return bilinear_mesh(arguments, options);
  if (type == "loopsubdiv") return loop_subdivision(arguments);
  return std::nullopt;
}

bool is_known_to_pbrt(std::string_view type) {
  static constexpr std::array<std::string_view, 7> others{
      "curve", "cone", "paraboloid", "hyperboloid", "heightfield", "heightfield2", "nurbs"};
  return std::find(others.begin(), others.end(), type) != others.end();
}

bool is_finite_mesh(const Mesh& mesh) {
  return std::all_of(mesh.positions.begin(), mesh.positions.end(),
                     [](const Vec3d& p) { return is_finite(p); });
}

void refuse(const ShapeStatement& shape, const Report& report) {
  const std::string& type = shape.statement.type;
  if (is_known_to_pbrt(type))
    return report.warning(
        shape.statement.place,
        fmt::format("a shape of type {} is not supported and left out", text::quoted(type)));
  report.error(shape.statement.place,
               fmt::format("{} is no shape{}", text::quoted(type),
                           nearest_or_all(type, {kinds.begin(), kinds.end()})));
}

bool has_texture(const Program& program, const MaterialUse& use) {
  std::size_t index = use.index;
  if (!use.name.empty()) {
    const auto found = program.material_named.find(use.name);
    index = found == program.material_named.end() ? none : found->second;
  }
  if (index == none) return false;
  const ParameterList& parameters = program.materials[index].statement.parameters;
  return std::any_of(parameters.begin(), parameters.end(), [](const Parameter& parameter) {
    return parameter.type == ParameterType::Texture || parameter.name == "materials" ||
           parameter.name.starts_with("namedmaterial") || parameter.name == "normalmap" ||
           parameter.name.ends_with("uroughness") || parameter.name.ends_with("vroughness");
  });
}

}  // namespace

bool has_texture(const Program& program, const ShapeStatement& shape) {
  const auto has = [](const ParameterList& parameters, auto&& is_texture) {
    return std::any_of(parameters.begin(), parameters.end(), is_texture);
  };
  const bool emits_image =
      shape.area_light != none &&
      has(program.area_lights[shape.area_light].parameters,
          [](const Parameter& parameter) { return parameter.name == "filename"; });
  return emits_image || has_texture(program, shape.material) ||
         has(shape.statement.parameters,
             [](const Parameter& parameter) { return parameter.type == ParameterType::Texture; });
}

bool is_curved(const ShapeStatement& shape) {
  const std::string& type = shape.statement.type;
  return type == "sphere" || type == "disk" || type == "cylinder";
}

bool is_whole_sphere(const ShapeStatement& shape) {
  const ParameterList& parameters = shape.statement.parameters;
  return shape.statement.type == "sphere" &&
         std::none_of(parameters.begin(), parameters.end(), [](const Parameter& parameter) {
           return parameter.name == "zmin" || parameter.name == "zmax" ||
                  parameter.name == "phimax";
         });
}

// A sphere has the square of its segments in triangles: half as many rows, two triangles a cell. A
// patch has the 32nd part of that.
std::uint32_t segments_for(std::size_t curved_shapes, std::size_t curved_patches) {
  const double spheres =
      static_cast<double>(curved_shapes) + static_cast<double>(curved_patches) / 32;
  const double most = 8e6 / std::max(spheres, 1.0);
  return static_cast<std::uint32_t>(std::clamp(std::sqrt(most), 12.0, double{finest_segments}));
}

std::uint32_t patch_cells_for(std::uint32_t segments) {
  return std::max(segments / 8, 1u);
}

std::string mesh_key(const ShapeStatement& shape, const ShapeOptions& options) {
  const Statement& statement = shape.statement;
  const bool keeps_sphere = statement.type == "sphere" && options.keeps_spheres;
  std::string key = fmt::format("{} {} {} {}", statement.type, shape.is_reversed, options.needs_uvs,
                                keeps_sphere);
  for (const Parameter& parameter : statement.parameters) {
    if (parameter.name == "alpha") continue;
    if (parameter.numbers.size() > 4) return "";  // a mesh written out
    key += key_of(parameter, parameter.name == "filename", options.scene_path);
  }
  return key;
}

MaybeMesh make_mesh(ShapeStatement& shape, const ShapeOptions& options, const Report& report) {
  Arguments arguments(shape.statement, report);
  if (std::find(kinds.begin(), kinds.end(), shape.statement.type) == kinds.end()) {
    refuse(shape, report);
    return std::nullopt;
  }
  arguments.accept({"alpha"});
  arguments.ignore("shadowalpha", "shadows are those of \"alpha\"");  // pbrt-v3
  MaybeMesh made = mesh_of(arguments, options);
  arguments.warn_of_unknown();
  if (!made) return std::nullopt;
  Mesh& mesh = made->mesh;
  if (mesh.name.empty()) mesh.name = shape.statement.type;
  mesh.span = shape.statement.place.span();
  if (!is_finite_mesh(mesh)) {
    report.error(shape.statement.place, "this shape has positions that are not finite");
    return std::nullopt;
  }
  if (mesh.sphere) {
    mesh.sphere->faces_inwards = shape.is_reversed;
    return made;
  }
  if (mesh.triangles.empty()) {
    report.warning(shape.statement.place, "this shape has no area: it is left out");
    return std::nullopt;
  }
  // By the order of the corners as written.
  if (options.needs_uvs && mesh.uvs.empty()) add_default_uvs(mesh);
  orient(mesh, shape.is_reversed);
  return made;
}

void orient(Mesh& mesh, bool is_reversed) {
  if (is_reversed)
    for (Vec3f& normal : mesh.normals) normal = -normal;
  for (auto& [a, b, c] : mesh.triangles) {
    bool is_against = is_reversed;
    if (!mesh.normals.empty()) {
      const Vec3d face =
          cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
      const double side =
          dot(face, Vec3d(mesh.normals[a]) + Vec3d(mesh.normals[b]) + Vec3d(mesh.normals[c]));
      if (side != 0) is_against = side < 0;
    }
    if (is_against) std::swap(b, c);
  }
}

void add_default_uvs(Mesh& mesh) {
  static constexpr std::array<Vec2f, 3> corner_uvs{Vec2f(0, 0), Vec2f(1, 0), Vec2f(1, 1)};
  Mesh split;
  split.name = mesh.name;
  split.span = mesh.span;
  for (const auto& triangle : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(split.positions.size());
    for (std::size_t k = 0; k < 3; ++k) {
      split.positions.push_back(mesh.positions[triangle[k]]);
      if (!mesh.normals.empty()) split.normals.push_back(mesh.normals[triangle[k]]);
      split.uvs.push_back(corner_uvs[k]);
    }
    split.triangles.push_back({first, first + 1, first + 2});
  }
  mesh = std::move(split);
}

}  // namespace candela::pbrt
