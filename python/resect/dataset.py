"""Data sets of demonstrations: HDF5 in the layout of robomimic, with a card that says what is in it.

    python3 -m resect.dataset cuts --env Incise --demos 100 --observation state,rgb,depth,labels

writes the folder cuts with demos.hdf5 and README.md; --pictures adds each picture as a file. Every demonstration keeps
the state at which it begins and the digest of the state at its end: replay() proves that its actions lead there.
"""

import argparse
import contextlib
import json
import pathlib

import numpy as np

import resect
from resect import envs

KINDS = {kind.__name__: kind for kind in (envs.Reach, envs.Retract, envs.Incise, envs.ResectTumour)}

#: What each array is: shape of one entry, unit.
MEANINGS = {
    "state": "the observation `state` of the environment (docs/how-to/python.md)",
    "points": "places of 256 particles, m, and 1 where the particle is left",
    "contact": "per instrument: force in N (3), particles met, particles held",
    "rgb": "colours, sRGB, top row first",
    "depth": "depth along the camera's axis, m, 10 where nothing is",
    "labels": "0 nothing, 1 table, 16 + instrument, 256 (organ + 1) + structure",
    "poses": "per instrument: x y z in m, quaternion x y z w, squeeze, pedal, in hand",
    "forces": "per instrument: mean force of the tissue on it in the decision before, N",
}


def _h5py():
    try:
        import h5py
        return h5py
    except ImportError:
        raise resect.Error("data sets are written by h5py, which is not installed; on Debian: apt install python3-h5py"
                           ) from None


@contextlib.contextmanager
def _new_file(folder):
    """FOLDER/demos.hdf5, which is there when it is complete, or not at all."""
    if folder.exists() and any(folder.iterdir()):
        raise resect.Error(f"{folder}: is there and not empty; name another folder")
    h5py = _h5py()
    folder.mkdir(parents=True, exist_ok=True)
    unfinished = folder / ".demos.hdf5.tmp"
    try:
        with h5py.File(unfinished, "w") as file:
            yield file
        unfinished.rename(folder / "demos.hdf5")
    finally:
        unfinished.unlink(missing_ok=True)


def _seen(env, observation):
    """What an environment observes, with poses and forces, as a dictionary."""
    seen = dict(observation) if isinstance(observation, dict) else {env.observation[0]: observation}
    seen["poses"] = env.simulation.tools().astype(np.float32)
    seen["forces"] = env.simulation.tool_force().astype(np.float32)
    return seen


def demonstrate(env, seed, act):
    """One episode as arrays: obs, next_obs (dictionaries), actions, rewards, dones; and the states that prove it."""
    observation, info = env.reset(seed=seed)
    seen, actions, rewards, dones = [_seen(env, observation)], [], [], []
    start = env.simulation.save()
    while not dones or not dones[-1]:
        action = np.asarray(act(env), np.float32)
        observation, reward, terminated, truncated, info = env.step(action)
        seen.append(_seen(env, observation))
        actions.append(action), rewards.append(reward), dones.append(terminated or truncated)
    stacked = {name: np.stack([s[name] for s in seen]) for name in seen[0]}
    return {"obs": {n: a[:-1] for n, a in stacked.items()}, "next_obs": {n: a[1:] for n, a in stacked.items()},
            "actions": np.stack(actions), "rewards": np.array(rewards, np.float32),
            "dones": np.array(dones, np.uint8), "start": np.frombuffer(start, np.uint8),
            "hash": f"{env.simulation.state_hash:016x}", "success": bool(info.get("is_success", False)), "seed": seed}


def _write_demo(group, demo):
    for kind in ("obs", "next_obs"):
        for name, array in demo[kind].items():
            packed = {"compression": "gzip", "compression_opts": 4} if array.ndim > 3 or array[0].size > 64 else {}
            group.create_dataset(f"{kind}/{name}", data=array, **packed)
    for name in ("actions", "rewards", "dones"):
        group.create_dataset(name, data=demo[name])
    # robomimic's name for what the simulator needs to be set to a moment; here the observation "state" stands for it.
    group.create_dataset("states", data=demo["obs"].get("state", demo["obs"]["poses"].reshape(len(demo["actions"]), -1)))
    group.create_dataset("start_state", data=demo["start"], compression="gzip")
    group.attrs.update(num_samples=len(demo["actions"]), end_state_hash=demo["hash"], success=demo["success"],
                       seed=demo["seed"])


