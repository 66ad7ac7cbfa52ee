#include "renderer/scene/compile_lights.h"

#include <map>
#include <tuple>

#include "renderer/light/build_environment.h"

namespace candela {
namespace {

using description::SceneDescription;
using description::TriangleLight;

// Triangle lights of one kind share a material.
using SurfaceKind = std::tuple<double, double, double, bool>;

SurfaceKind kind_of(const TriangleLight& light) {
  return {light.radiance.x, light.radiance.y, light.radiance.z, light.emits_both_sides};
}

description::Material black_emitter(const TriangleLight& light, const SourceSpan& span) {
  description::Material material;
  material.name = "area light";
  material.span = span;
  material.model = description::DiffuseMaterial{{Vec3d(0.0), {}}};
  material.emission = light.radiance;
  material.emits_both_sides = light.emits_both_sides;
  return material;
}

Vec3f to_normalised(const Normalisation& n, const Vec3d& p) {
  return Vec3f((p - n.centre) * n.scale);
}

// Radiant intensity has a squared length in it: irradiance at the same place must stay the same.
Rgb scaled_intensity(const Normalisation& n, const Vec3d& intensity) {
  return Rgb(intensity * (n.scale * n.scale));
}

struct LightCompiler {
  const Normalisation& normalisation;
  Light& out;

  bool operator()(const description::PointLight& light) const {
    out.kind = LightKind::Point;
    out.position = to_normalised(normalisation, light.position);
    out.emission = scaled_intensity(normalisation, light.intensity);
    return true;
  }
  bool operator()(const description::SpotLight& light) const {
    out.kind = LightKind::Spot;
    out.position = to_normalised(normalisation, light.position);
    out.edge1 = Vec3f(normalize(light.axis));
    out.emission = scaled_intensity(normalisation, light.intensity);
    out.cos_inner = static_cast<float>(std::cos(light.inner_angle_radians));
    out.cos_outer = static_cast<float>(std::cos(light.outer_angle_radians));
    return true;
  }
  bool operator()(const description::DirectionalLight& light) const {
    out.kind = LightKind::Directional;
    out.position = Vec3f(normalize(light.to_light));
    out.emission = Rgb(light.irradiance);
    return true;
  }
  // Triangles have become surfaces; environments are compiled apart.
  bool operator()(const TriangleLight&) const { return false; }
  bool operator()(const description::ConstantEnvironment&) const { return false; }
  bool operator()(const description::CubeEnvironment&) const { return false; }
  bool operator()(const description::LatLongEnvironment&) const { return false; }
};

void add_delta_lights(const SceneDescription& description, Scene& scene, DropCounts& dropped) {
  for (const description::Light& light : description.lights) {
    Light out;
    if (!std::visit(LightCompiler{scene.normalisation, out}, light.kind)) continue;
    if (is_black(out.emission)) {
      ++dropped["black lights"];
      continue;
    }
    scene.lights.push_back(out);
  }
}

Light triangle_light(const Geometry& geometry, const Material& material,
                     std::uint32_t geometry_index, std::uint32_t triangle) {
  const auto& t = geometry.triangles[triangle];
  Light light;
  light.kind = LightKind::Triangle;
  light.emits_both_sides = material.emits_both_sides;
  light.position = geometry.positions[t[0]];
  light.edge1 = geometry.positions[t[1]] - light.position;
  light.edge2 = geometry.positions[t[2]] - light.position;
  light.emission = material.emission;
  light.area = 0.5f * length(cross(light.edge1, light.edge2));
  light.geometry = geometry_index;
  light.triangle = triangle;
  return light;
}

void add_triangle_lights(Scene& scene) {
  for (std::size_t g = 0; g < scene.geometries.size(); ++g) {
    Geometry& geometry = scene.geometries[g];
    const Material& material = scene.materials[geometry.material.index];
    if (!material.is_emissive()) continue;
    geometry.first_light = static_cast<std::uint32_t>(scene.lights.size());
    for (std::size_t i = 0; i < geometry.triangles.size(); ++i)
      scene.lights.push_back(triangle_light(geometry, material, static_cast<std::uint32_t>(g),
                                            static_cast<std::uint32_t>(i)));
  }
}

void add_environment(const SceneDescription& description, Scene& scene, DropCounts& dropped,
                     Diagnostics& diagnostics) {
  for (const description::Light& light : description.lights) {
    std::optional<Environment> environment =
        build_environment(description, light, scene.textures, diagnostics);
    if (!environment) continue;
    if (is_black_environment(*environment)) {
      ++dropped["black lights"];
      continue;
    }
    if (scene.environment) {
      diagnostics.warning(light.span, "a second environment light is ignored: one is the most");
      continue;
    }
    scene.environment = std::move(environment);
    Light out;
    out.kind = LightKind::Environment;
    scene.lights.push_back(out);
  }
}

}  // namespace

void add_triangle_light_surfaces(SceneDescription& description) {
  std::map<SurfaceKind, std::size_t> meshes;
  for (const description::Light& light : description.lights) {
    const auto* triangle = std::get_if<TriangleLight>(&light.kind);
    if (triangle == nullptr) continue;
    const auto [at, is_new] = meshes.try_emplace(kind_of(*triangle), description.meshes.size());
    if (is_new) {
      description::Mesh mesh;
      mesh.name = "area light";
      mesh.materials.emplace_back(description.materials.size());
      description.materials.push_back(black_emitter(*triangle, light.span));
      description.instances.push_back(
          {description::MeshHandle(description.meshes.size()), {}, {}, light.span});
      description.meshes.push_back(std::move(mesh));
    }
    description::Mesh& mesh = description.meshes[at->second];
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), triangle->vertices.begin(),
                          triangle->vertices.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
}

void compile_lights(const SceneDescription& description, Scene& scene, DropCounts& dropped,
                    Diagnostics& diagnostics) {
  add_delta_lights(description, scene, dropped);
  add_triangle_lights(scene);
  add_environment(description, scene, dropped, diagnostics);
  scene.light_sampler = LightSampler(scene.lights, scene.environment, scene.bounds);
}

}  // namespace candela
