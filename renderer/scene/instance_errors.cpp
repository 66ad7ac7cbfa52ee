#include "renderer/scene/instance_errors.h"

#include "renderer/base/floating_point_traps.h"
#include "renderer/math/constants.h"

namespace candela {
namespace {

Vec3d farthest(const Bounds3f& bounds) {
  return Vec3d(glm::max(glm::abs(bounds.lower), glm::abs(bounds.upper)));
}

// |m| v, component by component: the largest that m v can be for a v of either sign.
Vec3d absolute_product(const Mat3d& m, const Vec3d& v) {
  return glm::abs(m[0]) * v.x + glm::abs(m[1]) * v.y + glm::abs(m[2]) * v.z;
}

}  // namespace

void set_errors(Instance& instance, const Bounds3f& object) {
  if (object.is_empty()) return;
  const FloatingPointTraps traps(Traps::Off);  // a flat one's inverse is infinite
  const Mat3d linear(Vec3d(instance.x), Vec3d(instance.y), Vec3d(instance.z));
  const Vec3d translation = glm::abs(Vec3d(instance.translation));
  // Three products and three sums, each of which rounds what has been summed so far.
  const Vec3d placed = absolute_product(linear, farthest(object)) + translation;
  instance.placing_error = Vec3f(placed) * gamma_bound(4);
  // The same with the inverse, whose numbers were rounded too, of an origin on the instance.
  const Mat3d inverse = glm::inverse(linear);
  const Vec3d back = absolute_product(inverse, placed + translation);
  instance.ray_error = is_finite(back) ? Vec3f(back) * gamma_bound(5) : Vec3f(0);
}

}  // namespace candela
