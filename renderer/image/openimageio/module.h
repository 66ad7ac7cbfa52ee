// What the program and the module of OpenImageIO's codecs know of each other.
#pragma once

namespace candela {

struct Codecs;

inline constexpr const char* codecs_file = "candela_codecs.so";
inline constexpr const char* codecs_entry = "candela_codecs";

// Null where `key` is not the module's own: then what they share need not look alike.
using CodecsEntry = const Codecs*(const char* key);

}  // namespace candela
