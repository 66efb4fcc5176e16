#!/usr/bin/env bash
# tools/make_gallery/make_gallery.sh [PROGRAM [SCENARIO...]]: runs every scenario, or only those that are named, and writes
# their pictures and force plots of docs/gallery, and the README's pictures and film of scenarios. Needs ImageMagick's
# convert and montage, and ffmpeg.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
resect=${1:-$root/build/release/resect}
only=" ${*:2} "
gallery="$root/docs/gallery"
images="$root/docs/images"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Whether a scenario is to be drawn.
wanted() { [[ -z ${only// /} || $only == *" $1 "* ]]; }

# scenario, the picture to show (10 per second; last: the end)
shown() {
  local scenario=$1 picture=$2 plot=() size=960x540
  wanted "$scenario" || return 0
  if [[ $picture == last ]]; then size=1280x720; fi
  if [[ $picture != last && $scenario != hang && $scenario != drop ]]; then plot=(--plot "$gallery/curves/$scenario.svg"); fi
  "$resect" run "$scenario" --frames "$work/$scenario" --size "$size" "${plot[@]}" >"$work/$scenario.txt"
  convert "$(picture "$scenario" "$picture")" -resize 640x360 -colors 200 "PNG8:$(drawn "$scenario")"
}

# The file of the gallery for a scenario.
drawn() {
  case $1 in
    bleed | stop-bleeding | bare-clip-divide | transect | pringle | cautery) echo "$gallery/blood/$1.png" ;;
    *) echo "$gallery/$1.png" ;;
  esac
}

# The file of a picture that was made.
picture() {
  if [[ $2 == last ]]; then
    ls "$work/$1"/frame_*.png | tail -n 1
  else
    printf '%s/%s/frame_%04d.png' "$work" "$1" "$2"
  fi
}

# For the README: a scenario's end.
large() {
  wanted "$1" || return 0
  convert "$(picture "$1" last)" -resize 1120x630 -colors 250 "PNG8:$images/${1//-/_}.png"
}

# For the README: a film strip of six pictures, cut to where things happen (WxH+X+Y of 960x540).
strip() {
  local scenario=$1 part=$2 files=() number
  wanted "$scenario" || return 0
  shift 2
  for number in "$@"; do files+=("$(picture "$scenario" "$number")"); done
  montage "${files[@]}" -crop "$part" +repage -tile 3x2 -geometry 450x+2+2 "$work/strip.png"
  convert "$work/strip.png" -colors 220 "PNG8:$images/${scenario//-/_}.png"
}

# For the README: a scenario as a film, four times as fast.
film() {
  wanted "$1" || return 0
  "$resect" run "$1" --frames "$work/film" --size 640x360 --picture-rate 2.5 >"$work/film.txt"
  ffmpeg -loglevel error -y -framerate 10 -i "$work/film/frame_%04d.png" -c:v libwebp_anim -quality 55 -loop 0 \
    "$images/${1//-/_}.webp"
}
film transect

for scenario in cut cut-120 cut-950 perforate perforate-120 perforate-950 deform deform-120 deform-950 resect-segment; do
  shown "$scenario" last
done
# docs/look.md: one moment of one scenario on the table, in the field, and by a laparoscope.
look() {
  wanted incise || return 0
  "$resect" run incise --frames "$work/look" --size 960x540 --picture-rate 0.2 --overwrite "${@:2}" >"$work/look.txt"
  convert "$work/look/frame_0002.png" -resize 640x360 -colors 220 "PNG8:$gallery/look/$1.png"
}
look table --setting table
look field
look laparoscope --view laparoscope

for scenario in perforate deform resect-segment; do large "$scenario"; done
shown press 30
shown lift 40
shown incise 44
shown incise-under-traction 64
shown bleed 80
shown stop-bleeding 105
shown transect 1100
shown bare-clip-divide 205
shown pringle 110
shown cautery 205
shown snip 70
shown resect-segment-elastic 134
shown liver-and-gallbladder 34
shown hang 12
shown drop 20
strip incise-under-traction 960x540+0+0 24 42 48 56 64 last
# The cut and its bleeding, and what stops it.
if wanted bleed && wanted stop-bleeding; then
  montage "$(picture bleed 26)" "$(picture bleed 41)" "$(picture bleed 56)" "$(picture stop-bleeding 56)" \
    "$(picture stop-bleeding 81)" "$(picture stop-bleeding 146)" -tile 3x2 -geometry 450x+0+0 "$work/blood.png"
  convert "$work/blood.png" -colors 220 "PNG8:$images/stop_bleeding.png"
fi
strip transect 960x540+0+0 60 105 150 300 620 1120
strip resect-segment-elastic 960x540+0+0 14 41 62 98 116 134
