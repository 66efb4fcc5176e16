#!/usr/bin/env bash
# Checks that every C++ file that people write is formatted by .clang-format. Prints file:line of each that is not.
# With --fix: makes it so. Exits with 77 (a test that is skipped) where clang-format is not installed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if ! command -v clang-format >/dev/null; then
  echo "skipped: clang-format is not installed"
  exit 77
fi
folders=()
for folder in src devices test examples bench tools python; do if [[ -d $folder ]]; then folders+=("$folder"); fi; done
mapfile -t files < <(find "${folders[@]}" -name '*.h' -o -name '*.cpp' -o -name '*.inl' ! -name builtin_liver_shape.inl | sort)

if [[ ${1:-} == --fix ]]; then
  clang-format -i "${files[@]}"
else
  clang-format --dry-run -Werror "${files[@]}"
  echo "${#files[@]} files look as .clang-format says"
fi
