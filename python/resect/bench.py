"""Environment steps per second: python3 -m resect.bench

Protocol of newton#4141: random actions, cutting on, the mean of 500 steps after 100; here with a reset whenever an
episode is over; the surface follows every step. A step is a decision of 0.1 s. Beside steps per second stand those per
second of processor time: what a core does that no other work shares. --quick takes a tenth of the steps.
"""

import argparse
import os
import time

import numpy as np

from resect.envs import Incise, Reach, Retract, VectorEnv
from resect.envs.scene import TISSUES

#: Figures that others published, on other machines and without cutting (newton#4141, 2026-09).
PUBLISHED = [("PhysX, 1024 environments on one RTX 5090, no cutting", 18622),
             ("Newton, 4096 environments on one RTX 5090, no cutting", 11808)]
KINDS = {"Incise": Incise, "Reach": Reach, "Retract": Retract}


def scripted(kind):
    """The environment with its scripted operator, whatever the action."""
    class Scripted(kind):
        def step(self, action):
            return super().step(self.scripted_action())
    return Scripted


def steps_per_second(make, count, backend, warm, measured, seed=0):
    """Mean over all environments together: steps per second, steps per second of processor time, and the share of
    steps in which tissue was cut."""
    envs = VectorEnv(make, count, backend)
    try:
        envs.action_space.seed(seed)
        envs.reset(seed=seed)
        for _ in range(warm):
            envs.step(envs.action_space.sample())
        begin, worked = time.perf_counter(), envs.processor_time()
        cut = 0
        for _ in range(measured):
            cut += sum(info["severed"] > 0 for info in envs.step(envs.action_space.sample())[4])
        took, worked = time.perf_counter() - begin, envs.processor_time() - worked
        return count * measured / took, count * measured / worked, cut / (count * measured)
    finally:
        envs.close()


def reset_times(env, episodes=20):
    """Medians, ms: of reset() as nothing was done, and after an episode of the scripted operator."""
    def timed(seed):
        begin = time.perf_counter()
        env.reset(seed=seed)
        return 1e3 * (time.perf_counter() - begin)

    env.reset(seed=0)
    idle = [timed(seed) for seed in range(episodes)]
    worked = []
    for seed in range(episodes):
        over = False
        while not over:
            _, _, terminated, truncated, _ = env.step(env.scripted_action())
            over = terminated or truncated
        worked.append(timed(seed))
    return float(np.median(idle)), float(np.median(worked))


def print_resets(given):
    for tissue in given.tissue.split(","):
        for particles in map(int, given.particles.split(",")):
            env = KINDS[given.env](observation=given.observation, particles=particles, tissue=tissue)
            idle, worked = reset_times(env)
            print(f"  {given.env}, {tissue:5}  {particles:5} particles  reset() {idle:.1f} ms, after an episode {worked:.1f} ms",
                  flush=True)


def main():
    parser = argparse.ArgumentParser(prog="python3 -m resect.bench", description=__doc__.split("\n\n")[0],
                                     epilog="\n".join(__doc__.split("\n\n")[1:]))
    parser.add_argument("--env", default="Incise", choices=sorted(KINDS))
    parser.add_argument("--envs", default="1,2,4,8,16", help="numbers of environments, as 1,2,4")
    parser.add_argument("--particles", default="300,1000,3000")
    parser.add_argument("--tissue", default="plain,liver", help="plain, liver, or plain,liver")
    parser.add_argument("--backend", default="processes", help="processes, threads, here, or several")
    parser.add_argument("--observation", default="state")
    parser.add_argument("--operator", default="random", choices=("random", "scripted"),
                        help="random actions, or the scripted operator, who cuts almost always")
    parser.add_argument("--quick", action="store_true", help="50 steps after 10")
    parser.add_argument("--resets", action="store_true", help="instead of steps: the time of reset()")
    parser.add_argument("--csv", help="file for the table")
    given = parser.parse_args()
    for tissue in given.tissue.split(","):
        if tissue not in TISSUES:
            parser.error(f"tissue is {tissue}; use plain or liver")
    if given.resets:
        return print_resets(given)
    numbers = [int(n) for n in given.envs.split(",")]
    warm, measured = (10, 50) if given.quick else (100, 500)
    cores = len(os.sched_getaffinity(0))
    print(f"{given.env}, observation {given.observation}, mean of {measured} steps after {warm}, {given.operator} actions, "
          f"{cores} cores, load of the machine {os.getloadavg()[0]:.1f}")
    rows = [("env", "observation", "tissue", "particles", "backend", "envs", "steps_per_s", "steps_per_processor_s",
             "share_that_cuts", "load")]
    for tissue in given.tissue.split(","):
        for particles in map(int, given.particles.split(",")):
            for backend in given.backend.split(","):
                for count in numbers:
                    load = os.getloadavg()[0]
                    kind = KINDS[given.env] if given.operator == "random" else scripted(KINDS[given.env])
                    make = lambda: kind(observation=given.observation, particles=particles, tissue=tissue)
                    rate, share, cut = steps_per_second(make, count, backend, warm, measured)
                    rows.append((given.env, given.observation, tissue, particles, backend, count, f"{rate:.1f}",
                                 f"{share:.1f}", f"{cut:.3f}", f"{load:.1f}"))
                    print(f"  {tissue:5}  {particles:5} particles  {count:2} {backend:9}  {rate:7.0f} steps/s, "
                          f"{share:5.0f} per second of a core, {cut:4.0%} cut", flush=True)
    for name, rate in PUBLISHED:
        print(f"  published: {name}: {rate} steps/s")
    if given.csv:
        np.savetxt(given.csv, np.array(rows), fmt="%s", delimiter=",")


if __name__ == "__main__":
    main()
