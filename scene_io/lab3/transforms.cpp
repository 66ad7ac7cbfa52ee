#include "scene_io/lab3/transforms.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene_io/lab3/direction.h"

namespace candela::lab3 {
namespace {

bool is_list_of_rows(const Node& node) {
  return node.is_sequence() && node.entries.size() == 3 &&
         std::all_of(node.entries.begin(), node.entries.end(),
                     [](const Entry& row) { return row.value->is_sequence(); });
}

// Written as a list of rows.
Mat3d read_rotation(Reader& reader, const Fields& fields) {
  const Entry* entry = fields.find("Rotation");
  if (!entry) return Mat3d(1.0);
  const Node& node = *entry->value;
  if (!is_list_of_rows(node)) {
    reader.error(node.offset,
                 fmt::format("Rotation: found {}, expected a matrix: a list of 3 rows of 3 "
                             "numbers, such as [[1, 0, 0], [0, 1, 0], [0, 0, 1]]",
                             describe(node)));
    return Mat3d(1.0);
  }
  Mat3d rows(1.0);
  for (int row = 0; row < 3; ++row) {
    const auto numbers = read_vector(reader, *node.entries[static_cast<std::size_t>(row)].value,
                                     "a row of Rotation", any_number);
    if (!numbers) return Mat3d(1.0);
    rows[row] = *numbers;
  }
  return glm::transpose(rows);
}

// The columns' directions span no volume: the matrix flattens everything.
bool is_singular(const Mat3d& matrix) {
  for (int c = 0; c < 3; ++c)
    if (matrix[c] == Vec3d(0.0)) return true;
  const double volume = dot(unit(matrix[0]), cross(unit(matrix[1]), unit(matrix[2])));
  return std::abs(volume) < parallel_sine;
}

void warn_of_no_rotation(Reader& reader, const Fields& fields, const Mat3d& rotation) {
  const Mat3d product = glm::transpose(rotation) * rotation;
  double deviation = 0;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      deviation = std::max(deviation, std::abs(product[c][r] - (c == r ? 1.0 : 0.0)));
  if (deviation > 1e-3)  // of the matrix's own entries, which a text rounds to a few digits
    reader.warning(fields.find("Rotation")->value->offset,
                   "Rotation is no rotation: its rows are not of length 1 and at right angles; it "
                   "is used as it stands");
}

}  // namespace

Transform read_transform(Reader& reader, const Fields& fields) {
  const Vec3d translation = fields.vector("Translation", any_number).value_or(Vec3d(0.0));
  const Vec3d scale = fields.vector("Scale", any_number).value_or(Vec3d(1.0));
  const Mat3d rotation = read_rotation(reader, fields);
  if (scale.x == 0 || scale.y == 0 || scale.z == 0) {
    reader.error(fields.find("Scale")->value->offset,
                 "Scale: found a 0, which flattens the model; expected numbers other than 0");
    return {};
  }
  if (is_singular(rotation)) {
    reader.error(fields.find("Rotation")->value->offset,
                 "Rotation: the matrix is singular and flattens the model");
    return {};
  }
  if (fields.has("Rotation")) warn_of_no_rotation(reader, fields, rotation);
  const Mat3d scaling(scale.x, 0, 0, 0, scale.y, 0, 0, 0, scale.z);
  return {rotation * scaling, translation};
}

}  // namespace candela::lab3
