#!/usr/bin/env bash
# tools/other_machines.sh [BUILD [PROGRAM]]: builds the core for aarch64 and WebAssembly below BUILD (build/machines), plays
# 120 frames of a scenario of moving and one of still tissue on each (qemu-user, node) and by PROGRAM
# (build/release/machine_states) on this one, and compares the state hashes.
# Exits with 77 where a tool is missing, with 1 where a hash differs or a build fails, with 2 where PROGRAM is missing. Needs the packages of tools/packages_machines.txt.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${1:-$root/build/machines}
program=${2:-$root/build/release/machine_states}
frames=120
scenarios=(press resect-segment)

if [[ ! -x $program ]]; then
  echo "there is no $program; run tools/build.sh release"
  exit 2
fi
for tool in cmake ninja aarch64-linux-gnu-g++ qemu-aarch64 em++ node; do
  if ! command -v "$tool" >/dev/null; then
    echo "skipped: there is no $tool; tools/install_packages.sh packages_machines.txt installs it"
    exit 77
  fi
done

# Header-only libraries alone: the rest of /usr/include is this machine's.
headers="$build/headers"
mkdir -p "$headers/include"
for library in fmt toml++; do ln -sfn "/usr/include/$library" "$headers/include/$library"; done
describe() {  # NAME TARGET DEFINITION: a package that is its headers
  mkdir -p "$headers/lib/cmake/$1"
  cat >"$headers/lib/cmake/$1/$1-config.cmake" <<END
if(NOT TARGET $2)
  add_library($2 INTERFACE IMPORTED)
  target_include_directories($2 SYSTEM INTERFACE "$headers/include")
  target_compile_definitions($2 INTERFACE $3)
endif()
END
}
describe fmt fmt::fmt FMT_HEADER_ONLY
describe tomlplusplus tomlplusplus::tomlplusplus TOML_HEADER_ONLY=1

export NODE_PATH=${NODE_PATH:-/usr/share/nodejs}
unset EM_CACHE
built() {  # NAME OPTIONS...
  local name=$1
  shift
  local log="$build/$name.log"
  if ! { cmake -S "$root/test/machines" -B "$build/$name" -G Ninja -DCMAKE_BUILD_TYPE=Release \
           -Dfmt_DIR="$headers/lib/cmake/fmt" -Dtomlplusplus_DIR="$headers/lib/cmake/tomlplusplus" \
           -DEigen3_DIR=/usr/share/eigen3/cmake "$@" &&
         ninja -C "$build/$name" machine_states; } >"$log" 2>&1; then
    tail -n 30 "$log"
    echo "the build for $name failed; all it said is in $log"
    exit 1
  fi
}
built aarch64 -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ \
  -DCMAKE_EXE_LINKER_FLAGS=-static
built wasm -DCMAKE_TOOLCHAIN_FILE=/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake

export RESECT_DATA=$root/data
"$program" $frames "${scenarios[@]}" >"$build/here.txt"
qemu-aarch64 "$build/aarch64/machine_states" $frames "${scenarios[@]}" >"$build/aarch64.txt"
node --no-experimental-fetch "$build/wasm/machine_states.js" $frames "${scenarios[@]}" >"$build/wasm.txt"

status=0
printf '%-16s %-10s %-18s %s\n' scenario machine state seconds
for scenario in "${scenarios[@]}"; do
  expected=$(awk -v s="$scenario" '$1 == s {print $2}' "$build/here.txt")
  for machine in here aarch64 wasm; do
    if ! read -r _ state seconds < <(grep "^$scenario " "$build/$machine.txt"); then
      echo "$scenario on $machine printed no state; see $build/$machine.txt"
      exit 1
    fi
    printf '%-16s %-10s %-18s %s\n' "$scenario" "$machine" "$state" "$seconds"
    if [[ $state != "$expected" ]]; then
      echo "  $machine differs"
      status=1
    fi
  done
done
exit $status
