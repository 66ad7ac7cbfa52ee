// The density that kernels ask for where a path meets a lamp of triangles.
#pragma once

#include "integrators/path/path_step.h"

namespace candela::light_test {

// A scene of nothing but this lamp: a triangle, or a quad, of which the path meets a half.
class MetLamp {
 public:
  explicit MetLamp(Light lamp) {
    if (lamp.kind == LightKind::Quad) {
      Light half;
      half.kind = LightKind::Triangle;
      half.quad = 1;
      scene_.lights = {half, lamp};
    } else {
      if (lamp.quad != Light::none) lamp.quad = 0;
      scene_.lights = {lamp};
    }
    std::vector<double> powers(scene_.lights.size(), 0.0);
    powers.back() = 1;
    scene_.light_sampler = {scene_.lights, powers};
  }

  // In solid angle, of a ray from `from` along the unit wi that meets the lamp at `distance`.
  // `normal`: the receiver's SurfacePoint::receiving_normal.
  [[nodiscard]] float pdf(const Vec3f& from, const Vec3f& normal, const Vec3f& wi,
                          double distance) const {
    PathState path;
    path.receiving_normal = normal;
    return met_triangle_pdf(scene_, 0, from, path, wi, static_cast<float>(distance));
  }

 private:
  Scene scene_;
};

}  // namespace candela::light_test
