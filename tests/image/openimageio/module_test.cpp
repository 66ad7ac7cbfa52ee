// The module of codecs knows the programs that it was built with.
#include "renderer/image/openimageio/module.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include "renderer/image/codecs.h"

namespace candela {
namespace {

TEST(Unit_CodecsModule, GivesNothingToAProgramOfAnotherKey) {
  ASSERT_TRUE(codecs());
  void* const module = dlopen(codecs_file, RTLD_LAZY | RTLD_LOCAL);
  ASSERT_NE(module, nullptr) << dlerror();
  void* const entry = dlsym(module, codecs_entry);
  ASSERT_NE(entry, nullptr) << dlerror();
  for (const char* key : {"", "0.1.0", "another"})
    EXPECT_EQ(reinterpret_cast<CodecsEntry*>(entry)(key), nullptr) << key;
  dlclose(module);
}

}  // namespace
}  // namespace candela
