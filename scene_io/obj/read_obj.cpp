#include "scene_io/obj/read_obj.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

#include <fmt/format.h>

#include "renderer/base/counted.h"
#include "renderer/base/parallel.h"
#include "scene_io/obj/build_meshes.h"
#include "scene_io/obj/mtl_files.h"
#include "scene_io/obj/obj_data.h"
#include "scene_io/text/cursor.h"
#include "scene_io/text/file.h"
#include "scene_io/text/plain_text.h"
#include "scene_io/text/source.h"

namespace candela::obj {
namespace {

using description::MaterialHandle;
using description::Mesh;
using text::Source;

// Offsets of a text of at most this size fit Face::offset.
constexpr std::uint64_t max_bytes = UINT32_MAX;

void warn(const Source& source, std::size_t offset, std::string message, Diagnostics& diagnostics) {
  text::report(diagnostics, source, offset, Severity::Warning, std::move(message));
}

// Curves, surfaces and display settings.
bool is_free_form(std::string_view keyword) {
  static const std::unordered_set<std::string_view> keywords{
      "vp",        "deg",   "bmat",     "step",     "cstype", "curv",   "curv2",
      "surf",      "parm",  "trim",     "hole",     "scrv",   "sp",     "end",
      "con",       "mg",    "bzp",      "bsp",      "cdc",    "cdp",    "res",
      "bevel",     "lod",   "c_interp", "d_interp", "usemap", "maplib", "shadow_obj",
      "trace_obj", "ctech", "stech",    "call",     "csh"};
  return keywords.contains(keyword);
}

std::string left_out_message(std::string_view keyword) {
  if (keyword == "l") return "lines ('l') are left out: only faces are rendered";
  if (keyword == "p") return "points ('p') are left out: only faces are rendered";
  if (is_free_form(keyword)) {
    return fmt::format("{} is left out: curves, surfaces and display settings are not supported",
                       text::quoted(keyword));
  }
  return fmt::format(
      "unknown statement {} is left out{}", text::quoted(keyword),
      did_you_mean(keyword, {"v", "vt", "vn", "f", "g", "o", "s", "usemtl", "mtllib"}));
}

void warn_of_left_out(const Source& source, const ObjData& data, Diagnostics& diagnostics) {
  std::unordered_set<std::string_view> said;
  bool is_free_form_said = false;
  for (const Chunk& chunk : data.chunks) {
    for (const LeftOut& statement : chunk.left_out) {
      if (!said.insert(statement.keyword).second) continue;
      if (is_free_form(statement.keyword)) {
        if (is_free_form_said) continue;
        is_free_form_said = true;
      }
      warn(source, statement.offset, left_out_message(statement.keyword), diagnostics);
    }
  }
}

// Names to indices of materials. Each unknown name is said once; without any material the first.
class MaterialNames {
 public:
  // `lacks_library`: an MTL is missing, which has been said.
  MaterialNames(const Source& source, const std::vector<description::Material>& materials,
                bool lacks_library, Diagnostics& diagnostics)
      : source_(source), is_said_(materials.empty() && lacks_library), diagnostics_(diagnostics) {
    for (std::uint32_t i = 0; i < materials.size(); ++i) {
      const auto [first, is_new] = indices_.emplace(materials[i].name, i);
      if (!is_new) warn_of_second(materials[first->second], materials[i]);
      names_.emplace_back(materials[i].name);
    }
    for (std::uint32_t i = 0; i < materials.size(); ++i)
      indices_.emplace(text::without_comment(materials[i].name), i);
  }

  std::optional<std::uint32_t> operator()(std::string_view name) {
    for (const std::string_view word : {name, text::without_comment(name)})
      if (const auto found = indices_.find(word); found != indices_.end()) return found->second;
    if (!is_said_ && !name.empty() && unknown_.insert(name).second) {
      warn_of_unknown(name);
      is_said_ = names_.empty();
    }
    return std::nullopt;
  }