def write_demos(folder, kind, demos, seed=0, observation=("state",), options=None, act=None, progress=None):
    """Writes FOLDER/demos.hdf5 and FOLDER/README.md. act: function of the environment that returns an action; without
    it the scripted operator. Returns the number of demonstrations that reached the goal."""
    if kind not in KINDS:
        raise resect.Error(f"there is no environment \"{kind}\"; use {', '.join(KINDS)}")
    if demos < 1:
        raise resect.Error(f"{demos} demonstrations were asked for; give 1 or more")
    folder, options = pathlib.Path(folder), dict(options or {})
    env = KINDS[kind](observation=tuple(observation), **options)
    reached = total = 0
    with _new_file(folder) as file:
        data = file.create_group("data")
        for number in range(demos):
            demo = demonstrate(env, seed + number, act or (lambda e: e.scripted_action()))
            _write_demo(data.create_group(f"demo_{number}"), demo)
            reached, total = reached + demo["success"], total + len(demo["actions"])
            if progress:
                progress(number + 1, demos)
        data.attrs["total"] = total
        data.attrs["env_args"] = json.dumps({"env_name": kind, "type": 2, "env_kwargs":
                                             {"observation": list(observation), **options},
                                             "program": f"resect {resect.__version__}"})
        names = np.array([f"demo_{n}".encode() for n in range(demos)])
        held_back = np.arange(demos) % 10 == 9
        file.create_dataset("mask/train", data=names[~held_back])
        file.create_dataset("mask/valid", data=names[held_back])
        card = _card(file, kind, env, options, seed, reached, scripted=act is None)
    (folder / "README.md").write_text(card, encoding="utf-8")
    return reached


def _card(file, kind, env, options, seed, reached, scripted):
    demos = [k for k in file["data"]]
    first = file["data/demo_0"]
    lines = [f"# {len(demos)} demonstrations of {kind}", "", type(env).__doc__.strip().split("\n\n")[0], "",
             f"Made by resect {resect.__version__}. A decision lasts 0.1 s. {file['data'].attrs['total']} decisions; "
             f"{reached} of {len(demos)} demonstrations reach the goal. Seeds {seed} to {seed + len(demos) - 1}. "
             f"{env.organ.particles} particles, {env.organ.spacing * 1e3:.3g} mm apart"
             + (f"; options {json.dumps(options)}" if options else "") + ".", "",
             "| array | of one decision | what it is |", "|---|---|---|"]
    for name, array in first["obs"].items():
        shape = "x".join(map(str, array.shape[1:])) or "1"
        lines.append(f"| `data/demo_N/obs/{name}`, `next_obs/{name}` | {shape} {array.dtype} | {MEANINGS[name]} |")
    lines += [f"| `actions` | {first['actions'].shape[1]} float32 | per instrument {', '.join(envs.ACTION)}, -1 to 1 |",
              "| `rewards`, `dones` | 1 | as the environment documents them; 1 at the end |",
              "| `states` | | the observation `state`, for programs that ask for robomimic's `states` |",
              "| `start_state` | bytes | `Simulation.save()` at the beginning; attribute `end_state_hash`: the digest at "
              "the end |", "",
              "`mask/valid` lists every tenth demonstration, `mask/train` the others.", "",
              "## Limits", "",
              "The organ is a formula fitted to one liver; the operator is "
              + ("a program that knows the scene" if scripted else "the function that was given to write_demos()")
              + ", not a surgeon. Not for decisions about patients.", "",
              "## Proof", "",
              "`resect.dataset.replay(FOLDER, N)` takes the actions of a demonstration from its first state and compares "
              "the state at the end bit for bit.", ""]
    return "\n".join(lines)


