"""A data set of 100 cuts with pictures, depth, labels, poses and forces, in the layout of robomimic.

    python3 05_data_set_of_cuts.py [FOLDER] [NUMBER]

python3 -m resect.dataset does the same with options of its own.
"""
import pathlib
import sys

import h5py
import numpy as np
from resect import dataset

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "cuts")
number = int(sys.argv[2]) if len(sys.argv) > 2 else 100

reached = dataset.write_demos(folder, "Incise", number, observation=("state", "rgb", "depth", "labels"),
                              options={"picture": [64, 64], "particles": 500})
print(f"{number} cuts, {reached} along the whole line")
print(f"{dataset.export_pictures(folder)} files below {folder / 'pictures'}")

with h5py.File(folder / "demos.hdf5") as file:
    demo = file["data/demo_0"]
    print(f"{file['data'].attrs['total']} decisions; of the first cut:")
    for name, array in demo["obs"].items():
        print(f"  {name:7} {array.shape} {array.dtype}")
    labels = demo["obs/labels"][:]
    assert (labels == 256).any() and (labels == 16).any()  # liver and scalpel are seen
    assert np.isfinite(demo["obs/depth"][:]).all()

# The actions of a cut lead from its first state to the state at its end, bit for bit.
assert dataset.replay(folder, number - 1)
print((folder / "README.md").read_text().split("\n\n")[2])
assert reached == number
