"""run.py PACKAGES PROGRAM FOLDER [PATTERN]: the tests of the Python package; 77 where it or numpy is missing.

PACKAGES: folder that holds the built package resect. PROGRAM: resect. FOLDER: for what the tests write.
"""
import os
import pathlib
import shutil
import sys
import unittest

packages, program, folder = map(os.path.abspath, sys.argv[1:4])
if not list(pathlib.Path(packages, "resect").glob("_core*.so")):
    print("skipped: the Python module is not built (tools/packages_python.txt)")
    sys.exit(77)
try:
    import numpy  # noqa: F401
except ImportError:
    print("skipped: python3-numpy is missing (tools/packages_python.txt)")
    sys.exit(77)
sys.path[:0] = [packages, os.path.dirname(os.path.abspath(__file__))]
# For the processes that tests start.
os.environ["PYTHONPATH"] = packages
os.environ["RESECT_PROGRAM"] = program
shutil.rmtree(folder, ignore_errors=True)
os.makedirs(folder)
os.chdir(folder)
found = unittest.defaultTestLoader.discover(os.path.dirname(os.path.abspath(__file__)),
                                            sys.argv[4] if len(sys.argv) > 4 else "*_test.py")
result = unittest.TextTestRunner(verbosity=2).run(found)
sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