def _seen_of(simulation, camera, observation):
    """What there is of an operation without a task: poses, forces, pictures."""
    seen = {"poses": simulation.tools().astype(np.float32), "forces": simulation.tool_force().astype(np.float32)}
    if "rgb" in observation:
        seen["rgb"] = camera.rgb()
    if {"depth", "labels"} & set(observation):
        depth, labels = camera.depth_and_labels()
        seen.update({"depth": np.minimum(depth, 10)} if "depth" in observation else {})
        seen.update({"labels": labels} if "labels" in observation else {})
    return seen


def export_recordings(folder, files, rate=10.0, observation=("rgb", "depth", "labels"), picture=(64, 64)):
    """Writes recordings, such as those of people in the window, as FOLDER/demos.hdf5 with a card, a demonstration each.

    rate: moments per second. An action is the row of every instrument (resect.TOOL_COLUMNS) at the next moment; rewards
    are 0, since a recording has none (resect.score() scores it). Of a recording with several branches the first counts.
    """
    folder = pathlib.Path(folder)
    if not files or not 0 < rate <= 1000:
        raise resect.Error("give one recording or more, and a rate above 0 and at most 1000 a second")
    recordings = [resect.Recording(str(file)) for file in files]
    lines = [f"# {len(files)} recorded operations", "", f"Made by resect {resect.__version__}, {rate:g} moments a second.",
             "", "| demonstration | recording | scenario | moments | digest of the state at the end |", "|---|---|---|---|---|"]
    with _new_file(folder) as file:
        data = file.create_group("data")
        for number, recording in enumerate(recordings):
            simulation = recording.simulation()
            start, camera = simulation.save(), None
            if observation:
                camera = resect.Camera(simulation, *picture)
            seen, due = [_seen_of(simulation, camera, observation)], 1
            while recording.step(simulation) is not None:
                if simulation.time * rate >= due - 1e-9:
                    seen.append(_seen_of(simulation, camera, observation))
                    due = int(simulation.time * rate + 1e-9) + 1
            if simulation.state_hash != recording.state_hash:
                raise resect.Error(f"{files[number]}: playing it gives other bits than were recorded; see resect verify")
            stacked = {name: np.stack([s[name] for s in seen]) for name in seen[0]}
            count = len(seen) - 1
            _write_demo(data.create_group(f"demo_{number}"), {
                "obs": {n: a[:-1] for n, a in stacked.items()}, "next_obs": {n: a[1:] for n, a in stacked.items()},
                "actions": stacked["poses"][1:].reshape(count, -1), "rewards": np.zeros(count, np.float32),
                "dones": np.arange(1, count + 1) == count, "start": np.frombuffer(start, np.uint8),
                "hash": f"{simulation.state_hash:016x}", "success": False, "seed": -1})
            lines.append(f"| demo_{number} | {pathlib.Path(files[number]).name} | {recording.scenario.name} | {count} | "
                         f"{simulation.state_hash:016x} |")
        data.attrs["total"] = sum(int(demo.attrs["num_samples"]) for demo in data.values())
        data.attrs["env_args"] = json.dumps({"env_name": "recording", "type": 2, "env_kwargs": {"rate": rate}})
        lines += ["", "| array | of one moment | what it is |", "|---|---|---|"]
        lines += [f"| `obs/{n}` | {'x'.join(map(str, a.shape[1:]))} {a.dtype} | {MEANINGS[n]} |"
                  for n, a in data["demo_0/obs"].items()]
    (folder / "README.md").write_text("\n".join(lines) + "\n", encoding="utf-8")


