"""Makes a wheel of the package resect: its Python files, the module that cmake builds, and Resect's data.

    python3 -m pip wheel --no-index --no-build-isolation --no-deps python
"""

import os
import pathlib
import shutil
import subprocess

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.build_py import build_py

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent
BUILD = ROOT / "build" / "python-wheel"


class BuildCore(build_ext):
    """Takes the module from the build of the library, which is brought up to date first."""

    def build_extension(self, extension):
        subprocess.check_call([str(ROOT / "tools" / "build.sh"), "release", "resect_python"])
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(ROOT / "build" / "release" / "python" / "resect" / target.name, target)


class BuildWithData(build_py):
    def run(self):
        super().run()
        data = pathlib.Path(self.build_lib) / "resect" / "data"
        shutil.rmtree(data, ignore_errors=True)
        shutil.copytree(ROOT / "data", data)


def version():
    for line in (ROOT / "CMakeLists.txt").read_text().splitlines():
        if line.startswith("project(resect VERSION"):
            return line.split()[2]
    raise SystemExit("CMakeLists.txt names no version of the project resect")


BUILD.mkdir(parents=True, exist_ok=True)
os.chdir(HERE)
setup(
    name="resect",
    version=version(),
    description="Real-time simulation of surgery on soft organs",
    license="Apache-2.0",
    python_requires=">=3.11",
    install_requires=["numpy"],
    packages=["resect", "resect.envs", "resect.sweep"],
    package_data={"resect": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("resect._core", [])],
    cmdclass={"build_ext": BuildCore, "build_py": BuildWithData},
    options={"build": {"build_base": str(BUILD)}, "egg_info": {"egg_base": str(BUILD)}},
)
