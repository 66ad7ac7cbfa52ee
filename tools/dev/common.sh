# What the commands in tools/ share. Sourced by them, after `set -euo pipefail`.
# Everything here speaks on standard error: standard output belongs to the programs that are run.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

say() { printf 'candela: %s\n' "$*" >&2; }
fail() {
  say "$*"
  exit 1
}

jobs_at_once() { nproc 2>/dev/null || echo 2; }

# configure PRESET: once, and again when the presets change, the folder was moved or another
# distribution's packages came in. CMake itself notices every other change while it builds.
configure() {
  local folder=$root/build/$1 wanted
  wanted="$root $(cksum < "$root/CMakePresets.json")"
  if [[ -f $folder/build.ninja && -f $folder/.configured && $(< "$folder/.configured") == "$wanted" ]]; then
    return
  fi
  say "configuring build/$1"
  (cd "$root" && cmake --preset "$1" --fresh >&2) ||
    fail "CMake could not configure build/$1; what it asks for is printed above."
  printf '%s\n' "$wanted" > "$folder/.configured"
}

# build PRESET [TARGET]: says nothing when there is nothing to do.
build() {
  configure "$1"
  (cd "$root" && cmake --build --preset "$1" --target "${2:-all}" 2>&1) |
    sed -u -e '/no work to do/d' -e '/Re-checking globbed directories/d' >&2 ||
    fail "the build in build/$1 failed; the first error above is the one to read."
}
