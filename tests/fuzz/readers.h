// What the fuzzers do with a file: one function a reader. libFuzzer calls them (fuzz_program.cpp,
// preset `fuzz`), and the ordinary tests do with every file of corpus/ (corpus_test.cpp).
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace candela::fuzz {

// Reads `bytes` as the content of such a file. Returns what is wrong with what came of it: "" where
// it is a sound result, or errors that are sentences.
[[nodiscard]] std::string try_lab3(std::string_view bytes);  // compiles the scene, too
[[nodiscard]] std::string try_pbrt(std::string_view bytes);  // compiles the scene, too
[[nodiscard]] std::string try_obj(std::string_view bytes);
[[nodiscard]] std::string try_mtl(std::string_view bytes);
[[nodiscard]] std::string try_ply(std::string_view bytes);
[[nodiscard]] std::string try_gzip(std::string_view bytes);
[[nodiscard]] std::string try_text(std::string_view bytes);  // words, numbers, lines and places
// Images: nothing is done with what begins as an image of another format.
[[nodiscard]] std::string try_exr(std::string_view bytes);
[[nodiscard]] std::string try_png(std::string_view bytes);
[[nodiscard]] std::string try_jpeg(std::string_view bytes);
[[nodiscard]] std::string try_hdr(std::string_view bytes);
[[nodiscard]] std::string try_tiff(std::string_view bytes);
[[nodiscard]] std::string try_bmp(std::string_view bytes);
[[nodiscard]] std::string try_tga(std::string_view bytes);
[[nodiscard]] std::string try_pnm(std::string_view bytes);

struct Reader {
  std::string_view name;  // of its folder in corpus/, too
  std::string (*attempt)(std::string_view bytes);
};
inline constexpr std::array readers{
    Reader{"lab3", try_lab3}, Reader{"pbrt", try_pbrt}, Reader{"obj", try_obj},
    Reader{"mtl", try_mtl},   Reader{"ply", try_ply},   Reader{"gzip", try_gzip},
    Reader{"text", try_text}, Reader{"exr", try_exr},   Reader{"png", try_png},
    Reader{"jpeg", try_jpeg}, Reader{"hdr", try_hdr},   Reader{"tiff", try_tiff},
    Reader{"bmp", try_bmp},   Reader{"tga", try_tga},   Reader{"pnm", try_pnm}};

}  // namespace candela::fuzz
