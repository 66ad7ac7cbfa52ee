#include "scene_io/pbrt/write/write_shapes.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "renderer/math/constants.h"
#include "scene_io/pbrt/mesh_areas.h"
#include "scene_io/pbrt/textures.h"
#include "scene_io/pbrt/write/write_lights.h"
#include "scene_io/ply/write_ply.h"

namespace candela::pbrt {
namespace {

using description::Instance;
using description::Material;
using description::MaterialHandle;
using description::Mesh;
using description::MeshHandle;

// Triangles of a mesh that have one material.
struct Part {
  MeshHandle mesh;
  MaterialHandle material;
  std::vector<std::uint32_t> triangles;
  [[nodiscard]] bool is_whole(const Mesh& whole) const {
    return triangles.size() == whole.triangles.size();
  }
};

class ShapeWriter {
 public:
  ShapeWriter(WriteContext& context, TextureWriter& textures, MaterialWriter& materials,
              MediaWriter& media)
      : context_(context), textures_(textures), materials_(materials), media_(media) {}

  std::string write() {
    for (const Instance& instance : context_.scene.instances) ++uses_[use_of(instance)];
    std::string text;
    for (const Instance& instance : context_.scene.instances) text += placed(instance);
    return text;
  }

 private:
  using Use = std::pair<std::uint32_t, std::uint32_t>;             // mesh, material override
  using FileKey = std::tuple<std::uint32_t, std::uint32_t, bool>;  // mesh, material, has own uvs

  static Use use_of(const Instance& instance) {
    return {instance.mesh.index, instance.material_override.index};
  }
  [[nodiscard]] const Mesh& mesh_of(MeshHandle mesh) const {
    return context_.scene.meshes[mesh.index];
  }
  [[nodiscard]] const Material& material_of(const Part& part) const {
    return context_.scene.materials[part.material.index];
  }

  [[nodiscard]] std::vector<Part> parts_of(const Instance& instance) const {
    const Mesh& mesh = mesh_of(instance.mesh);
    if (mesh.sphere)
      return {{instance.mesh,
               instance.material_override ? instance.material_override : mesh.materials[0],
               {}}};
    const bool has_one = instance.material_override || mesh.materials.size() <= 1;
    std::map<std::uint32_t, Part> parts;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      MaterialHandle material = instance.material_override;
      if (!material)
        material = mesh.materials.empty() ? MaterialHandle(0) : mesh.materials[has_one ? 0 : i];
      Part& part = parts[material.index];
      part.mesh = instance.mesh;
      part.material = material;
      part.triangles.push_back(i);
    }
    std::vector<Part> list;
    for (auto& [index, part] : parts) list.push_back(std::move(part));
    return list;
  }

  [[nodiscard]] bool is_shared(const Instance& instance, const std::vector<Part>& parts) const {
    if (uses_.at(use_of(instance)) == 1) return false;
    return std::none_of(parts.begin(), parts.end(), [&](const Part& part) {
      const Material& material = material_of(part);
      return material.emission != Vec3d(0.0) || has_heights_by_uv(context_.scene, material);
    });
  }

  std::string placed(const Instance& instance) {
    const auto known = objects_.find(use_of(instance));
    if (known != objects_.end()) return object_instance(known->second, instance);
    const std::vector<Part> parts = parts_of(instance);
    if (!is_shared(instance, parts)) {
      std::string text;
      for (const Part& part : parts) text += shape(part, instance.object_to_world);
      return text;
    }
    const std::string name = context_.unique_name("object", stem_of(mesh_of(instance.mesh).name));
    objects_[use_of(instance)] = name;
    std::string text = "ObjectBegin " + in_quotes(name) + "\n";
    for (const Part& part : parts) text += shape(part, Transform());
    return text + "ObjectEnd\n" + object_instance(name, instance);
  }

  static std::string object_instance(const std::string& name, const Instance& instance) {
    return "AttributeBegin\n" + transform(instance.object_to_world) + "  ObjectInstance " +
           in_quotes(name) + "\nAttributeEnd\n";
  }

  static std::string transform(const Transform& object_to_world) {
    if (object_to_world.is_identity()) return "";
    return "  Transform " + matrix_text(object_to_world) + "\n";
  }

  std::string shape(const Part& part, const Transform& object_to_world) {
    const Material& material = material_of(part);
    std::string text = "AttributeBegin\n" + transform(object_to_world);
    const double unit = has_heights_by_uv(context_.scene, material)
                            ? 1 / height_scale_of(part, object_to_world)
                            : 1;
    text += "  NamedMaterial " + in_quotes(materials_.name_of(part.material, unit)) + "\n";
    const std::string media = media_.interface_of(material.media);
    if (!media.empty()) text += "  " + media;
    if (material.emission != Vec3d(0.0)) text += "  " + emission(part, object_to_world);
    warn_of_turned_normals(part, object_to_world);
    Directive out = shape_of(part, text);
    materials_.add_alpha(material, out);
    return text + out.text("  ") + "AttributeEnd\n";
  }

