#!/usr/bin/env bash
# tools/build.sh PRESET [TARGET...]: configures and builds; shows its log only when that fails.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=$1
shift
cd "$root"

# The compiler cache needs a place that can be written, which a container may not have at $HOME.
if [[ ! -w ${HOME:-/nonexistent} && -z ${CCACHE_DIR:-} ]]; then export CCACHE_DIR="$root/build/ccache"; fi

targets=()
if (($#)); then targets=(--target "$@"); fi
mkdir -p "build/$preset"
log="build/$preset/build.log"
[[ -f build/$preset/build.ninja ]] || echo "Building Resect ($preset); the first time takes some minutes"

failed() {
  local signs='error:|Error at|FAILED:|undefined reference'
  if grep -qaE "$signs" "$log"; then
    grep -aE -m 5 -A 12 "$signs" "$log" >&2
  else
    tail -n 30 "$log" >&2
  fi
  echo "resect: error: the $preset build failed; all of its output is in $root/$log" >&2
  exit 1
}
cmake --preset "$preset" >"$log" 2>&1 </dev/null || failed
cmake --build --preset "$preset" "${targets[@]}" >>"$log" 2>&1 </dev/null || failed
