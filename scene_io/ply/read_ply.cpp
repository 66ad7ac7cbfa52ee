#include "scene_io/ply/read_ply.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "scene_io/mesh/float_direction.h"
#include "scene_io/mesh/smooth_normals.h"
#include "scene_io/mesh/triangulate.h"
#include "scene_io/ply/header.h"
#include "scene_io/ply/values.h"
#include "scene_io/ply/vertex_slots.h"
#include "scene_io/text/file.h"

namespace candela::ply {
namespace {

using description::Mesh;

bool is_index_list(const Property& property) {
  return property.count_type &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

template <class Values>
class BodyReader {
 public:
  BodyReader(const text::Source& source, const Header& header, Values values,
             Diagnostics& diagnostics)
      : source_(source), header_(header), values_(values), diagnostics_(diagnostics) {}

  // False after an error.
  bool read(PolygonMesh& polygons) {
    Mesh& mesh = polygons.mesh;
    bool has_vertices = false;
    for (const Element& element : header_.elements) {
      if (element.name != "vertex") continue;
      if (has_vertices) return refuse(element, "a second element 'vertex'");
      has_vertices = true;
      vertex_count_ = element.count;
    }
    for (const Element& element : header_.elements) {
      if (!has_bytes_for(element) || !read_element(element, polygons)) return false;
    }
    if (mesh.positions.empty()) return fail("holds no vertices");
    if (polygons.sizes.empty()) return refuse_no_faces();
    warn_of_losses();
    return true;
  }

 private:
  bool fail(std::string message) {
    diagnostics_.error({source_.name, 0, 0}, std::move(message));
    return false;
  }

  bool refuse(const Element& element, std::string message) {
    diagnostics_.add(text::diagnose(source_, element.offset, Severity::Error, std::move(message)));
    return false;
  }

  bool refuse_no_faces() {
    if (dropped_count_ > 0) return fail("holds no face of 3 corners or more");
    for (const Element& element : header_.elements)
      if (element.name == "face" && element.count > 0)
        return refuse(element, "faces without the list 'vertex_indices' or 'vertex_index'");
    return fail("holds no faces");
  }

  // With the place: line and column of a text, the byte of a binary file.
  bool fail_here(std::string message) {
    const std::size_t offset = values_.offset();
    if (header_.form == Form::Ascii) {
      diagnostics_.add(text::diagnose(source_, offset, Severity::Error, std::move(message)));
      return false;
    }
    return fail(fmt::format("{} (before byte {})", message, offset));
  }

  bool fail_at_number(const Element& element, std::uint64_t index) {
    text::Cursor at(std::string_view(source_.text).substr(values_.offset()));
    const std::string_view word = header_.form == Form::Ascii ? at.next_word() : std::string_view();
    return fail_here(fmt::format("found {}, expected a number of {}",
                                 word.empty() ? "the end of the file" : text::quoted(word),
                                 nth(element, index)));
  }

  // "'face' 1 of 2", counted from 1.
  static std::string nth(const Element& element, std::uint64_t index) {
    return fmt::format("{} {} of {}", text::quoted(element.name), index + 1, element.count);
  }

  // The header's word counts only as far as the file is long enough for it.
  bool has_bytes_for(const Element& element) {
    std::uint64_t least = 0;
    for (const Property& p : element.properties) {
      least += Values::least_bytes(p.count_type.value_or(p.type));
    }
    if (least == 0 || element.count <= values_.bytes_left() / least) return true;
    return refuse(element,
                  fmt::format("{} {} are announced, but the file has only {} bytes for them",
                              element.count, text::quoted(element.name), values_.bytes_left()));
  }

  bool read_element(const Element& element, PolygonMesh& polygons) {
    if (element.properties.empty()) return true;
    if (element.name == "vertex") return read_vertices(element, polygons.mesh);
    const bool is_face = element.name == "face";
    const bool is_strip = element.name == "tristrips";
    if (is_face) reserve_triangles(element, polygons);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (const Property& property : element.properties) {
        const bool is_indices = (is_face || is_strip) && is_index_list(property);
        if (is_indices ? !read_indices(element, property, i, is_strip, polygons)
                       : !skip(property)) {
          return fail_unless_said(element, i);
        }
      }
    }
    return true;
  }

  // A triangle takes four bytes at the least.
  void reserve_triangles(const Element& element, PolygonMesh& polygons) const {
    const auto count = static_cast<std::size_t>(std::min(element.count, values_.bytes_left() / 4));
    polygons.sizes.reserve(count);
    polygons.corners.reserve(3 * count);
  }

  // An error of its own was said, or the file ended.
  bool fail_unless_said(const Element& element, std::uint64_t index) {
    const bool was_said = was_said_;
    return was_said ? false : fail_at_number(element, index);
  }

  bool skip(const Property& property) {
    if (!property.count_type) return values_.skip(property.type, 1);
    const std::optional<double> count = values_.next(*property.count_type);
    if (!count) return false;
    if (!is_count(*count))
      return say(fmt::format("a list of {} values, expected a whole number of at least 0", *count));
    return *count <= static_cast<double>(values_.bytes_left()) &&
           values_.skip(property.type, static_cast<std::uint64_t>(*count));
  }

  static bool is_count(double number) {
    return std::isgreaterequal(number, 0.0) && number == std::floor(number);
  }

  bool say(std::string message) {
    was_said_ = true;
    return fail_here(std::move(message));
  }

  bool read_vertices(const Element& element, Mesh& mesh) {
    std::vector<std::size_t> slots;
    std::array<bool, SlotCount + 1> has{};
    const UvNames uv = uv_names_of(element);
    for (const Property& property : element.properties) {
      slots.push_back(slot_of(property, uv));
      has[slots.back()] = true;
    }
    if (!has[X] || !has[Y] || !has[Z]) {
      return refuse(element, "vertices without the properties x, y and z");
    }
    const bool has_normals = has[NormalX] && has[NormalY] && has[NormalZ];
    const bool has_uvs = has[U] && has[V];
    const auto count = static_cast<std::size_t>(element.count);
    mesh.positions.reserve(count);
    if (has_normals) mesh.normals.reserve(count);
    if (has_uvs) mesh.uvs.reserve(count);
    std::array<double, SlotCount + 1> record{};
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (!read_record(element, slots, record)) return fail_at_number(element, i);
      if (!add_position(record, mesh))
        return fail_here(nth(element, i) + " has a position that is not finite");
      if (has_normals) add_normal(record, mesh);
      if (has_uvs) add_uv(record, mesh);
    }
    return true;
  }

