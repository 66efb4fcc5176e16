#!/usr/bin/env bash
# Installs what is missing, builds Resect, and starts it.
#   ./run.sh            with a display: the window; without: part of a liver is taken off; pictures and a summary
#   ./run.sh ARGS       the program with these arguments, e.g. ./run.sh --help
#   ./run.sh bench --peers [ARGS]   times it beside VTK, OpenVDB, Embree and FCL, those that are installed;
#                                   ARGS: see ./run.sh bench --peers --help
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

"$root/tools/install_packages.sh"
if [[ ${1:-} == bench && ${2:-} == --peers ]]; then
  shift 2
  missing=$("$root/tools/install_packages.sh" --list packages_optional.txt)
  if [[ -n $missing && -t 0 ]]; then
    read -r -p "To compare with all of them, $missing are missing. Install them? [y/N] " answer
    if [[ $answer == [yY]* ]]; then "$root/tools/install_packages.sh" packages_optional.txt; fi
  fi
  "$root/tools/build.sh" release resect_peers
  exec "$root/build/release/resect_peers" "$@"
fi
"$root/tools/build.sh" release resect
resect="$root/build/release/resect"

if (($#)); then exec "$resect" "$@"; fi

if [[ -n ${DISPLAY:-}${WAYLAND_DISPLAY:-} ]]; then exec "$resect" window; fi

# One at a time, since each begins by clearing the folder.
output="$root/output/resect-segment-elastic"
if ! mkdir -p "$output" 2>/dev/null || ! { : >>"$root/output/lock"; } 2>/dev/null; then
  echo "resect: error: $output cannot be written; copy Resect to a folder of your own and start it there" >&2
  exit 1
fi
exec 9>>"$root/output/lock"
if command -v flock >/dev/null && ! flock --nonblock 9; then
  echo "Waiting for another ./run.sh to end" >&2
  flock 9
fi
rm -rf "$output"
mkdir -p "$output"
"$resect" run resect-segment-elastic --frames "$output" --surface "$output/surface.obj" --pieces "$output/pieces" --json "$output/summary.json" 9>&-
echo
echo "Pictures, surface and summary: $output"
