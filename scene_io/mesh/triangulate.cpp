#include "scene_io/mesh/triangulate.h"

namespace candela::mesh {
namespace {

// Simple polygons of 200,000 corners were measured to need 30 (circle), 130 (combs, spirals) and
// 610 (stars whose radius is noise) a corner.
constexpr std::uint64_t work_per_corner = 1000;

double distance_squared(const Vec3d& a, const Vec3d& b) {
  return length_squared(a - b);
}

// Proper crossing: both ends of each segment on either side of the other.
bool do_cross(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
  const auto sign = [](std::int64_t x) { return (x > 0) - (x < 0); };
  return sign(orientation(a, b, c)) * sign(orientation(a, b, d)) < 0 &&
         sign(orientation(c, d, a)) * sign(orientation(c, d, b)) < 0;
}

}  // namespace

std::span<const IndexTriangle> Triangulator::triangulate(std::span<const Vec3d> polygon) {
  triangles_.clear();
  was_bow_ = false;
  if (polygon.size() < 3) return {};
  if (polygon.size() == 3) {
    emit(0, 1, 2);
    return triangles_;
  }
  project_to_grid(polygon, points_);
  if (polygon.size() == 4) {
    split_quad(polygon);
  } else {
    clip_ears();
  }
  return triangles_;
}

void Triangulator::split_quad(std::span<const Vec3d> polygon) {
  const auto turns_left = [&](std::size_t a, std::size_t b, std::size_t c) {
    return orientation(points_[a], points_[b], points_[c]) > 0;
  };
  const bool is_02_inside = turns_left(0, 1, 2) && turns_left(0, 2, 3);
  const bool is_13_inside = turns_left(0, 1, 3) && turns_left(1, 2, 3);
  const bool is_02_shorter =
      distance_squared(polygon[0], polygon[2]) < distance_squared(polygon[1], polygon[3]);
  if (!is_02_inside && !is_13_inside) return split_odd_quad(is_02_shorter);
  const bool takes_02 = is_02_inside && (is_02_shorter || !is_13_inside);
  if (takes_02) {
    emit(0, 1, 2);
    emit(0, 2, 3);
  } else {
    emit(0, 1, 3);
    emit(1, 2, 3);
  }
}

// Neither diagonal lies inside: a bow, whose crossing edges are the diagonals of the quad that was
// meant, or a quad without area.
void Triangulator::split_odd_quad(bool is_02_shorter) {
  const auto& p = points_;
  const bool do_01_23_cross = do_cross(p[0], p[1], p[2], p[3]);
  const bool do_12_30_cross = do_cross(p[1], p[2], p[3], p[0]);
  was_bow_ = do_01_23_cross || do_12_30_cross;
  if (do_01_23_cross) {
    emit(0, 3, 1);
    emit(0, 1, 2);
  } else if (do_12_30_cross) {
    emit(0, 1, 3);
    emit(0, 3, 2);
  } else {
    emit(0, 1, is_02_shorter ? 2 : 3);
    emit(is_02_shorter ? 0 : 1, 2, 3);
  }
}

void Triangulator::clip_ears() {
  start();
  while (remaining_ > 3 && !is_spent()) {
    if (round_.empty()) {
      clip_stuck();
    } else {
      clip_round();
    }
    round_.swap(next_round_);
    next_round_.clear();
    ++round_number_;
  }
  finish_as_fan();
}

void Triangulator::start() {
  const auto count = static_cast<std::uint32_t>(points_.size());
  previous_.resize(count);
  next_.resize(count);
  round_.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    previous_[i] = i == 0 ? count - 1 : i - 1;
    next_[i] = i + 1 == count ? 0 : i + 1;
    round_[i] = i;
  }
  touched_in_.assign(count, 0);
  is_queued_.assign(count, true);
  next_round_.clear();
  remaining_ = count;
  round_number_ = 1;
  stuck_at_ = 0;
  work_ = 0;
  blocking_.build(points_);
  for (std::uint32_t i = 0; i < count; ++i) classify(i);
}

bool Triangulator::is_spent() const {
  return work_ >= work_per_corner * points_.size();
}

std::int64_t Triangulator::turn_at(std::uint32_t corner) const {
  return orientation(points_[previous_[corner]], points_[corner], points_[next_[corner]]);
}

// Only corners that are not convex can be the deepest intruder into an ear.
void Triangulator::classify(std::uint32_t corner) {
  blocking_.set_live(corner, turn_at(corner) <= 0);
}

bool Triangulator::is_ear(std::uint32_t corner, Strictness strictness) {
  ++work_;
  if (turn_at(corner) <= 0) return false;
  const std::array<GridPoint, 3> ear{points_[previous_[corner]], points_[corner],
                                     points_[next_[corner]]};
  return !blocking_.has_live_in(ear, strictness == Strictness::Boundary, work_);
}

void Triangulator::clip_round() {
  for (const std::uint32_t corner : round_) {
    is_queued_[corner] = false;
    if (next_[corner] == corner) continue;  // gone
    if (remaining_ <= 3 || is_spent()) return;
    if (touched_in_[corner] == round_number_) {
      touch(corner);  // its turn comes in the next round
    } else if (is_ear(corner, Strictness::Boundary)) {
      clip(corner);
    }
  }
}

bool Triangulator::may_clip_stuck(std::uint32_t corner) {
  return turn_at(corner) == 0 || is_ear(corner, Strictness::Interior);
}

// No ear is left, so the polygon is not simple: takes away a corner of no area, or an ear that is
// only touched, or, where a whole turn of the ring finds neither, whatever is there.
void Triangulator::clip_stuck() {
  while (next_[stuck_at_] == stuck_at_)
    stuck_at_ = stuck_at_ + 1 == points_.size() ? 0 : stuck_at_ + 1;
  std::uint32_t corner = stuck_at_;
  for (std::uint32_t step = 0; step < remaining_ && !may_clip_stuck(corner); ++step) {
    corner = next_[corner];
    ++work_;
  }
  stuck_at_ = next_[corner];
  clip(corner);
}

void Triangulator::touch(std::uint32_t corner) {
  touched_in_[corner] = round_number_;
  if (is_queued_[corner]) return;
  is_queued_[corner] = true;
  next_round_.push_back(corner);
}

void Triangulator::clip(std::uint32_t corner) {
  const std::uint32_t before = previous_[corner];
  const std::uint32_t after = next_[corner];
  emit(before, corner, after);
  next_[before] = after;
  previous_[after] = before;
  next_[corner] = corner;
  --remaining_;
  blocking_.set_live(corner, false);
  classify(before);
  classify(after);
  touch(before);
  touch(after);
}

void Triangulator::finish_as_fan() {
  std::uint32_t first = 0;
  while (next_[first] == first) ++first;
  for (std::uint32_t b = next_[first], c = next_[b]; c != first; b = c, c = next_[c]) {
    emit(first, b, c);
  }
}

}  // namespace candela::mesh
