// The directives that change the current transform.

#include <fmt/format.h>

#include "scene_io/pbrt/parser.h"
#include "scene_io/pbrt/transforms.h"

namespace candela::pbrt {

// Brackets around them are free, as the matrices of Transform are written.
template <std::size_t n>
std::optional<std::array<double, n>> Parser::read_numbers() {
  const bool has_bracket = tokens_->peek().kind == TokenKind::Open;
  if (has_bracket) tokens_->next();
  std::array<double, n> numbers;
  for (double& number : numbers) {
    const auto read = read_number();
    if (!read) return std::nullopt;
    number = *read;
  }
  if (!has_bracket) return numbers;
  const Token close = tokens_->peek();
  if (close.kind == TokenKind::Close) {
    tokens_->next();
    return numbers;
  }
  error(close.offset, fmt::format("{}: expected ] behind {} numbers", directive_.text, n));
  skip_to_directive();
  return std::nullopt;
}

// Of the two transforms of a moving scene the one at the shutter's opening is kept.
void Parser::apply(const Transform& transform) {
  if (!state_.sets_transform) return;
  state_.transform = state_.transform * transform;
  if (has_finite_numbers(state_.transform)) return;
  error_here("the current transform has numbers that are not finite");
  state_.transform = Transform();
}

void Parser::identity() {
  if (state_.sets_transform) state_.transform = Transform();
}

void Parser::translate() {
  const auto by = read_numbers<3>();
  if (by) apply({Mat3d(1.0), Vec3d((*by)[0], (*by)[1], (*by)[2])});
}

void Parser::scale() {
  const auto by = read_numbers<3>();
  if (by) apply(scaling({(*by)[0], (*by)[1], (*by)[2]}));
}

void Parser::rotate() {
  const auto numbers = read_numbers<4>();
  if (!numbers) return;
  const Vec3d axis((*numbers)[1], (*numbers)[2], (*numbers)[3]);
  if (axis == Vec3d(0.0)) return error_here("Rotate: the axis is zero");
  apply(rotation((*numbers)[0], axis));
}

void Parser::look_at() {
  const auto n = read_numbers<9>();
  if (!n) return;
  const Vec3d eye((*n)[0], (*n)[1], (*n)[2]);
  const Vec3d target((*n)[3], (*n)[4], (*n)[5]);
  const Vec3d up((*n)[6], (*n)[7], (*n)[8]);
  const Transform camera_from_world = looking(eye, target, up);
  if (!has_finite_numbers(camera_from_world))
    return error_here(
        "LookAt: the eye is at the point looked at, or up is zero or parallel to the line of "
        "sight");
  apply(camera_from_world);
}

void Parser::transform() {
  const auto numbers = read_numbers<16>();
  if (!numbers) return;
  if (!is_affine(*numbers))
    return error_here("Transform: the matrix is not affine: its last row is not 0 0 0 1");
  if (state_.sets_transform) state_.transform = affine(*numbers);
}

void Parser::concat_transform() {
  const auto numbers = read_numbers<16>();
  if (!numbers) return;
  if (!is_affine(*numbers))
    return error_here("ConcatTransform: the matrix is not affine: its last row is not 0 0 0 1");
  apply(affine(*numbers));
}

void Parser::coordinate_system() {
  const auto name = read_string("the name of a coordinate system");
  if (name) systems_[*name] = state_.transform;
}

void Parser::coord_sys_transform() {
  const Place place = here();
  const auto name = read_string("the name of a coordinate system");
  if (!name) return;
  const auto found = systems_.find(*name);
  if (found != systems_.end()) {
    state_.transform = found->second;  // of all times, whichever ActiveTransform names
    return;
  }
  report_.error(place, fmt::format("there is no coordinate system {}{}", text::quoted(*name),
                                   report_.did_you_mean_key(*name, systems_)));
}

void Parser::active_transform() {
  const Token which = tokens_->peek();
  if (which.kind != TokenKind::Word ||
      (which.text != "StartTime" && which.text != "EndTime" && which.text != "All")) {
    error(which.offset, fmt::format("ActiveTransform: found {}, expected StartTime, EndTime or All",
                                    text::quoted(which.text)));
    return skip_to_directive();
  }
  tokens_->next();
  state_.sets_transform = which.text != "EndTime";
  if (which.text == "EndTime")
    warn_once("motion", here(),
              "motion is not rendered: all things stand where they are at StartTime");
}

void Parser::transform_times() {
  (void)read_numbers<2>();
}

}  // namespace candela::pbrt
