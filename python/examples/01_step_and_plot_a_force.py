"""Steps a scenario and plots the force on an instrument: python3 01_step_and_plot_a_force.py [force.svg]"""
import sys

import numpy as np
import resect

scenario = resect.Scenario("press")  # a baton presses on a soft liver, twice
simulation = resect.Simulation(scenario)
baton = scenario.tools.index("baton")

times, forces, depths = [], [], []
for frame in range(scenario.frame_count):
    report = simulation.step(scenario.inputs(frame))
    times.append(report.time)
    forces.append(np.linalg.norm(report.tool_force[baton]))
    # Displacements are views of the simulation's own memory: three arrays [nz, ny, nx], m.
    depths.append(-simulation.organ().displacement[1].min())

peak = int(np.argmax(forces))
print(f"{simulation.organ().particles} particles, {scenario.frame_count} frames")
print(f"at most {forces[peak]:.2f} N, at {times[peak]:.2f} s; tissue sinks by {1e3 * max(depths):.1f} mm")
assert forces[peak] > 1

import matplotlib  # noqa: E402

matplotlib.use("Agg")  # no window
from matplotlib import pyplot  # noqa: E402

figure, axis = pyplot.subplots(figsize=(7, 3), layout="constrained")
axis.plot(times, forces, color="#b3362b", label="force on the baton, N")
axis.plot(times, 100 * np.array(depths), color="#2b5fb3", label="how far tissue has sunk at most, cm")
axis.set_xlabel("s")
axis.legend(frameon=False)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "force.svg")
