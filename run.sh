#!/usr/bin/env bash
# Installs what is missing, builds Resect, and starts it.
#   ./run.sh            with a display: the window; without: a segment of a liver is taken off, pictures and a summary
#   ./run.sh ARGS       the program with these arguments, e.g. ./run.sh --help
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

"$root/tools/install_packages.sh"
"$root/tools/build.sh" release resect
resect="$root/build/release/resect"

if (($#)); then exec "$resect" "$@"; fi

if [[ -n ${DISPLAY:-}${WAYLAND_DISPLAY:-} ]]; then exec "$resect" window; fi

output="$root/output/resect-segment"
rm -rf "$output"
mkdir -p "$output"
"$resect" run resect-segment --frames "$output" --surface "$output/surface.obj" --pieces "$output/pieces" --json "$output/summary.json"
echo
echo "Pictures, surface and summary: $output"
