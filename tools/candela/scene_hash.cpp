#include "tools/candela/scene_hash.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

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

class File {
 public:
  // O_NONBLOCK: a FIFO without a writer must not hang us; only regular files are read.
  explicit File(const std::string& path)
      : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  [[nodiscard]] bool is_regular() const {
    struct stat status {};
    return descriptor_ >= 0 && ::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode);
  }
  // 0 at the end, -1 where reading fails.
  [[nodiscard]] ssize_t read(std::vector<unsigned char>& buffer) const {
    return ::read(descriptor_, buffer.data(), buffer.size());
  }

 private:
  int descriptor_;
};

// `buffer`: of any size but 0, for what is read of the file.
std::optional<Digest> digest_of_file(const std::string& path, std::vector<unsigned char>& buffer) {
  const File file(path);
  if (!file.is_regular()) return std::nullopt;
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> hash(XXH3_createState(),
                                                                      &XXH3_freeState);
  if (!hash) throw std::bad_alloc();
  XXH3_128bits_reset(hash.get());
  while (true) {
    const ssize_t count = file.read(buffer);
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
