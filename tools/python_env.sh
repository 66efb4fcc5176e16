#!/usr/bin/env bash
# tools/python_env.sh [FOLDER]: makes a virtual environment in which `import resect` works; FOLDER: build/python.
# Installs missing Debian packages, builds what of the library is not built, and asks no package index.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
folder=${1:-$root/build/python}

"$root/tools/install_packages.sh"
"$root/tools/install_packages.sh" packages_python.txt
if [[ -e $folder && ! -f $folder/pyvenv.cfg ]]; then
  echo "resect: error: $folder is there and is no virtual environment; name another folder" >&2
  exit 1
fi
"$root/tools/build.sh" release resect_python
# Debian's python by its path: its packages are not for another python3 that may be the first on PATH.
/usr/bin/python3 -m venv --system-site-packages "$folder"
log=$folder/install.log
if ! "$folder/bin/python" -m pip install --no-index --no-build-isolation --no-deps --force-reinstall --quiet \
  --disable-pip-version-check "$root/python" >"$log" 2>&1; then
  tail -n 20 "$log" >&2
  echo "resect: error: the Python package could not be installed into $folder; all of pip's output is in $log" >&2
  exit 1
fi
version=$("$folder/bin/python" -c 'import resect; print(resect.__version__)')
echo "Python package resect $version is in $folder; now: source $folder/bin/activate"
