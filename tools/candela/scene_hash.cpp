#include "tools/candela/scene_hash.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <xxhash.h>

#include "renderer/base/regular_file.h"
#include "renderer/description/files_read.h"

namespace candela::cli {
namespace {

using Digest = std::array<unsigned char, sizeof(XXH128_canonical_t)>;

Digest canonical(XXH128_hash_t hash) {
  XXH128_canonical_t bytes;
  XXH128_canonicalFromHash(&bytes, hash);
  Digest digest{};
  std::copy(std::begin(bytes.digest), std::end(bytes.digest), digest.begin());
  return digest;
}

// `buffer`: of any size but 0, for what is read of the file.
std::optional<Digest> digest_of_file(const std::string& path, std::vector<unsigned char>& buffer) {
  const RegularFile file = open_regular_file(path);
  if (!file.descriptor.is_open()) return std::nullopt;
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> hash(XXH3_createState(),
                                                                      &XXH3_freeState);
  if (!hash) throw std::bad_alloc();
  XXH3_128bits_reset(hash.get());
  while (true) {
    const ssize_t count = read_some(file.descriptor, buffer.data(), buffer.size());
    if (count < 0) return std::nullopt;
    if (count == 0) return canonical(XXH3_128bits_digest(hash.get()));
    XXH3_128bits_update(hash.get(), buffer.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

std::string scene_hash(const description::SceneDescription& description) {
  std::map<std::string, Digest> known;  // each file is read once
  std::vector<unsigned char> buffer(std::size_t{1} << 20);
  std::vector<unsigned char> bytes;
  for (const std::string& path : description::files_read(description)) {
    const auto [entry, is_new] = known.try_emplace(path, Digest{});
    if (is_new) entry->second = digest_of_file(path, buffer).value_or(Digest{});
    bytes.insert(bytes.end(), entry->second.begin(), entry->second.end());
  }
  std::string text;
  for (const unsigned char byte : canonical(XXH3_128bits(bytes.data(), bytes.size())))
    text += fmt::format("{:02x}", byte);
  return text;
}

}  // namespace candela::cli
