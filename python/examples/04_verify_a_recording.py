"""Records an operation of our own, verifies it bit by bit, plays it, and finds what a changed byte does.

    python3 04_verify_a_recording.py [FOLDER]
"""
import pathlib
import sys

import numpy as np
import resect
from resect.envs import Incise

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
file = folder / "incision.resect"
file.unlink(missing_ok=True)

# An environment finds the line; a simulation made from the same scenario is recorded.
env = Incise(particles=500)
env.reset(seed=1)
simulation = resect.Simulation(env.simulation.scenario)
simulation.record(str(file))
over = False
while not over:
    *_, terminated, truncated, info = env.step(env.scripted_action())
    over = terminated or truncated
    simulation.step(env.simulation.tools())
simulation.end_recording()
print(f"{file}: {simulation.frame} frames, {file.stat().st_size / 1e3:.0f} kB, {info['cut']} points of the line cut")

found = resect.verify(str(file))
print(f"verified {found.frames} frames by {found.program}: {'the same bits' if found else found.difference}")
assert found

recording = resect.Recording(str(file))
cut = 0
while (frame := recording.step()) is not None:
    tools, duration, report = frame
    cut += report.severed
assert recording.state_hash == simulation.state_hash
samples = recording.samples()
print(f"played again: {cut} bonds severed, at most {np.linalg.norm(samples['force'], axis=1).max():.2f} N on the scalpel")

changed = bytearray(file.read_bytes())
changed[len(changed) // 2] ^= 1
other = folder / "changed.resect"
other.write_bytes(changed)
try:
    found = resect.verify(str(other))
    print(f"one bit changed: {found.difference}")
    assert not found
except resect.Error as error:
    print(f"one bit changed: {error}")