  bool read_record(const Element& element, const std::vector<std::size_t>& slots,
                   std::array<double, SlotCount + 1>& record) {
    for (std::size_t p = 0; p < slots.size(); ++p) {
      const Property& property = element.properties[p];
      if (property.count_type) {
        if (!skip(property)) return false;
        continue;
      }
      const std::optional<double> value = values_.next(property.type);
      if (!value) return false;
      record[slots[p]] = *value;
    }
    return true;
  }

  // False where it is not finite.
  static bool add_position(const std::array<double, SlotCount + 1>& record, Mesh& mesh) {
    mesh.positions.emplace_back(record[X], record[Y], record[Z]);
    return is_finite(mesh.positions.back());
  }

  void add_normal(const std::array<double, SlotCount + 1>& record, Mesh& mesh) {
    const Vec3d normal{record[NormalX], record[NormalY], record[NormalZ]};
    const bool is_number = is_finite(normal);
    if (!is_number) ++replaced_count_;
    mesh.normals.push_back(is_number ? mesh::to_float_direction(normal) : Vec3f(0.0f));
  }

  void add_uv(const std::array<double, SlotCount + 1>& record, Mesh& mesh) {
    const auto coordinate = [&](double x) {
      if (!std::isfinite(x)) ++replaced_count_;
      return std::isfinite(x) ? static_cast<float>(std::clamp(x, -1e30, 1e30)) : 0.0f;
    };
    mesh.uvs.push_back({coordinate(record[U]), coordinate(record[V])});
  }

  bool read_indices(const Element& element, const Property& property, std::uint64_t index,
                    bool is_strip, PolygonMesh& polygons) {
    const std::optional<double> count = values_.next(*property.count_type);
    if (!count) return false;
    const std::uint64_t least = Values::least_bytes(property.type);
    const auto most = static_cast<double>(values_.bytes_left() / least);
    if (!is_count(*count))
      return say(fmt::format("{} announces {} corners, expected a whole number of at least 0",
                             nth(element, index), *count));
    if (*count > most) {
      return say(fmt::format("{} announces {} corners, more than the file has bytes for",
                             nth(element, index), *count));
    }
    list_.clear();
    for (auto k = static_cast<std::uint64_t>(*count); k > 0; --k) {
      const std::optional<double> corner = values_.next(property.type);
      if (!corner) return false;
      const bool is_number = !std::isnan(*corner);
      const bool is_restart = is_strip && is_number && *corner == -1.0;
      const bool is_index = is_number && *corner >= 0.0 &&
                            *corner < static_cast<double>(vertex_count_) &&
                            *corner == std::floor(*corner);
      if (!is_index && !is_restart) {
        return say(fmt::format("{} has corner {}, but there are {} vertices (from 0)",
                               nth(element, index), *corner, vertex_count_));
      }
      list_.push_back(is_restart ? restart : static_cast<std::uint32_t>(*corner));
    }
    if (is_strip) return add_strip(polygons);
    if (list_.size() < 3)
      ++dropped_count_;
    else
      add_face(list_, polygons);
    return true;
  }

