#!/usr/bin/env bash
# tools/build.sh PRESET [TARGET...]: configures and builds; shows its log only when that fails.
# PRESET is release, asan, tsan or dev. A second build of the same preset waits for the first.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
case ${1:-} in
  release | asan | tsan | dev) preset=$1 ;;
  *)
    printf 'resect: error: there is no build named %q; choose release, asan, tsan or dev\n' "${1:-}" >&2
    exit 2
    ;;
esac
shift
cd "$root"

# The compiler cache needs a place that can be written, which a container may not have at $HOME.
if [[ ! -w ${HOME:-/nonexistent} && -z ${CCACHE_DIR:-} ]]; then export CCACHE_DIR="$root/build/ccache"; fi

targets=()
if (($#)); then targets=(--target "$@"); fi
log="build/$preset/build.log"
lock="build/$preset/build.lock"
if ! mkdir -p "build/$preset" 2>/dev/null || ! { : >>"$lock"; } 2>/dev/null; then
  echo "resect: error: $root/build/$preset cannot be written; copy Resect to a folder of your own and start it there" >&2
  exit 1
fi
# Two builds in one folder break each other. The lock goes with this process, however it ends.
exec 9>>"$lock"
if command -v flock >/dev/null && ! flock --nonblock 9; then
  echo "Waiting for another build of Resect ($preset) to end" >&2
  flock 9
fi
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
cmake --preset "$preset" >"$log" 2>&1 </dev/null 9>&- || failed
cmake --build --preset "$preset" "${targets[@]}" >>"$log" 2>&1 </dev/null 9>&- || failed
