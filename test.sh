#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test on the build that people use.
# ./test.sh --all builds the benchmarks too, and runs the suite again under the sanitizers:
#   asan      the whole suite under the address and undefined-behaviour sanitizers
#   tsan      the parallel parts under the thread sanitizer
# ./test.sh NAME... runs the builds named: release, asan, tsan, dev.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$root"

(($#)) || set -- release
builds=()
for name in "$@"; do
  case $name in
    release | asan | tsan | dev) builds+=("$name") ;;
    --all) builds+=(release asan tsan) ;;
    *)
      printf 'resect: error: ./test.sh knows --all and the names release, asan, tsan and dev, not %q\n' "$name" >&2
      exit 2
      ;;
  esac
done

tools/install_packages.sh
tools/install_packages.sh packages_python.txt

summary=""
for build in "${builds[@]}"; do
  started=$SECONDS
  selection=()
  targets=()
  if [[ $build == release ]] && ((${#builds[@]} > 1)); then tools/build.sh release benchmarks; fi
  if [[ $build == tsan ]]; then
    selection=(-L parallel)
    targets=(parallel_tests)
  fi
  tools/build.sh "$build" "${targets[@]}"
  built=$((SECONDS - started))
  log="build/$build/test.log"
  echo "== $build: built in $built s, testing"
  passed=yes
  ctest --preset "$build" --parallel 2 --no-tests=error "${selection[@]}" </dev/null 2>&1 | tee "$log" || passed=no
  summary+=$(printf '%-8s %5d s  %s' "$build" $((SECONDS - started)) "$(grep -a 'tests passed' "$log" || echo 'no test ran')")$'\n'
  if [[ $passed == no ]]; then
    printf '\n%s' "$summary"
    echo "resect: error: tests failed in the $build build; their output is above and in $root/$log" >&2
    exit 1
  fi
done
printf '\n%s' "$summary"
