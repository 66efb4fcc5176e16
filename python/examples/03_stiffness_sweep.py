"""How does the force on a baton depend on the stiffness of the tissue? A sweep by Dask on two workers of this machine.

    python3 03_stiffness_sweep.py [FOLDER]

On many machines: start `dask-scheduler` on one and `dask-worker tcp://HOST:8786` on each, then give --dask
tcp://HOST:8786 instead of local.
"""
import pathlib
import sys

from resect.sweep import read_table
from resect.sweep.__main__ import main as sweep

SWEEP = """
scenario = "press"
[fixed]
"organ.spacing" = "20mm"
frame_rate = 30
duration = 2.6
[vary]
"tissue.young" = [2500, 5000, 10000, 20000]
"tool.baton.shift_y" = [-0.01, -0.02]
"""


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "stiffness")
    folder.mkdir(exist_ok=True)
    plan, table = folder / "stiffness.toml", folder / "stiffness.csv"
    plan.write_text(SWEEP)
    assert sweep([str(plan), "--output", str(table), "--dask", "local", "--workers", "2"]) == 0
    rows = read_table(table)
    print("Young's modulus, kPa   deeper by, mm   peak force, N")
    for row in rows:
        print(f"{float(row['tissue.young']) / 1e3:20.1f}   {-1e3 * float(row['tool.baton.shift_y']):13.0f}   "
              f"{float(row['peak_force_n.baton']):13.2f}")
    # Stiffer tissue and deeper pressing both push back harder.
    for shift in ("-0.01", "-0.02"):
        forces = [float(r["peak_force_n.baton"]) for r in rows if r["tool.baton.shift_y"] == shift]
        assert forces == sorted(forces), forces
    assert sweep([str(plan), "--output", str(table), "--verify", "2"]) == 0


if __name__ == "__main__":
    main()
