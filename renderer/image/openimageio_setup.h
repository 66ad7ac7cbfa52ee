// OpenImageIO's process-wide settings, made once before its first use.
#pragma once

namespace candela {

// One thread a call, since decoding runs on the renderer's own threads and `--threads` counts them;
// and no guessing: a file that its reader refuses is not tried on all others.
void set_up_openimageio();

}  // namespace candela
