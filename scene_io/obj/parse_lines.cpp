// Cuts the file into stretches at lines' ends, counts what each holds, and parses them in parallel
// into tables of the right size.
#include <algorithm>

#include <fmt/format.h>

#include "renderer/base/parallel.h"
#include "scene_io/obj/line_parser.h"
#include "scene_io/obj/obj_data.h"

namespace candela::obj {
namespace {

constexpr std::size_t chunk_bytes = std::size_t{1} << 20;
constexpr std::size_t max_table_size = INT32_MAX;

// Behind the first line's end at or after `offset` that no back-slash continues.
std::size_t next_cut(std::string_view text, std::size_t offset) {
  while (true) {
    const std::size_t newline = text.find('\n', offset);
    if (newline == std::string_view::npos) return text.size();
    std::size_t last = newline;
    if (last > 0 && text[last - 1] == '\r') --last;
    if (last == 0 || text[last - 1] != '\\') return newline + 1;
    offset = newline + 1;
  }
}

std::vector<std::string_view> cut(std::string_view text) {
  std::vector<std::string_view> pieces;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = next_cut(text, std::min(begin + chunk_bytes, text.size()));
    pieces.push_back(text.substr(begin, end - begin));
    begin = end;
  }
  return pieces;
}

ElementCounts operator+(const ElementCounts& a, const ElementCounts& b) {
  return {a.positions + b.positions, a.uvs + b.uvs, a.normals + b.normals, a.faces + b.faces};
}

bool is_too_large(const ElementCounts& counts) {
  return std::max({counts.positions, counts.uvs, counts.normals}) > max_table_size;
}

// First come, first said; the rest is counted.
void report(const text::Source& source, const ObjData& data, Diagnostics& diagnostics) {
  for (const Chunk& chunk : data.chunks) {
    if (diagnostics.is_full()) return;
    for (const Finding& finding : chunk.findings)
      text::report(diagnostics, source, finding.offset, finding.severity, finding.message);
    for (std::size_t i = chunk.findings.size(); i < chunk.error_count; ++i)
      diagnostics.error({}, {});
  }
}

}  // namespace

ObjData parse_lines(const text::Source& source, Diagnostics& diagnostics) {
  ObjData data;
  const std::vector<std::string_view> pieces = cut(source.text);
  std::vector<ChunkTask> tasks(pieces.size());
  parallel_for(pieces.size(), [&](std::size_t i) { tasks[i].total = count_elements(pieces[i]); });
  ElementCounts total;
  std::vector<std::size_t> face_counts;
  for (ChunkTask& task : tasks) {
    task.before = total;
    total = total + task.total;
    face_counts.push_back(task.total.faces);
  }
  if (is_too_large(total)) {
    diagnostics.error({source.name, 0, 0},
                      fmt::format("has more than {} vertices; no more are read", max_table_size));
    return data;
  }
  data.positions.resize(total.positions);
  data.uvs.resize(total.uvs);
  data.normals.resize(total.normals);
  data.chunks.resize(pieces.size());
  parallel_for(pieces.size(), [&](std::size_t i) {
    tasks[i].total = total;
    tasks[i].data = &data;
    Chunk& chunk = data.chunks[i];
    chunk.begin = static_cast<std::size_t>(pieces[i].data() - source.text.data());
    chunk.faces.reserve(face_counts[i]);
    chunk.corners.reserve(face_counts[i] * 3);
    parse_chunk(pieces[i], tasks[i], chunk);
  });
  report(source, data, diagnostics);
  return data;
}

}  // namespace candela::obj
