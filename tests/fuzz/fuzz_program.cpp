// candela_fuzz READER [libFuzzer's options] [folders of inputs]
// libFuzzer's main calls what is here: each input goes to one of readers.h, and what that finds
// wrong ends the program, as what the sanitizers find does.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/fuzz/readers.h"

namespace {

using candela::fuzz::Reader;
using candela::fuzz::readers;

const Reader* chosen = nullptr;

const Reader* reader_of(const char* name) {
  if (name == nullptr) return nullptr;
  const auto found =
      std::find_if(readers.begin(), readers.end(), [&](const Reader& r) { return r.name == name; });
  return found == readers.end() ? nullptr : &*found;
}

[[noreturn]] void explain_and_exit() {
  std::fputs("usage: candela_fuzz READER [libFuzzer's options] [folders of inputs]\nREADER:",
             stderr);
  for (const Reader& reader : readers) std::fprintf(stderr, " %s", reader.name.data());
  std::fputc('\n', stderr);
  std::exit(2);
}

}  // namespace

// Takes the reader's name out of the arguments, which are libFuzzer's otherwise. libFuzzer starts
// itself again for -merge and -fork, without the name: then the environment has it.
extern "C" int LLVMFuzzerInitialize(int* count, char*** words) {
  constexpr const char* variable = "CANDELA_FUZZED";
  if ((chosen = reader_of(std::getenv(variable))) != nullptr) return 0;
  if (*count > 1) chosen = reader_of((*words)[1]);
  if (chosen == nullptr) explain_and_exit();
  setenv(variable, (*words)[1], 0);
  std::copy(*words + 2, *words + *count + 1, *words + 1);  // the null at the end, too
  --*count;
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t size) {
  const std::string fault = chosen->attempt({reinterpret_cast<const char*>(bytes), size});
  if (fault.empty()) return 0;
  std::fprintf(stderr, "%s: %s\n", chosen->name.data(), fault.c_str());
  std::abort();
}
