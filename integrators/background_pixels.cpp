#include "integrators/background_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "integrators/path/context.h"
#include "integrators/projected_bounds.h"
#include "renderer/accel/placement.h"
#include "renderer/geometry/geometry_bounds.h"

namespace candela {
namespace {

// What the camera sees where there is nothing, if that is the same everywhere.
std::optional<Rgb> constant_background(const Scene& scene, const RenderOptions& options) {
  if (!scene.environment || options.transparent) return Rgb(0);
  const Environment& environment = *scene.environment;
  if (!environment.is_seen_by_camera) return Rgb(0);
  if (!environment.is_constant()) return {};
  return environment.scale;
}

bool has_projection(const Camera& camera) {
  const bool is_flat =
      camera.kind == CameraKind::Perspective || camera.kind == CameraKind::Orthographic;
  return is_flat && camera.lens_radius == 0;
}

// Boxes, of instances and spheres, count as what they consist of.
std::size_t triangle_count(const Scene& scene) {
  std::size_t count = 0;
  for (const GeometryHandle handle : scene.world.geometries)
    count += scene.geometries[handle.index].triangles.size() +
             12 * scene.geometries[handle.index].spheres.size();
  return count + 12 * scene.instances.size();
}

// A look at a triangle takes about as long as a few samples' rays.
bool is_worth_it(const Scene& scene, const RenderOptions& options) {
  constexpr double fewest_samples = 16;  // a triangle
  const PixelRect rect = rendered_rect(options);
  const double samples =
      static_cast<double>(rect.width()) * rect.height() * options.samples_per_pixel;
  return samples >= fewest_samples * static_cast<double>(triangle_count(scene));
}

double extent_of(const Bounds3f& bounds) {
  return static_cast<double>(
      std::max(max_component(glm::abs(bounds.lower)), max_component(glm::abs(bounds.upper))));
}

// Counts rectangles over pixels: each is noted by its corners, and sums over both axes tell how
// many cover a pixel.
class Cover {
 public:
  Cover(int width, int height, double radius)
      : width_(width),
        height_(height),
        reach_(radius + 0.5 + std::max(width, height) * 0x1p-20),
        corners_(static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(height + 1)) {}

  // All pixels whose samples may lie within the bounds. A pixel's middle is half a pixel beside
  // its index.
  void add(const FilmBounds& bounds) {
    if (bounds.is_empty()) return;
    const auto column = [&](double x) { return (x + 1) / 2 * width_; };
    const auto row = [&](double y) { return (1 - y) / 2 * height_; };
    const int x0 = pixel(std::ceil(column(bounds.lower.x) - reach_), width_);
    const int x1 = pixel(std::floor(column(bounds.upper.x) + reach_), width_);
    const int y0 = pixel(std::ceil(row(bounds.upper.y) - reach_), height_);
    const int y1 = pixel(std::floor(row(bounds.lower.y) + reach_), height_);
    if (x0 >= x1 || y0 >= y1) return;
    ++corner(x0, y0);
    --corner(x1, y0);
    --corner(x0, y1);
    ++corner(x1, y1);
  }
  // 1 where there is nothing.
  [[nodiscard]] std::vector<std::uint8_t> gaps() && {
    std::vector<std::uint8_t> gaps(static_cast<std::size_t>(width_) *
                                   static_cast<std::size_t>(height_));
    for (int y = 0; y < height_; ++y) {
      int in_row = 0;
      for (int x = 0; x < width_; ++x) {
        in_row += corner(x, y);
        const int above = y > 0 ? corner(x, y - 1) : 0;
        corner(x, y) = above + in_row;
        gaps[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
             static_cast<std::size_t>(x)] = corner(x, y) == 0 ? 1 : 0;
      }
    }
    return gaps;
  }

 private:
  [[nodiscard]] static int pixel(double place, int count) {
    return static_cast<int>(std::clamp(place, 0.0, static_cast<double>(count)));
  }
  [[nodiscard]] std::int32_t& corner(int x, int y) {
    return corners_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ + 1) +
                    static_cast<std::size_t>(x)];
  }

  int width_;
  int height_;
  double reach_;
  std::vector<std::int32_t> corners_;
};

std::array<Projection::Point, 8> corners_of(const Bounds3f& box, const Projection& projection) {
  std::array<Projection::Point, 8> corners;
  for (unsigned i = 0; i < corners.size(); ++i)
    corners[i] = projection.point({((i & 1) != 0 ? box.upper : box.lower).x,
                                   ((i & 2) != 0 ? box.upper : box.lower).y,
                                   ((i & 4) != 0 ? box.upper : box.lower).z});
  return corners;
}

void add_geometry(const Geometry& geometry, const Projection& projection, Cover& cover) {
  for (const Sphere& sphere : geometry.spheres)
    cover.add(projection.bounds(corners_of(bounds_of(sphere), projection)));
  std::vector<Projection::Point> points;
  points.reserve(geometry.positions.size());
  for (const Vec3f& position : geometry.positions) points.push_back(projection.point(position));
  for (const auto& [a, b, c] : geometry.triangles)
    cover.add(projection.bounds(std::array{points[a], points[b], points[c]}));
}

// An instance's box, widened by what rounding moves.
Bounds3f wide_bounds_of(const Instance& instance, const Bounds3f& object) {
  const Vec3f moved{instance.offset({1, 0, 0}), instance.offset({0, 1, 0}),
                    instance.offset({0, 0, 1})};
  const Bounds3f box = bounds_of(instance, object);
  return {box.lower - moved * 2.0f, box.upper + moved * 2.0f};
}

void add_instances(const Scene& scene, const Projection& projection, Cover& cover) {
  std::vector<Bounds3f> objects;
  for (const Object& object : scene.objects) {
    Bounds3f& bounds = objects.emplace_back();
    for (const GeometryHandle handle : object.geometries)
      bounds.include(bounds_of(scene.geometries[handle.index]));
  }
  for (const Instance& instance : scene.instances) {
    const Bounds3f& object = objects[instance.object.index];
    if (object.is_empty()) continue;
    cover.add(projection.bounds(corners_of(wide_bounds_of(instance, object), projection)));
  }
}

}  // namespace

BackgroundPixels::BackgroundPixels(const Scene& scene, const Filter& filter,
                                   const RenderOptions& options)
    : width_(static_cast<std::size_t>(options.width)) {
  const Camera& camera = scene.cameras[options.camera];
  const std::optional<Rgb> background = constant_background(scene, options);
  if (!background || filter.is_signed() || scene.features.media || !has_projection(camera) ||
      scene.bounds.is_empty() || !is_worth_it(scene, options))
    return;
  sample_.radiance = *background;
  sample_.alpha = 0;
  const Projection projection(camera, extent_of(scene.bounds));
  Cover cover(options.width, options.height, static_cast<double>(filter.radius()));
  for (const GeometryHandle handle : scene.world.geometries)
    add_geometry(scene.geometries[handle.index], projection, cover);
  add_instances(scene, projection, cover);
  is_background_ = std::move(cover).gaps();
}

}  // namespace candela
