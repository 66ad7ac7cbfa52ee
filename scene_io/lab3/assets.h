// Files that a scene file names: found beside it, and never anything but regular files.
#pragma once

#include <string>

#include "scene_io/lab3/fields.h"
#include "scene_io/lab3/reader.h"

namespace candela::lab3 {

// "no such file", "this is a folder", "this is a FIFO", ... or "" for a regular file. Follows
// links, opens nothing.
[[nodiscard]] std::string problem_of_file(const std::string& path);

// The path that `name`, written in the scene file, means. Warns where only the letter case differs.
[[nodiscard]] std::string resolved(Reader& reader, std::size_t offset, const std::string& name);

// A file that must be there, under `entry`: its path, or an error and "".
[[nodiscard]] std::string required_file(Reader& reader, const Entry& entry, std::string_view what);

// An image under `entry` (null gives no image). A missing one is no error here: it renders magenta
// and is warned of when its header is read. Anything but a regular file is an error.
[[nodiscard]] description::ImageHandle read_image(Reader& reader, const Entry* entry,
                                                  description::Encoding encoding,
                                                  description::Wrap wrap);

// An image under `map` that takes the place of the number under `factor`, of which a warning tells.
// Either may be null.
[[nodiscard]] description::ImageHandle read_image_over(Reader& reader, const Entry* factor,
                                                       const Entry* map,
                                                       description::Encoding encoding);

// An image that must be there.
[[nodiscard]] description::ImageHandle read_required_image(Reader& reader, const Entry& entry,
                                                           description::Encoding encoding,
                                                           description::Wrap wrap);

}  // namespace candela::lab3
