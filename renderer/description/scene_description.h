// The scene as written: in double, in the file's units, with names and source spans.
// Readers (scene_io) fill it; compile() (renderer/scene) turns it into what is rendered.
// Nothing here knows a file format, and nothing here was rounded, merged or dropped.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "renderer/base/diagnostic.h"
#include "renderer/base/handle.h"
#include "renderer/description/texture_description.h"
#include "renderer/math/transform.h"
#include "renderer/math/vec.h"

namespace candela::description {

struct Material;
struct Medium;
struct Mesh;
using MaterialHandle = Handle<Material>;
using MediumHandle = Handle<Medium>;
using MeshHandle = Handle<Mesh>;

// --- materials ---

// lab3's Blinn-Phong material (docs/scene_format.md, "Materials"); `whitted` shades it as it
// stands, the path tracer by "What lab 3 scenes mean to the path tracer" of that page. Colours are
// as written (before pow 2.2).
struct LabMaterial {
  ColourInput diffuse;                   // image encoding LabGamma
  double alpha = 1.0;                    // used where there is no diffuse map; else the map's alpha
  ColourInput specular{Vec3d{0.0}, {}};  // image encoding Linear; RGBA: alpha * 256 is the exponent
  double shininess = 0.0;                // exponent (0..256) where there is no specular map
};

enum class FresnelModel : std::uint8_t { Schlick, Exact };
enum class GeometryModel : std::uint8_t { SchlickGgx, Smith };

// kd/pi + ks F G D / (4 cos cos), as docs/scene_format.md has it ("Materials with a Type").
struct CookTorranceMaterial {
  ColourInput diffuse{Vec3d{0.5}, {}};        // kd
  ColourInput specular{Vec3d{0.5}, {}};       // ks
  ScalarInput roughness{0.3, {}, 0};          // the GGX width a itself
  Vec3d f0{0.04};                             // reflectance at normal incidence
  std::optional<double> ior;                  // gives f0 and the exact dielectric Fresnel term
  std::optional<std::array<Vec3d, 2>> eta_k;  // conductor: gives f0 and the exact conductor term
  FresnelModel fresnel = FresnelModel::Schlick;
  GeometryModel geometry = GeometryModel::SchlickGgx;
  bool energy_compensation = false;  // the light of multiple bounces too; Smith's geometry only
};

struct DiffuseMaterial {
  ColourInput reflectance{Vec3d{0.5}, {}};
};

struct MirrorMaterial {
  ColourInput reflectance{Vec3d{1.0}, {}};
};

struct ConductorMaterial {
  Vec3d eta{0.2, 0.92, 1.1};
  Vec3d k{3.9, 2.45, 2.14};
  ScalarInput roughness{0.0, {}, 0};  // GGX width; 0 is a mirror
  bool energy_compensation = false;   // as for CookTorrance
  // The width along dp/dv; then `roughness` is that along dp/du. Without energy_compensation.
  std::optional<ScalarInput> roughness_across = {};
  // At normal incidence, in place of eta and k: that of n = 1 and k = 2 sqrt(r / (1 - r)).
  std::optional<ColourInput> reflectance = {};
};

struct DielectricMaterial {
  double ior = 1.5;
  ScalarInput roughness{0.0, {}, 0};                 // GGX width; 0 is smooth
  Vec3d transmittance{1.0};                          // factor of each refraction (MTL's Tf)
  bool is_thin = false;                              // straight through, both interfaces at once
  std::optional<ScalarInput> roughness_across = {};  // as for Conductor
};

// A dielectric layer over a surface, alike from both sides. What is between the coat's interface
// and the surface absorbs exp(-thickness / cosine) of the light a crossing, and scatters none.
struct Coat {
  double ior = 1.5;
  ScalarInput roughness{0.0, {}, 0};                 // GGX width; 0 is smooth
  std::optional<ScalarInput> roughness_across = {};  // as for Conductor
  double thickness = 0.01;                           // optical
  // Interfaces that light meets within the coat, at most; 0: no limit. An even number 2 n lets
  // light leave the surface n times.
  int max_depth = 0;
};
struct CoatedDiffuseMaterial {
  ColourInput reflectance{Vec3d{0.5}, {}};
  Coat coat;
};
struct CoatedConductorMaterial {
  Vec3d eta{0.2, 0.92, 1.1};  // against vacuum, as k
  Vec3d k{3.9, 2.45, 2.14};
  ScalarInput roughness{0.0, {}, 0};  // of the metal
  std::optional<ScalarInput> roughness_across = {};
  Coat coat;
};

// Lambert's on both sides: reflectance + transmittance at most 1.
struct DiffuseTransmissionMaterial {
  ColourInput reflectance{Vec3d{0.25}, {}};
  ColourInput transmittance{Vec3d{0.25}, {}};
};

// Nothing is there: rays go straight on. It bounds a medium, or nothing.
struct InterfaceMaterial {};

// At each hit one of two materials that stand before this one in the list: the second with the
// probability `amount`. What they emit and how much they cover does not count, what this one does.
// No interfaces: a part that is not there is a matter of `opacity`.
struct MixMaterial {
  MaterialHandle first, second;
  ScalarInput amount{0.5, {}, 0};
};

// --- media ---

// What fills space, everywhere alike: coefficients a unit of the file's length.
struct Medium {
  std::string name;
  SourceSpan span;
  Vec3d absorption{0.0};   // sigma_a
  Vec3d scattering{0.0};   // sigma_s
  double asymmetry = 0.0;  // g, the mean cosine of scattering [Henyey41]; in (-1, 1)
};

// The media on both sides of a surface; invalid: none. Where they differ, light that leaves the
// surface is in the medium of its side from there on; where not, it stays in what it was in.
struct MediumInterface {
  MediumHandle inside;  // where the geometric normal does not point
  MediumHandle outside;
};

struct Material {
  std::string name;
  SourceSpan span;
  std::variant<LabMaterial, CookTorranceMaterial, DiffuseMaterial, MirrorMaterial,
               ConductorMaterial, DielectricMaterial, CoatedDiffuseMaterial,
               CoatedConductorMaterial, DiffuseTransmissionMaterial, InterfaceMaterial, MixMaterial>
      model;
  Vec3d emission{0.0};  // radiance; the geometric normal's side, or both
  bool emits_both_sides = false;
  ImageHandle emission_map{};          // a factor of the emission by place
  bool emission_is_maps_mean = false;  // white emission is the radiance where the map is as bright
                                       // as its texels' mean luminance
  ScalarInput opacity{1.0, {}, 0};     // coverage in [0,1]: the probability of a hit
  ImageHandle height;                  // bump map: grey heights
  TextureHandle height_texture{};      // the same by a texture
  // Height of white: a length in the world, or in units of the uv square's edge on the surface.
  double height_scale = 1.0;
  bool heights_are_lengths = false;
  ImageHandle normal_map;  // tangent-space normals, encoded (n+1)/2
  // Its y is n x dp/du, as pbrt has it, even where the uv map is mirrored; else it runs along v.
  bool normal_map_is_right_handed = false;
  MediumInterface media{};
};

// A whole sphere about the origin. Its texture coordinates are pbrt's: u around +z from +x on, v
// from -z to +z.
struct Sphere {
  double radius = 1.0;
  bool faces_inwards = false;  // its geometric normal
};

// An indexed triangle mesh, or a sphere. `normals` and `uvs` are empty or as many as `positions`.
struct Mesh {
  std::string name;
  SourceSpan span;
  std::vector<Vec3d> positions;
  std::vector<Vec3f> normals;  // any length; zero means "none here"
  std::vector<Vec2f> uvs;      // v = 0 is the image's bottom row
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<MaterialHandle> materials;  // size 1: one for all; else one a triangle
  // In place of vertices and triangles. Placed by similarities only (math/transform.h).
  std::optional<Sphere> sphere = {};
};

// A mesh placed in the world. Several instances may share a mesh.
struct Instance {
  MeshHandle mesh;
  Transform object_to_world;
  MaterialHandle material_override;  // invalid: the mesh's own
  SourceSpan span;
};

// For the path tracer, in physical units (docs/scene_format.md); whitted divides by pi again.
struct PointLight {
  Vec3d position{0.0};
  Vec3d intensity{1.0};  // radiant intensity, W/sr
};
struct SpotLight {
  Vec3d position{0.0};
  Vec3d axis{0.0, 0.0, -1.0};        // unit, from the light outwards
  Vec3d intensity{1.0};              // on the axis
  double inner_angle_radians = 0.0;  // full within, smooth to 0 at the outer angle
  double outer_angle_radians = 0.0;
};
// A point whose intensity an image says by direction. Of the map's axes in the world only the
// directions count; they stand at right angles.
struct GoniometricLight {
  Vec3d position{0.0};
  Vec3d intensity{1.0};  // times the image, if there is one
  ImageHandle image;     // of equal areas, as EqualAreaEnvironment's
  Mat3d world_from_map{1.0};
  std::optional<double> power = {};  // flux by luminance of white intensity, in place of its size
};
// A point that projects an image along the map's +z, its right side towards +x and its upper
// towards +y.
struct ProjectionLight {
  Vec3d position{0.0};
  Vec3d intensity{1.0};  // times the image
  ImageHandle image;
  Mat3d world_from_map{1.0};
  double angle_degrees = 90.0;  // of the image's shorter side
  std::optional<double> power = {};
};
struct DirectionalLight {
  Vec3d to_light{0.0, 1.0, 0.0};  // unit
  Vec3d irradiance{1.0};          // on a surface that faces it
};
// A triangle that emits but may have no counterpart among the meshes: it is a surface of its own.
struct TriangleLight {
  std::array<Vec3d, 3> vertices{};
  Vec3d radiance{1.0};
  bool emits_both_sides = false;  // else on the side of (v1-v0) x (v2-v0)
};
struct ConstantEnvironment {
  Vec3d radiance{0.0};
  bool is_seen_by_camera = true;  // false: lab3's ambient term
};
// Six square faces in the order +X -X +Y -Y +Z -Z, each as OpenGL's cube maps lay them.
struct CubeEnvironment {
  std::array<ImageHandle, 6> faces;
};
// Latitude-longitude; row 0 is +y, the centre column looks along `world_from_map` * -z.
struct LatLongEnvironment {
  ImageHandle image;
  Vec3d scale{1.0};
  Mat3d world_from_map{1.0};
  bool is_seen_by_camera = true;
};

// A square of equal areas, an octahedron unfolded [Clarberg08]: its centre is +z of the map, its
// corners -z; +x is the middle of the right edge, +y of the bottom edge (rows count from the top).
struct EqualAreaEnvironment {
  ImageHandle image;
  Vec3d scale{1.0};
  Mat3d world_from_map{1.0};
  bool is_seen_by_camera = true;
};

struct Light {
  SourceSpan span;
  std::variant<PointLight, SpotLight, GoniometricLight, ProjectionLight, DirectionalLight,
               TriangleLight, ConstantEnvironment, CubeEnvironment, LatLongEnvironment,
               EqualAreaEnvironment>
      kind;
};

enum class CameraKind : std::uint8_t {
  Perspective,
  Orthographic,  // rays along the line of sight
  LatLong,       // every direction: the top row is `up`, the centre column holds the line of sight
  EqualArea,     // every direction, as EqualAreaEnvironment: +x is right, +y forward, +z up
};

// What of the image plane the picture shows, from left to right and from bottom to top. Units are
// tan(fov / 2) at distance 1 for Perspective, those of the file for Orthographic.
struct ScreenWindow {
  double left = -1, right = 1, bottom = -1, top = 1;
};

struct Camera {
  SourceSpan span;
  CameraKind kind = CameraKind::Perspective;
  Vec3d eye{0.0, 0.0, 1.0};
  Vec3d target{0.0};
  Vec3d up{0.0, 1.0, 0.0};
  bool is_mirrored = false;    // right is up x look, not look x up
  double fovy_degrees = 60.0;  // vertical, or of the shorter side of the picture
  bool fov_is_of_shorter_side = false;
  // Absent: [-1, 1] along the side that the angle of view is of, and in proportion along the other.
  std::optional<ScreenWindow> screen_window;
  double lens_radius = 0.0;     // 0: pinhole
  double focus_distance = 0.0;  // along the axis; 0: at the target
  MediumHandle medium{};        // around it
};

// A part of the picture, in shares of its width and height from the top left.
struct CropWindow {
  double left = 0, right = 1, top = 0, bottom = 1;
};

// What the scene asks for; the command line overrides.
struct RenderDefaults {
  static constexpr std::int64_t largest_side = 65536;
  static constexpr std::int64_t most_samples = std::int64_t{1} << 30;
  static constexpr std::int64_t deepest = 1000000;  // of max_depth
  static constexpr double widest_filter = 32;       // its radius in pixels

  std::optional<int> width, height, samples_per_pixel, max_depth;
  std::optional<std::string> integrator, filter;
  std::optional<double> filter_radius;  // in pixels
  std::optional<CropWindow> crop;
  std::optional<std::uint64_t> seed;
  std::optional<double> exposure;
  // Kelvins of the daylight that the film shows as white; none: colours stay as they are.
  std::optional<double> white_balance_kelvins;
};

struct SceneDescription {
  std::string path;  // the scene file, as given
  std::vector<Image> images;
  std::vector<Texture> textures;
  std::vector<Medium> media;
  std::vector<Material> materials;
  std::vector<Mesh> meshes;
  std::vector<Instance> instances;
  std::vector<Light> lights;
  std::vector<Camera> cameras;
  RenderDefaults defaults;
  std::optional<Vec3d> lab_ambient;  // AmbientIntensity, for whitted and raster, where it is given
  std::vector<std::string> files;    // every file that was read, for scene_hash; images are
                                     // listed in `images`
};

}  // namespace candela::description
