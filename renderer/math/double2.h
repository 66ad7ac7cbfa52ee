// Two doubles side by side.
#pragma once

namespace candela {

typedef double Double2 __attribute__((vector_size(16)));

}  // namespace candela
