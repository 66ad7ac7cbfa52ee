#include "scene_io/text/path.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "renderer/base/letter_case.h"
#include "scene_io/text/cursor.h"
#include "scene_io/text/source.h"

namespace candela::text {
namespace {

std::string cleaned(std::string_view name) {
  name = trimmed(name);
  if (name.size() >= 2 && name.front() == '"' && name.back() == '"') {
    name = trimmed(name.substr(1, name.size() - 2));
  }
  std::string path(name);
  std::replace(path.begin(), path.end(), '\\', '/');
  return path;
}

bool is_absolute(std::string_view path) {
  return path.starts_with('/') || (path.size() > 1 && path[1] == ':');
}

// Names with a zero byte would be cut short by the system and name another file.
bool exists(const std::string& path) {
  std::error_code error;
  return path.find('\0') == std::string::npos && std::filesystem::exists(path, error);
}

// What folders hold, read once each: scenes may name thousands of files that are not there.
class Listings {
 public:
  // The first entry, by name, that is `part` but for letter case.
  std::optional<std::string> find(const std::string& folder, std::string_view part) {
    const std::lock_guard lock(mutex_);
    Listing& listing = listings_[folder];
    const std::filesystem::path path = folder.empty() ? "." : folder;
    std::error_code error;
    const auto changed = std::filesystem::last_write_time(path, error);
    if (error || !listing.is_settled || changed != listing.changed) read(path, changed, listing);
    const auto found = listing.by_lower_case.find(to_lower(std::string(part)));
    if (found == listing.by_lower_case.end()) return std::nullopt;
    return found->second;
  }

 private:
  struct Listing {
    std::map<std::string, std::string> by_lower_case;
    std::filesystem::file_time_type changed;
    bool is_settled = false;
  };

  // A folder that has just changed may change again within one tick of the clock.
  static void read(const std::filesystem::path& path, std::filesystem::file_time_type changed,
                   Listing& listing) {
    constexpr std::chrono::seconds tick(2);
    listing = {{}, changed, changed + tick < std::filesystem::file_time_type::clock::now()};
    std::error_code error;
    std::filesystem::directory_iterator entry(path, error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
      std::string name = entry->path().filename().string();
      const auto [at, is_new] = listing.by_lower_case.try_emplace(to_lower(name), name);
      if (!is_new && name < at->second) at->second = std::move(name);
    }
  }

  std::mutex mutex_;
  std::map<std::string, Listing> listings_;
};

std::optional<std::string> entry_ignoring_case(const std::string& folder, std::string_view part) {
  static Listings listings;
  return listings.find(folder, part);
}

// Goes down part by part; where a part is not there, takes the entry of another letter case.
std::optional<std::string> find_ignoring_case(std::string path, std::string_view name) {
  while (!name.empty()) {
    const std::size_t slash = std::min(name.find('/'), name.size());
    const std::string_view part = name.substr(0, slash);
    name.remove_prefix(std::min(slash + 1, name.size()));
    if (part.empty()) continue;
    std::string next = path + std::string(part);
    if (!exists(next)) {
      const std::optional<std::string> entry = entry_ignoring_case(path, part);
      if (!entry) return std::nullopt;
      next = path + *entry;
    }
    path = std::move(next);
    if (!name.empty()) path += '/';
  }
  return path;
}

}  // namespace

std::string folder_of(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string_view::npos ? "" : std::string(path.substr(0, slash + 1));
}

ResolvedPath resolve_path(const std::string& referrer, std::string_view name) {
  const std::string folder = folder_of(referrer);
  const std::string relative = cleaned(name);
  if (relative.empty()) return {folder};
  const bool is_elsewhere = is_absolute(relative);
  const std::string expected = is_elsewhere ? relative : folder + relative;
  if (exists(expected)) return {expected, true};
  const std::string sought = is_elsewhere ? relative.substr(relative.rfind('/') + 1) : relative;
  if (sought.empty()) return {expected};
  if (is_elsewhere && exists(folder + sought)) return {folder + sought, true, false, true};
  if (const auto found = find_ignoring_case(folder, sought))
    return {*found, true, true, is_elsewhere};
  return {expected};
}

std::string describe_substitute(const ResolvedPath& found, std::string_view name) {
  return fmt::format("file {} is taken for {}{}", quoted_path(found.path), quoted(name),
                     found.is_elsewhere ? ", which does not exist" : ": letter case differs");
}

}  // namespace candela::text