 private:
  // Within one file the MTL's reader has said it.
  void warn_of_second(const description::Material& first, const description::Material& second) {
    if (first.span.file == second.span.file || !text::is_kept(diagnostics_, Severity::Warning))
      return;
    diagnostics_.warning(second.span,
                         fmt::format("material {} is defined in {} as well; the first definition "
                                     "counts",
                                     text::quoted(second.name), *first.span.file));
  }

  void warn_of_unknown(std::string_view name) {
    // Comparing with all names would take long for many names.
    const bool is_kept = text::is_kept(diagnostics_, Severity::Warning);
    const std::string advice = is_kept ? did_you_mean(name, names_) : "";
    warn(source_, static_cast<std::size_t>(name.data() - source_.text.data()),
         fmt::format("material {} is not in the MTL{}", text::quoted(name),
                     names_.empty() ? ", which has no materials; expected 'mtllib' with one before"
                                    : advice),
         diagnostics_);
  }

  const Source& source_;
  bool is_said_;
  Diagnostics& diagnostics_;
  std::unordered_map<std::string_view, std::uint32_t> indices_;
  std::vector<std::string_view> names_;
  std::unordered_set<std::string_view> unknown_;
};

void warn_of_bows(const Source& source, const std::vector<BuiltMesh>& built,
                  Diagnostics& diagnostics) {
  std::size_t count = 0;
  std::size_t offset = SIZE_MAX;
  for (const BuiltMesh& mesh : built) {
    count += mesh.bow_count;
    if (mesh.bow_count > 0) offset = std::min(offset, mesh.first_bow_offset);
  }
  if (count == 0) return;
  warn(source, offset,
       fmt::format("{} quad{} edges cross; the corners are taken in the order in which they do not",
                   count, count == 1 ? "'s" : "s'"),
       diagnostics);
}

std::string name_of(const std::string& path, const ObjModel& model, const MeshPlan& plan) {
  return plan.material ? model.materials[*plan.material].name : path;
}

// Of the first faces, in one go through the text.
std::vector<SourceSpan> spans_of(const Source& source, const std::vector<MeshPlan>& plans) {
  std::vector<std::size_t> order(plans.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return first_offset(plans[a]) < first_offset(plans[b]);
  });
  text::SpanFinder span_at(source);
  std::vector<SourceSpan> spans(plans.size());
  for (const std::size_t i : order) spans[i] = span_at(first_offset(plans[i]));
  return spans;
}

void build_meshes(const std::string& path, const Source& source, const ObjData& data,
                  const std::vector<MeshPlan>& plans, const std::vector<SourceSpan>& spans,
                  bool smooth_missing_normals, ObjModel& model, Diagnostics& diagnostics) {
  std::vector<BuiltMesh> built(plans.size());
  parallel_for(plans.size(), [&](std::size_t i) {
    built[i] = build_mesh(data, plans[i], smooth_missing_normals);
  });
  warn_of_bows(source, built, diagnostics);
  for (std::size_t i = 0; i < plans.size(); ++i) {
    Mesh& mesh = built[i].mesh;
    mesh.name = name_of(path, model, plans[i]);
    mesh.span = spans[i];
    if (plans[i].material) mesh.materials = {MaterialHandle(*plans[i].material)};
    model.meshes.push_back(std::move(mesh));
  }
}

void warn_of_dropped(const Source& source, const ObjModel& model, const MeshPlan& plan,
                     Diagnostics& diagnostics) {
  if (plan.face_count == 0) return;
  warn(source, first_offset(plan),
       fmt::format("{} without a material {} dropped, from here on; expected {} before",
                   counted(plan.face_count, "face"), plan.face_count == 1 ? "is" : "are",
                   model.materials.empty() ? "'mtllib' with an MTL that has materials"
                                           : "'usemtl' with a material of the MTL"),
       diagnostics);
}

// A material for the faces that have none.
void add_grey(const Source& source, ObjModel& model, MeshPlan& plan) {
  description::Material grey;
  grey.name = "(no material)";
  grey.span = {source.name, 0, 0};
  grey.model = description::DiffuseMaterial{};
  plan.material = static_cast<std::uint32_t>(model.materials.size());
  model.materials.push_back(std::move(grey));
}

std::vector<MeshPlan> plan_meshes(const Source& source, const ObjData& data,
                                  const ObjOptions& options, ObjModel& model,
                                  Diagnostics& diagnostics) {
  if (options.materials == MtlUse::Ignore) return {plan_whole(data)};
  const bool lacks_library =
      !read_libraries(*source.name, source, data, options.materials, model, diagnostics);
  MaterialNames names(source, model.materials, lacks_library, diagnostics);
  std::vector<MeshPlan> plans = plan_by_material(data, model.materials.size(), std::ref(names));
  if (options.materials == MtlUse::Lab) {
    if (!diagnostics.has_errors()) warn_of_dropped(source, model, plans.back(), diagnostics);
    plans.pop_back();
  } else if (plans.back().face_count > 0 && !options.material) {
    add_grey(source, model, plans.back());
  }
  return plans;
}

bool has_faces(const ObjData& data) {
  return std::any_of(data.chunks.begin(), data.chunks.end(),
                     [](const Chunk& chunk) { return !chunk.faces.empty(); });
}

bool has_quads(const ObjData& data) {
  const auto is_quad = [](const Face& face) { return face.corner_count == 4; };
  return std::any_of(data.chunks.begin(), data.chunks.end(), [&](const Chunk& chunk) {
    return std::any_of(chunk.faces.begin(), chunk.faces.end(), is_quad);
  });
}

ObjModel parse_sound_text(const std::string& path, std::string text, const ObjOptions& options,
                          Diagnostics& diagnostics) {
  Source source = text::make_source(path, text);
  ObjModel model;
  model.files.push_back(path);
  const std::size_t errors_before = diagnostics.error_count();
  const ObjData data = parse_lines(source, diagnostics);
  warn_of_left_out(source, data, diagnostics);
  if (!has_faces(data) && diagnostics.error_count() == errors_before) {
    diagnostics.error({source.name, 0, 0}, "holds no faces ('f')");
  }
  std::vector<MeshPlan> plans = plan_meshes(source, data, options, model, diagnostics);
  std::erase_if(plans, [](const MeshPlan& plan) { return plan.face_count == 0; });
  const std::vector<SourceSpan> spans = spans_of(source, plans);
  if (!has_quads(data)) {  // of which alone there may be something left to say
    source.text = {};
    std::string().swap(text);  // most of what reading a large file takes
  }
  build_meshes(path, source, data, plans, spans, options.smooth_missing_normals, model,
               diagnostics);
  return model;
}

}  // namespace

ObjModel parse_obj(const std::string& path, std::string text, const ObjOptions& options,
                   Diagnostics& diagnostics) {
  if (text::is_utf16(text)) {
    diagnostics.error({std::make_shared<const std::string>(path), 1, 1},
                      "is in UTF-16; expected ASCII or UTF-8");
    return {};
  }
  text::drop_byte_order_mark(text);
  text::use_line_feeds(text);
  return parse_sound_text(path, std::move(text), options, diagnostics);
}

ObjModel read_obj(const std::string& path, const ObjOptions& options, Diagnostics& diagnostics) {
  text::FileLimits limits;
  limits.bytes = std::min(limits.bytes, max_bytes);
  limits.inflated_bytes = std::min(limits.inflated_bytes, max_bytes);
  Result<std::string> text = text::read_file(path, limits);
  diagnostics.append(text.diagnostics);
  if (!text) return {};
  return parse_obj(path, std::move(*text), options, diagnostics);
}

}  // namespace candela::obj
