#include <fmt/format.h>

#include "renderer/image/codecs.h"
#include "renderer/image/encode.h"
#include "renderer/image/image_io.h"

namespace candela {
namespace {

Diagnostics unknown_extension(const std::string& path) {
  const std::string_view extension = extension_of(path);
  const std::string found = extension.empty()
                                ? "it has no extension"
                                : fmt::format("'{}' is no image format that is written", extension);
  return failure(fmt::format("'{}' cannot be written: {}; expected one of {}", path, found,
                             writable_extensions));
}

Diagnostics cannot_write(const std::string& path, const Diagnostics& reasons) {
  Diagnostics found;
  for (const Diagnostic& reason : reasons.list())
    found.error({}, fmt::format("'{}' cannot be written: {}", path, reason.message));
  return found;
}

}  // namespace

Diagnostics check_writable_image(const std::string& path) {
  const auto format = format_of_extension(path);
  if (!format || !is_writable(*format)) return unknown_extension(path);
  if (is_encoded_by_codecs(*format))
    if (const Result<Codecs> others = codecs(); !others)
      return cannot_write(path, others.diagnostics);
  return check_writable_file(path);
}

Diagnostics check_image_size(const std::string& path, int width, int height) {
  const auto format = format_of_extension(path);
  if (!format) return {};
  return cannot_write(path, check_sides(*format, width, height));
}

Diagnostics write_image(const std::string& path, const Image& image, const WriteOptions& options) {
  const auto format = format_of_extension(path);
  if (!format || !is_writable(*format)) return unknown_extension(path);
  const Result<std::string> bytes = encode_image(*format, image, options);
  if (bytes) return write_file_atomically(path, *bytes);
  return cannot_write(path, bytes.diagnostics);
}

}  // namespace candela
