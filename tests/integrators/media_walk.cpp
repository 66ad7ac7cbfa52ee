#include "tests/integrators/media_walk.h"

#include <limits>
#include <random>

#include "renderer/math/constants.h"

namespace candela::test {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

class Walk {
 public:
  Walk(const BoxOfMedium& scene, int channel, std::uint64_t seed)
      : scene_(scene), channel_(channel), random_(seed) {
    extinction_ = scene.absorption[channel] + scene.scattering[channel];
    albedo_ = extinction_ > 0 ? scene.scattering[channel] / extinction_ : 0;
  }

  double radiance(const Vec3d& eye, const Vec3d& direction) {
    place_ = eye;
    direction_ = direction;
    is_inside_ = max_component(glm::abs(eye)) < 1;
    double weight = 1;
    for (;;) {
      const double wall = is_inside_ ? distance_out() : distance_in();
      const double lamp = distance_to_lamp();
      const double free =
          is_inside_ && extinction_ > 0 ? -std::log(1 - number()) / extinction_ : nowhere;
      if (free < wall && free < lamp) {
        if (number() >= albedo_) return 0;
        place_ += direction_ * free;
        scatter();
      } else if (lamp < wall) {
        return weight * scene_.lamp_radiance[channel_];
      } else if (wall < nowhere) {
        place_ += direction_ * wall;
        weight *= meet_wall();
      } else {
        return weight * scene_.sky[channel_];
      }
    }
  }

 private:
  double number() { return uniform_(random_); }

  double distance_out() {
    double least = nowhere;
    for (int i = 0; i < 3; ++i) {
      if (direction_[i] == 0) continue;
      const double t = (std::copysign(1.0, direction_[i]) - place_[i]) / direction_[i];
      if (t < least) {
        least = t;
        axis_ = i;
      }
    }
    return std::max(least, 0.0);
  }
  double distance_in() {
    double enter = 1e-12;
    double leave = nowhere;
    int axis = -1;
    for (int i = 0; i < 3; ++i) {
      const double side = std::copysign(1.0, direction_[i]);
      const double near = (-side - place_[i]) / direction_[i];
      if (near > enter) {
        enter = near;
        axis = i;
      }
      leave = std::min(leave, (side - place_[i]) / direction_[i]);
    }
    if (axis < 0 || enter >= leave) return nowhere;
    axis_ = axis;
    return enter;
  }
  double distance_to_lamp() const {
    const Vec3d normal = cross(scene_.lamp_edge1, scene_.lamp_edge2);
    const double along = dot(normal, direction_);
    if (along == 0) return nowhere;
    const double t = dot(normal, scene_.lamp_corner - place_) / along;
    if (!(t > 1e-12)) return nowhere;
    const Vec3d p = place_ + direction_ * t - scene_.lamp_corner;
    const double u = dot(p, scene_.lamp_edge1) / dot(scene_.lamp_edge1, scene_.lamp_edge1);
    const double v = dot(p, scene_.lamp_edge2) / dot(scene_.lamp_edge2, scene_.lamp_edge2);
    return u >= 0 && u <= 1 && v >= 0 && v <= 1 ? t : nowhere;
  }

  // Through the wall, or back; the factor of radiance.
  double meet_wall() {
    if (scene_.ior == 1) {
      is_inside_ = !is_inside_;
      return 1;
    }
    const double eta = is_inside_ ? 1 / scene_.ior : scene_.ior;  // beyond over here
    const double cos_i = std::abs(direction_[axis_]);
    const double sin2_t = (1 - cos_i * cos_i) / (eta * eta);
    double reflectance = 1;
    const double cos_t = std::sqrt(std::max(0.0, 1 - sin2_t));
    if (sin2_t < 1) {
      const double parallel = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
      const double across = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
      reflectance = (parallel * parallel + across * across) / 2;
    }
    if (number() < reflectance) {
      direction_[axis_] = -direction_[axis_];
      return 1;
    }
    const double side = std::copysign(1.0, direction_[axis_]);
    direction_ /= eta;
    direction_[axis_] = side * cos_t;
    is_inside_ = !is_inside_;
    return 1 / (eta * eta);
  }

  void scatter() {
    const double g = scene_.asymmetry;
    const double u = number();
    double cosine = 1 - 2 * u;
    if (g != 0) {
      const double s = (1 - g * g) / (1 - g + 2 * g * u);
      cosine = (1 + g * g - s * s) / (2 * g);
    }
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double phi = 2 * pi_double * number();
    const Vec3d other = std::abs(direction_.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
    const Vec3d x = normalize(cross(direction_, other));
    const Vec3d y = cross(direction_, x);
    direction_ =
        normalize(direction_ * cosine + x * (sine * std::cos(phi)) + y * (sine * std::sin(phi)));
  }

  const BoxOfMedium& scene_;
  int channel_;
  std::mt19937_64 random_;
  std::uniform_real_distribution<double> uniform_{0, 1};
  double extinction_ = 0;
  double albedo_ = 0;
  Vec3d place_{0.0};
  Vec3d direction_{0.0};
  bool is_inside_ = false;
  int axis_ = 0;
};

}  // namespace

std::array<statistics::Moments, 3> walked_radiance(const BoxOfMedium& scene, const Vec3d& eye,
                                                   const Vec3d& direction, int count,
                                                   std::uint64_t seed) {
  std::array<statistics::Moments, 3> channels;
  for (int c = 0; c < 3; ++c) {
    Walk walk(scene, c, seed + static_cast<std::uint64_t>(c));
    for (int i = 0; i < count; ++i)
      channels[static_cast<std::size_t>(c)].add(walk.radiance(eye, direction));
  }
  return channels;
}

}  // namespace candela::test
