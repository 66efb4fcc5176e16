#!/usr/bin/env bash
# tools/make_gallery/make_gallery.sh [PROGRAM]: runs every scenario and writes the pictures and force plots of
# docs/gallery. Needs ImageMagick's convert.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
resect=${1:-$root/build/release/resect}
gallery="$root/docs/gallery"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# scenario, the picture to show (10 per second; last: the end)
shown() {
  local scenario=$1 picture=$2 plot=()
  if [[ $picture != last && $scenario != hang && $scenario != drop ]]; then plot=(--plot "$gallery/$scenario.svg"); fi
  "$resect" run "$scenario" --frames "$work/$scenario" --size 960x540 "${plot[@]}" >"$work/$scenario.txt"
  local file
  if [[ $picture == last ]]; then
    file=$(ls "$work/$scenario"/frame_*.png | tail -n 1)
  else
    file=$(printf '%s/%s/frame_%04d.png' "$work" "$scenario" "$picture")
  fi
  convert "$file" -resize 640x360 -colors 200 "PNG8:$gallery/$scenario.png"
  rm -r "${work:?}/$scenario"
}

for scenario in cut cut-120 cut-950 perforate perforate-120 perforate-950 deform deform-120 deform-950 resect-segment; do
  shown "$scenario" last
done
shown press 30
shown lift 40
shown incise 34
shown incise-under-traction 62
shown snip 70
shown resect-segment-elastic 72
shown hang 12
shown drop 20
