#include "renderer/image/codecs.h"

#include <dlfcn.h>

#include <atomic>
#include <new>
#include <string_view>

#include <fmt/format.h>

#include "renderer/base/floating_point_traps.h"
#include "renderer/image/openimageio/module.h"

#if defined(CANDELA_ADDRESS_SANITIZER)
// Its search for leaks would read modules' thread-local storage where it takes it to be, and end by
// a signal (seen with GCC 12 and glibc 2.36).
extern "C" const char* __asan_default_options() {
  return "intercept_tls_get_addr=0";
}
#endif

namespace candela {
namespace {

// Throws where memory for it lacks, of which glibc tells in these words.
Diagnostics not_loaded() {
  const char* const told = dlerror();
  const std::string_view reason = told ? told : "no reason is given";
  for (const std::string_view lack : {"failed to map segment", "annot allocate memory"})
    if (reason.find(lack) != std::string_view::npos) throw std::bad_alloc();
  return failure(fmt::format("needs candela's image codecs, which cannot be loaded: {}", reason));
}

Result<Codecs> load() {
  const FloatingPointTraps traps(Traps::Off);
  void* const module = dlopen(codecs_file, RTLD_LAZY | RTLD_LOCAL);
  if (module == nullptr) return not_loaded();
  void* const entry = dlsym(module, codecs_entry);
  if (entry == nullptr) return not_loaded();
  const Codecs* const found = reinterpret_cast<CodecsEntry*>(entry)(CANDELA_CODECS_KEY);
  if (found == nullptr)
    return failure(
        fmt::format("needs candela's image codecs, and {} is of another version", codecs_file));
  return Codecs{*found};
}

std::atomic<bool> were_asked_for{false};

}  // namespace

// The module stays to the end of the process: its libraries have threads and tables of their own.
Result<Codecs> codecs() {
  static const Result<Codecs> loaded = load();
  were_asked_for = true;
  return loaded;
}

Diagnostics why_codecs_are_missing() {
  return were_asked_for ? codecs().diagnostics : Diagnostics{};
}

}  // namespace candela
