// The only include of zlib.
#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>

#include <fmt/format.h>

#include "scene_io/text/file.h"

namespace candela::text {
namespace {

class Inflater {
 public:
  explicit Inflater(std::string_view bytes) {
    constexpr int gzip_only = 16;
    if (inflateInit2(&stream_, MAX_WBITS + gzip_only) != Z_OK) throw std::bad_alloc();
    // zlib does not write through next_in; its type only predates const.
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    left_ = bytes.size();
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  [[nodiscard]] bool is_at_end() const { return left_ == 0; }
  [[nodiscard]] std::size_t bytes_left() const { return left_; }
  // Fills as much of [out, out + size) as it can; adds to `filled`. zlib counts in 32 bits.
  int step(char* out, std::size_t size, std::size_t& filled) {
    constexpr std::size_t most = std::numeric_limits<uInt>::max();
    stream_.avail_in = static_cast<uInt>(std::min(left_, most));
    stream_.avail_out = static_cast<uInt>(std::min(size, most));
    stream_.next_out = reinterpret_cast<Bytef*>(out);
    const uInt given_in = stream_.avail_in;
    const uInt given_out = stream_.avail_out;
    const int status = inflate(&stream_, Z_NO_FLUSH);
    left_ -= given_in - stream_.avail_in;
    filled += given_out - stream_.avail_out;
    return status;
  }
  void restart() { inflateReset(&stream_); }
  // Whether only zeros follow, which tapes and disks pad files with.
  [[nodiscard]] bool is_padding_left() const {
    return std::all_of(stream_.next_in, stream_.next_in + left_, [](Bytef b) { return b == 0; });
  }

 private:
  z_stream stream_{};
  std::size_t left_ = 0;
};

}  // namespace

Result<std::string> inflate_gzip(std::string_view bytes, const std::string& name,
                                 const FileLimits& limits) {
  const auto allowed = [&limits](std::size_t compressed) {
    return std::min(limits.inflated_bytes,
                    std::max(limits.small_bytes, compressed * limits.inflation));
  };
  Inflater inflater(bytes);
  std::string out;
  std::size_t filled = 0;
  while (true) {
    if (filled == out.size()) {
      const std::uint64_t wanted =
          std::max<std::uint64_t>(std::min(bytes.size() * 4, limits.small_bytes), filled * 2) +
          4096;
      // One byte more than allowed, so that what fits exactly is told from what does not.
      out.resize(static_cast<std::size_t>(std::min(wanted, allowed(bytes.size()) + 1)));
    }
    const std::size_t before = filled;
    const int status = inflater.step(out.data() + filled, out.size() - filled, filled);
    const std::uint64_t most = allowed(bytes.size() - inflater.bytes_left());
    if (filled > most)
      return file_error(name, fmt::format("inflates to more than {} bytes; no more is read", most));
    if (status == Z_MEM_ERROR) throw std::bad_alloc();
    if (status == Z_STREAM_END && inflater.is_padding_left()) break;
    if (status == Z_STREAM_END) {
      inflater.restart();  // files may be put behind one another
    } else if (status != Z_OK || (filled == before && inflater.is_at_end())) {
      return file_error(name, inflater.is_at_end() ? "ends in the middle of its gzip data"
                                                   : "is not a sound gzip file");
    }
  }
  out.resize(filled);
  return out;
}

}  // namespace candela::text
