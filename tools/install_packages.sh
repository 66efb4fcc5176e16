#!/usr/bin/env bash
# Installs what tools/packages.txt names and this machine lacks. Says nothing when nothing is missing.
#   install_packages.sh [--list] [FILE]   another list in tools/; --list only names what is missing
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

only_list=false
if [[ ${1:-} == --list ]]; then only_list=true && shift; fi
mapfile -t wanted < <(sed 's/#.*//' "$here/${1:-packages.txt}" | tr -s ' \t' '\n\n' | sed '/^$/d')

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "resect: this is not Debian, so nothing was installed; the build needs what Debian 12 calls: ${wanted[*]}" >&2
  exit 0
fi

# Lines "NAME STATUS"; a package that was never seen here has no line.
installed=$(dpkg-query --show --showformat='${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null || true)
missing=()
for package in "${wanted[@]}"; do
  grep -qxF "$package installed" <<<"$installed" || missing+=("$package")
done
((${#missing[@]})) || exit 0
if $only_list; then echo "${missing[*]}" && exit 0; fi

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "resect: error: packages are missing and this is neither root nor is there sudo; have them installed: apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

echo "Installing ${#missing[@]} Debian packages: ${missing[*]}"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0 \
    -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300 "$@" >>"$log" 2>&1 </dev/null
}
if ! { apt update && apt install --yes --no-install-recommends "${missing[@]}"; }; then
  tail -n 20 "$log" >&2
  echo "resect: error: apt could not install ${missing[*]}; its last words are above" >&2
  exit 1
fi
