#!/usr/bin/env bash
# tools/fuzz.sh [HOURS | --seconds N] [BUILD]: builds the fuzz targets of the readers that are ours (test/fuzz) below
# BUILD (build/fuzz) with clang and its sanitizers, and runs each for so long (10 s), two at a time. What a longer run finds is
# added to BUILD/found/TARGET, where the next run begins; an input that breaks a reader lies in BUILD/broken.
# Exits with 77 where clang is missing, with 1 where a reader broke or did not build.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
seconds=10
if [[ ${1:-} == --seconds ]]; then
  seconds=${2:-}
  shift $(($# > 1 ? 2 : 1))
elif (($#)); then
  seconds=$(awk -v hours="$1" 'BEGIN { print int(3600 * hours) }')
  shift
fi
build=${1:-$root/build/fuzz}

if ! command -v clang++ >/dev/null; then
  echo "skipped: there is no clang++; tools/install_packages.sh installs it"
  exit 77
fi
if ! [[ $seconds =~ ^[1-9][0-9]*$ ]]; then
  echo "resect: error: that is no time; use tools/fuzz.sh 2 for two hours a target, or --seconds 30" >&2
  exit 2
fi
mkdir -p "$build/broken"
log="$build/build.log"
if ! { cmake -S "$root/test/fuzz" -B "$build" -G Ninja -DCMAKE_CXX_COMPILER=clang++ && ninja -C "$build"; } \
  >"$log" 2>&1; then
  tail -n 30 "$log"
  echo "resect: error: the fuzz targets were not built; all of the output is in $log" >&2
  exit 1
fi

run() {  # TARGET SEED_FOLDER...
  local target=$1
  shift
  mkdir -p "$build/found/$target"
  if "$build/${target}_fuzz" -max_total_time="$seconds" -max_len=65536 -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 \
    -artifact_prefix="$build/broken/$target-" "$build/found/$target" "$@" >"$build/$target.log" 2>&1; then
    printf '%-16s %10s inputs, %s places of the code reached\n' "$target" \
      "$(sed -n 's/.*number_of_executed_units: *//p' "$build/$target.log")" \
      "$(grep -oE 'cov: [0-9]+' "$build/$target.log" | tail -n 1 | cut -d' ' -f2)"
  else
    printf '%-16s BROKE; the input is in %s\n' "$target" "$build/broken"
    grep -aE 'ERROR|runtime error|no whole sentence|Test unit' "$build/$target.log" | head -n 5
    return 1
  fi
}

failed=0
waiting=()
for source in "$root"/test/fuzz/*_fuzz.cpp; do
  target=$(basename "$source" _fuzz.cpp)
  seeds=("$root/test/fuzz/corpus/$target")
  [[ $target == scenario ]] && seeds+=("$root/data/scenarios")
  [[ $target == tool ]] && seeds+=("$root/data/tools")
  run "$target" "${seeds[@]}" &
  waiting+=($!)
  if ((${#waiting[@]} == 2)); then
    wait "${waiting[0]}" || failed=1
    waiting=("${waiting[1]}")
  fi
done
for process in "${waiting[@]}"; do wait "$process" || failed=1; done
exit $failed