  // pbrt's maps of normals run across dp/du, lab3's along dp/dv: not the same way where coordinates
  // are mirrored.
  void warn_of_turned_normals(const Part& part, const Transform& object_to_world) {
    const Material& material = material_of(part);
    const Mesh& mesh = mesh_of(part.mesh);
    if (!material.normal_map || material.normal_map_is_right_handed || mesh.uvs.empty()) return;
    const bool is_turned = object_to_world.determinant() < 0;
    const auto is_mirrored = [&](std::uint32_t triangle) {
      const auto& [a, b, c] = mesh.triangles[triangle];
      const Vec2f along = mesh.uvs[b] - mesh.uvs[a], across = mesh.uvs[c] - mesh.uvs[a];
      return (along.x * across.y - along.y * across.x < 0) != is_turned;
    };
    if (std::ranges::none_of(part.triangles, is_mirrored)) return;
    if (!turned_.insert(part.material.index).second) return;
    context_.warn(
        material.span,
        fmt::format("material '{}': lost for pbrt: which way its map of normals runs where "
                    "texture coordinates are mirrored",
                    material.name));
  }

  // `text`: what stands before it.
  Directive shape_of(const Part& part, std::string& text) {
    const std::optional<description::Sphere>& sphere = mesh_of(part.mesh).sphere;
    Directive out("Shape", sphere ? "sphere" : "plymesh");
    if (!sphere) {
      out.add("string filename", file(part));
      return out;
    }
    if (sphere->faces_inwards) text += "  ReverseOrientation\n";
    out.add("float radius", sphere->radius);
    return out;
  }

  // pbrt takes no colour beside an image; by power it takes the image's mean.
  std::string emission(const Part& part, const Transform& object_to_world) {
    const Material& material = material_of(part);
    const std::string image = material.emission_map ? textures_.file_of(material.emission_map) : "";
    if (image.empty()) return area_light(material.emission, material.emits_both_sides);
    const Vec3d& colour = material.emission;
    const bool is_coloured = colour != Vec3d(colour.x);
    const double mean = is_coloured ? (colour.x + colour.y + colour.z) / 3 : colour.x;
    if (is_coloured)
      context_.warn(material.span, fmt::format("material '{}': lost for pbrt: the colour that the "
                                               "image of what it emits is multiplied by",
                                               material.name));
    Directive out("AreaLightSource", "diffuse");
    out.add("string filename", image);
    if (material.emission_is_maps_mean) {
      const Areas areas = areas_of_part(part, object_to_world);
      const double sides = material.emits_both_sides ? 2 : 1;
      const double triangle = areas.surface / static_cast<double>(areas.triangle_count);
      out.add("float power", mean * triangle * pi_double * sides);
    } else {
      out.add("float scale", mean);
    }
    if (material.emits_both_sides) out.add("bool twosided", true);
    if (is_coloured) out.add_own("rgb L", material.emission);
    add_wrap(part, out);
    return out.text();
  }

  // pbrt's images of lamps end at their edges.
  void add_wrap(const Part& part, Directive& out) {
    const Material& material = material_of(part);
    const description::Wrap wrap = context_.scene.images[material.emission_map.index].wrap;
    if (wrap == description::Wrap::Clamp) return;
    out.add_own("string wrap", std::string(name_of(wrap)));
    if (looks_beyond_image(part))
      context_.warn(material.span,
                    fmt::format("material '{}': lost for pbrt: how the image of what "
                                "it emits goes on beyond its edges",
                                material.name));
  }

  [[nodiscard]] bool looks_beyond_image(const Part& part) const {
    const Mesh& mesh = mesh_of(part.mesh);
    if (mesh.uvs.empty()) return false;
    const auto is_beyond = [](const Vec2f& uv) {
      return std::min(uv.x, uv.y) < 0 || std::max(uv.x, uv.y) > 1;
    };
    return std::ranges::any_of(part.triangles, [&](std::uint32_t triangle) {
      return std::ranges::any_of(mesh.triangles[triangle],
                                 [&](std::uint32_t vertex) { return is_beyond(mesh.uvs[vertex]); });
    });
  }

  [[nodiscard]] double height_scale_of(const Part& part, const Transform& object_to_world) const {
    return height_scale(areas_of_part(part, object_to_world));
  }

  [[nodiscard]] Areas areas_of_part(const Part& part, const Transform& object_to_world) const {
    const Mesh& mesh = mesh_of(part.mesh);
    return mesh.sphere ? areas_of(mesh, object_to_world)
                       : areas_of(mesh, part.triangles, object_to_world);
  }

  // Textures need coordinates: where a mesh has none, candela looks at the middle of the square.
  std::string file(const Part& part) {
    const Mesh& mesh = mesh_of(part.mesh);
    const bool needs_uvs = mesh.uvs.empty() && is_textured(context_.scene, material_of(part));
    const std::uint32_t material = part.is_whole(mesh) ? MaterialHandle::none : part.material.index;
    const auto [at, is_new] = files_.try_emplace({part.mesh.index, material, needs_uvs});
    if (!is_new) return at->second;
    const std::string wish = stem_of(mesh.name) + ".ply";
    at->second = context_.options.folder + "/" + context_.unique_name("file", wish);
    ply::WriteOptions options;
    if (needs_uvs) options.missing_uv = Vec2f(0.5f);
    context_.written.meshes.push_back({at->second, ply::write_ply(mesh, part.triangles, options)});
    return at->second;
  }

  WriteContext& context_;
  TextureWriter& textures_;
  MaterialWriter& materials_;
  MediaWriter& media_;
  std::map<Use, std::size_t> uses_;
  std::map<Use, std::string> objects_;
  std::map<FileKey, std::string> files_;
  std::set<std::uint32_t> turned_;  // materials that it was said of
};

}  // namespace

std::string write_shapes(WriteContext& context, TextureWriter& textures, MaterialWriter& materials,
                         MediaWriter& media) {
  return ShapeWriter(context, textures, materials, media).write();
}

}  // namespace candela::pbrt