def replay(folder, number):
    """Whether the actions of a demonstration lead from its first state to the state at its end, bit for bit."""
    path = pathlib.Path(folder) / "demos.hdf5"
    if not path.is_file():
        raise resect.Error(f"{path} is not there; give a folder that write_demos() has written")
    with _h5py().File(path) as file:
        if f"demo_{number}" not in file["data"]:
            raise resect.Error(f"{path} has no demonstration {number}; give 0 to {len(file['data']) - 1}")
        args = json.loads(file["data"].attrs["env_args"])
        demo = file[f"data/demo_{number}"]
        env = KINDS[args["env_name"]](**{**args["env_kwargs"], "observation": "state"})
        env.reset(seed=int(demo.attrs["seed"]))
        if env.simulation.save() != demo["start_state"][:].tobytes():
            return False
        for action in demo["actions"][:]:
            env.step(action)
        return f"{env.simulation.state_hash:016x}" == demo.attrs["end_state_hash"]


def export_pictures(folder):
    """Writes the pictures of FOLDER/demos.hdf5 as files below FOLDER/pictures: rgb as .png, depth and labels as .npy,
    poses and forces as .csv, a folder per demonstration. Returns the number of files."""
    folder, written = pathlib.Path(folder), 0
    with _h5py().File(folder / "demos.hdf5") as file:
        for name, demo in file["data"].items():
            target = folder / "pictures" / name
            target.mkdir(parents=True, exist_ok=True)
            for kind in ("rgb", "depth", "labels"):
                for number, picture in enumerate(demo[f"obs/{kind}"] if kind in demo["obs"] else ()):
                    path = target / f"{kind}_{number:04}"
                    if kind == "rgb":
                        resect.write_png(f"{path}.png", picture)
                    else:
                        np.save(path, picture)
                    written += 1
            for kind, columns in (("poses", resect.TOOL_COLUMNS), ("forces", ("fx", "fy", "fz"))):
                values = demo[f"obs/{kind}"][:]
                header = ",".join(f"{c}.{tool}" for tool in range(values.shape[1]) for c in columns)
                np.savetxt(target / f"{kind}.csv", values.reshape(len(values), -1), "%.6g", ",", header=header, comments="")
                written += 1
    return written


def main():
    parser = argparse.ArgumentParser(prog="python3 -m resect.dataset", description=__doc__.split("\n\n")[0])
    parser.add_argument("folder", help="folder that is made")
    parser.add_argument("--env", default="Incise", choices=sorted(KINDS))
    parser.add_argument("--demos", type=int, default=100)
    parser.add_argument("--seed", type=int, default=0, help="of the first demonstration")
    parser.add_argument("--observation", default="state", help="as state,rgb,depth,labels")
    parser.add_argument("--particles", type=int, default=1000)
    parser.add_argument("--tissue", default="plain")
    parser.add_argument("--picture", default="64x64", help="size in pixels")
    parser.add_argument("--recordings", nargs="+", metavar="FILE", help="recordings to export, instead of demonstrations")
    parser.add_argument("--rate", type=float, default=10, help="of recordings: moments per second")
    parser.add_argument("--pictures", action="store_true", help="write each picture as a file too")
    given = parser.parse_args()
    try:
        size = tuple(int(n) for n in given.picture.split("x"))
    except ValueError:
        parser.error(f"--picture is {given.picture}; give width x height, as 64x64")
    if given.recordings:
        wanted = [name for name in given.observation.split(",") if name in ("rgb", "depth", "labels")]
        export_recordings(given.folder, given.recordings, given.rate, wanted, size)
        print(f"{given.folder}/demos.hdf5: {len(given.recordings)} recordings")
        if given.pictures:
            print(f"{given.folder}/pictures: {export_pictures(given.folder)} files")
        return
    tell = lambda done, count: print(f"{done} of {count}", end="\r" if done < count else "\n", flush=True)
    reached = write_demos(given.folder, given.env, given.demos, given.seed, given.observation.split(","),
                          {"particles": given.particles, "tissue": given.tissue, "picture": list(size)}, progress=tell)
    print(f"{given.folder}/demos.hdf5: {given.demos} demonstrations, {reached} reach the goal")
    if given.pictures:
        print(f"{given.folder}/pictures: {export_pictures(given.folder)} files")


if __name__ == "__main__":
    try:
        main()
    except resect.Error as error:
        raise SystemExit(f"resect: error: {error}")
