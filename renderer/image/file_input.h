// Bytes of files that the user names: regular files only, so that a FIFO or a device given as a
// texture neither blocks nor never ends.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "renderer/base/result.h"

namespace candela {

using Bytes = std::vector<unsigned char>;

// The whole file. A path that is missing, forbidden, no regular file or larger than `max_bytes`
// gives one error that begins with the quoted path.
[[nodiscard]] Result<Bytes> read_regular_file(const std::string& path, std::size_t max_bytes);

}  // namespace candela