  static void add_face(std::span<const std::uint32_t> corners, PolygonMesh& polygons) {
    polygons.corners.insert(polygons.corners.end(), corners.begin(), corners.end());
    polygons.sizes.push_back(static_cast<std::uint32_t>(corners.size()));
  }

  // Every other triangle of a strip runs the other way round.
  bool add_strip(PolygonMesh& polygons) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < list_.size(); ++i) {
      if (list_[i] == restart) {
        begin = i + 1;
      } else if (i >= begin + 2) {
        const bool is_odd = (i - begin) % 2 == 1;
        const std::uint32_t a = list_[i - 2];
        const std::uint32_t b = list_[i - 1];
        add_face(std::array{is_odd ? b : a, is_odd ? a : b, list_[i]}, polygons);
      }
    }
    return true;
  }

  void warn_of_losses() {
    if (dropped_count_ > 0)  // as pbrt does
      diagnostics_.warning(
          {source_.name, 0, 0},
          fmt::format("faces of fewer than 3 corners are left out: {}", dropped_count_));
    if (replaced_count_ > 0)
      diagnostics_.warning({source_.name, 0, 0},
                           fmt::format("{} normals and texture coordinates are not finite and "
                                       "count as absent or 0",
                                       replaced_count_));
  }

  static constexpr std::uint32_t restart = UINT32_MAX;

  const text::Source& source_;
  const Header& header_;
  Values values_;
  Diagnostics& diagnostics_;
  std::uint64_t vertex_count_ = 0;
  std::uint64_t replaced_count_ = 0;
  std::uint64_t dropped_count_ = 0;
  bool was_said_ = false;
  std::vector<std::uint32_t> list_;  // the one being read
};

std::optional<Mesh> mesh_of(std::optional<PolygonMesh> polygons, const PlyOptions& options) {
  if (!polygons) return std::nullopt;
  Mesh mesh = triangulated(std::move(*polygons));
  if (mesh.normals.empty() && options.smooth_missing_normals && mesh::shares_vertices(mesh))
    mesh::compute_smooth_normals(mesh);
  return mesh;
}

bool read_body(const text::Source& source, const Header& header, PolygonMesh& polygons,
               Diagnostics& diagnostics) {
  if (header.form == Form::Ascii) {
    const AsciiValues values(source.text, header.body);
    return BodyReader(source, header, values, diagnostics).read(polygons);
  }
  const BinaryValues values(source.text, header.body, header.form == Form::LittleEndian);
  return BodyReader(source, header, values, diagnostics).read(polygons);
}

}  // namespace

std::optional<PolygonMesh> parse_polygons(const std::string& path, std::string_view bytes,
                                          Diagnostics& diagnostics) {
  const text::Source source = text::make_source(path, bytes);
  const std::optional<Header> header = parse_header(source, diagnostics);
  if (!header) return std::nullopt;
  PolygonMesh polygons;
  if (!read_body(source, *header, polygons, diagnostics)) return std::nullopt;
  polygons.mesh.name = path;
  polygons.mesh.span = {source.name, 1, 1};
  return polygons;
}

Mesh triangulated(PolygonMesh polygons) {
  Mesh mesh = std::move(polygons.mesh);
  mesh::Triangulator triangulator;
  std::vector<Vec3d> polygon;
  mesh.triangles.reserve(polygons.corners.size() - 2 * polygons.sizes.size());
  const std::uint32_t* corner = polygons.corners.data();
  for (const std::uint32_t size : polygons.sizes) {
    if (size == 3) {
      mesh.triangles.push_back({corner[0], corner[1], corner[2]});
    } else {
      polygon.clear();
      for (std::uint32_t k = 0; k < size; ++k) polygon.push_back(mesh.positions[corner[k]]);
      for (const mesh::IndexTriangle& t : triangulator.triangulate(polygon))
        mesh.triangles.push_back({corner[t[0]], corner[t[1]], corner[t[2]]});
    }
    corner += size;
  }
  return mesh;
}

std::optional<Mesh> parse_ply(const std::string& path, std::string_view bytes,
                              const PlyOptions& options, Diagnostics& diagnostics) {
  return mesh_of(parse_polygons(path, bytes, diagnostics), options);
}

// The file's bytes are gone before there are triangles.
std::optional<Mesh> read_ply(const std::string& path, const PlyOptions& options,
                             Diagnostics& diagnostics) {
  std::optional<PolygonMesh> polygons;
  {
    const Result<std::string> bytes = text::read_file(path);
    diagnostics.append(bytes.diagnostics);
    if (bytes) polygons = parse_polygons(path, *bytes, diagnostics);
  }
  return mesh_of(std::move(polygons), options);
}

}  // namespace candela::ply
