// Broken copies of files, the same for the same seed.
#pragma once

#include <array>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>

namespace candela {

// How many copies of a sample a test tries.
inline int mutation_count() {
  return std::getenv("CANDELA_HEAVY") != nullptr ? 100'000 : 10'000;
}

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  // One to four changes: a byte, a stretch removed, doubled or moved, or a nasty word put in.
  std::string operator()(std::string text) {
    for (int changes = below(4) + 1; changes > 0; --changes) change(text);
    return text;
  }

 private:
  static constexpr std::array<std::string_view, 24> words{
      "nan", "-inf",   "1e999", "1e-999", "-1",   "0",  "4294967296", "99999999999999999999",
      "/",   "//",     "\\\n",  "\n",     "\r\n", "#",  "f 1 2 3",    "f -1 -2 -3",
      "v",   "usemtl", "g",     "list",   "-bm",  "..", "1.#QNAN",    "0x10"};

  int below(std::size_t count) {
    return static_cast<int>(random_() % static_cast<unsigned long>(count));
  }
  std::size_t place(const std::string& text) {
    return static_cast<std::size_t>(below(text.size() + 1));
  }

  void change(std::string& text) {
    const std::size_t at = place(text);
    const auto length = static_cast<std::size_t>(below(24));
    switch (below(6)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(below(256));
        break;
      case 1:
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(place(text), text.substr(at, length));
        break;
      case 4:
        text.insert(at, words[static_cast<std::size_t>(below(words.size()))]);
        break;
      default:
        text.resize(at);
        break;
    }
  }

  std::mt19937 random_;
};

}  // namespace candela
