#!/usr/bin/env bash
# Runs clang-tidy with .clang-tidy over src/, or over the files given, two at a time.
# Needs clang-tidy 14 and a configured build/dev; exits with 1 when there is a finding.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if ! command -v clang-tidy >/dev/null; then
  echo "resect: error: clang-tidy is not installed; apt-get install clang-tidy" >&2
  exit 1
fi
[[ -f build/dev/compile_commands.json ]] || cmake --preset dev >/dev/null

files=("$@")
if ((!$#)); then mapfile -t files < <(find src -name '*.cpp' | sort); fi

# GCC's precompiled headers and options mean nothing to clang.
database=build/dev/tidy
mkdir -p "$database"
sed -E 's/ -include [^ ]*cmake_pch\.hxx//g; s/ -Winvalid-pch//g; s/ -Wno-maybe-uninitialized//g' \
  build/dev/compile_commands.json >"$database/compile_commands.json"

printf '%s\0' "${files[@]}" |
  xargs -0 -n 1 -P 2 clang-tidy -p "$database" --quiet 2> >(grep -v 'warnings generated' >&2)
echo "${#files[@]} files are tidy"
