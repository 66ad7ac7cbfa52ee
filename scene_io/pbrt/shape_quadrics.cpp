// sphere, disk and cylinder.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "renderer/math/constants.h"
#include "scene_io/pbrt/shape_kinds.h"

namespace candela::pbrt {
namespace {

using description::Mesh;

double clamped_angle(Arguments& arguments) {
  return arguments.clamped("phimax", arguments.number("phimax").value_or(360), 0, 360) *
         (pi_double / 180);
}

// Above 0; nothing after an error.
std::optional<double> radius_of(Arguments& arguments) {
  const double radius = arguments.number("radius").value_or(1);
  if (radius > 0) return radius;
  arguments.report().error(arguments.statement().place,
                           fmt::format("the radius is {}, expected above 0", radius));
  return std::nullopt;
}

std::uint32_t columns_for(double phi_max, const ShapeOptions& options) {
  const double columns = std::ceil(options.segments * phi_max / (2 * pi_double));
  return std::max(3u, static_cast<std::uint32_t>(columns));
}

double area_of(const Mesh& mesh) {
  double twice = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    twice +=
        length(cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]));
  return twice / 2;
}

// So much larger than the chord must a polygon's radius be for the circle's circumference.
double circumference_factor(double phi_max, std::uint32_t columns) {
  const double half_step = phi_max / columns / 2;
  return half_step > 0 ? half_step / std::sin(half_step) : 1;
}

Vec2d as_is(double u, double v) {
  return {u, v};
}

// Once around is where it began: no crack.
double angle_at(double u, double phi_max) {
  return u == 1 && phi_max == 2 * pi_double ? 0 : u * phi_max;
}

// Whether nothing is cut off.
bool is_whole(Arguments& arguments, double radius) {
  const double z0 = arguments.number("zmin").value_or(-radius);
  const double z1 = arguments.number("zmax").value_or(radius);
  return std::min(z0, z1) <= -radius && std::max(z0, z1) >= radius &&
         arguments.clamped("phimax", arguments.number("phimax").value_or(360), 0, 360) >= 360;
}

}  // namespace

void append_grid(std::uint32_t grid_columns, std::uint32_t grid_rows,
                 const std::function<SurfaceSample(double u, double v)>& surface,
                 const std::function<Vec2d(double u, double v)>& uv, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t j = 0; j <= grid_rows; ++j)
    for (std::uint32_t i = 0; i <= grid_columns; ++i) {
      const double u = static_cast<double>(i) / grid_columns;
      const double v = static_cast<double>(j) / grid_rows;
      const SurfaceSample sample = surface(u, v);
      const double size = length(sample.normal);
      mesh.positions.push_back(sample.position);
      mesh.normals.push_back(size > 0 ? Vec3f(sample.normal / size) : Vec3f(0));
      mesh.uvs.push_back(Vec2f(uv(u, v)));
    }
  const auto append = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto& p = mesh.positions;
    if (p[a] != p[b] && p[b] != p[c] && p[c] != p[a]) mesh.triangles.push_back({a, b, c});
  };
  for (std::uint32_t j = 0; j < grid_rows; ++j)
    for (std::uint32_t i = 0; i < grid_columns; ++i) {
      const std::uint32_t corner = first + j * (grid_columns + 1) + i;
      append(corner, corner + 1, corner + grid_columns + 2);
      append(corner, corner + grid_columns + 2, corner + grid_columns + 1);
    }
}

// u around, v from the lower end to the upper. At the poles all of a row is one point.
MaybeMesh sphere(Arguments& arguments, const ShapeOptions& options) {
  const auto radius = radius_of(arguments);
  if (!radius) return std::nullopt;
  const double r = *radius;
  Mesh mesh;
  if (options.keeps_spheres && is_whole(arguments, r)) {
    mesh.sphere = description::Sphere{r, false};
    return ShapeMesh{std::move(mesh)};
  }
  const double z0 = std::clamp(arguments.number("zmin").value_or(-r), -r, r);
  const double z1 = std::clamp(arguments.number("zmax").value_or(r), -r, r);
  const double phi_max = clamped_angle(arguments);
  const std::uint32_t columns = columns_for(phi_max, options);
  const double theta0 = std::acos(std::min(z0, z1) / r);
  const double theta1 = std::acos(std::max(z0, z1) / r);
  const auto surface = [&](double u, double v) {
    const double phi = angle_at(u, phi_max);
    const double theta = theta0 + (theta1 - theta0) * v;
    const double sine = theta == pi_double ? 0 : std::sin(theta);
    const Vec3d normal(sine * std::cos(phi), sine * std::sin(phi), std::cos(theta));
    return SurfaceSample{normal * r, normal};
  };
  append_grid(columns, options.segments / 2, surface, as_is, mesh);
  const double area = area_of(mesh) / (r * r);
  const double exact = phi_max * std::abs(z1 - z0) / r;
  if (area > 0)
    for (Vec3d& position : mesh.positions) position *= std::sqrt(exact / area);
  return ShapeMesh{std::move(mesh)};
}

// u around, v from the rim inwards.
MaybeMesh disk(Arguments& arguments, const ShapeOptions& options) {
  const auto radius = radius_of(arguments);
  if (!radius) return std::nullopt;
  const double height = arguments.number("height").value_or(0);
  const double wanted =
      arguments.clamped("innerradius", arguments.number("innerradius").value_or(0), 0);
  const double inner = std::min(wanted, *radius);
  const double phi_max = clamped_angle(arguments);
  const std::uint32_t columns = columns_for(phi_max, options);
  const double step = phi_max / columns;
  const double factor = step > 0 ? std::sqrt(step / std::sin(step)) : 1;
  const auto surface = [&](double u, double v) {
    const double r = (*radius + (inner - *radius) * v) * factor;
    const double phi = angle_at(u, phi_max);
    return SurfaceSample{{r * std::cos(phi), r * std::sin(phi), height}, {0, 0, 1}};
  };
  Mesh mesh;
  append_grid(columns, 1, surface, as_is, mesh);
  return ShapeMesh{std::move(mesh)};
}

MaybeMesh cylinder(Arguments& arguments, const ShapeOptions& options) {
  const auto radius = radius_of(arguments);
  if (!radius) return std::nullopt;
  const double z0 = arguments.number("zmin").value_or(-1);
  const double z1 = arguments.number("zmax").value_or(1);
  const double phi_max = clamped_angle(arguments);
  const std::uint32_t columns = columns_for(phi_max, options);
  const double r = *radius * circumference_factor(phi_max, columns);
  const auto surface = [&](double u, double v) {
    const double phi = angle_at(u, phi_max);
    const Vec3d normal(std::cos(phi), std::sin(phi), 0);
    return SurfaceSample{normal * r + Vec3d(0, 0, std::min(z0, z1) + std::abs(z1 - z0) * v),
                         normal};
  };
  Mesh mesh;
  append_grid(columns, 1, surface, as_is, mesh);
  return ShapeMesh{std::move(mesh)};
}

}  // namespace candela::pbrt
