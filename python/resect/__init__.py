"""Resect: soft organs that can be pressed, pulled and cut, stepped from Python.

    import resect
    simulation = resect.Simulation(resect.Scenario("press"))
    report = simulation.step(simulation.scenario.inputs(0))
    points = simulation.organ().points()            # [n, 3] float32, m

Units are metres, kilograms, seconds and newtons; the world is right-handed with Y up, the table's top at y = 0. The
same inputs give the same bits. Whatever is wrong with an argument, a file or a setting gives a resect.Error with one
sentence that says what to do.
"""

import os as _os
import pathlib as _pathlib

_data = _pathlib.Path(__file__).parent / "data"
if _data.is_dir():  # in a wheel, which brings its own
    _os.environ.setdefault("RESECT_DATA", str(_data))

from ._core import (  # noqa: E402
    Camera, Edit, Error, Organ, OrganState, Recording, Report, Scenario, Simulation, Verification, __version__,
    data_folder, scenario_names, score, set_threads, task_names, verify, write_png)

#: Columns of the rows by which instruments are moved: position in m, a unit quaternion, the closing of jaws (0 wide
#: open, 1 closed), the pedal (0 released, 1 pressed), and whether the instrument is in hand (0 or 1).
TOOL_COLUMNS = ("x", "y", "z", "qx", "qy", "qz", "qw", "squeeze", "pedal", "in_hand")

__all__ = ["Camera", "Edit", "Error", "Organ", "OrganState", "Recording", "Report", "Scenario", "Simulation",
           "TOOL_COLUMNS", "Verification", "__version__", "data_folder", "scenario_names", "score", "set_threads",
           "task_names", "verify", "write_png"]

for _name in __all__:
    if isinstance(globals()[_name], type):
        globals()[_name].__module__ = "resect"  # where people find it
