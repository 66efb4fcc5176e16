"""What all environments have in common: the simulation, actions, observations, reset by restore, pictures."""

import math

import numpy as np

import resect
from resect.envs import turns
from resect.envs.scene import DECISION, scene_text, whole_number
from resect.envs.spaces import Box, Dict, Env

#: Observations that may be asked for, alone or together.
OBSERVATIONS = ("state", "points", "contact", "rgb", "depth", "labels")
PICTURES = {"rgb", "depth", "labels"}

#: Numbers of an action per instrument: motion in the world, turn about the world's axes, jaws, pedal; each -1 to 1.
ACTION = ("dx", "dy", "dz", "rx", "ry", "rz", "squeeze", "pedal")
MOST_STEP = 0.01  # m that an instrument moves in a decision, along each axis
MOST_TURN = 0.2  # rad that it turns in a decision, about each axis
STATE_PER_TOOL = 13
UNIT = 0.1  # m: positions in a state are divided by it
FORCE_UNIT = 5.0  # N: forces in a state are divided by it


class OperationEnv(Env):
    """An operation as an environment with Gymnasium's interface. A decision lasts 0.1 s.

    observation: one of OBSERVATIONS, or several; several give a dictionary.
        state: float32 [13 tools + task]; per instrument tip minus the middle of the organ's box / 0.1 m (3),
            quaternion x y z w (4), felt force / 5 N (3), squeeze, pedal, whether it holds tissue; then what the task adds.
        points: float32 [256, 4]: present places of 256 particles, m, and 1 where the particle is left, else 0.
        contact: float32 [tools, 5]: mean force in the decision, N (3); particles that it met; particles that it holds.
        rgb: uint8 [h, w, 3]; depth: float32 [h, w], m, 10 where nothing is; labels: uint16 [h, w] (resect.Camera).
    actions: "full", 8 numbers per instrument as in ACTION, or "position", the first 3 of them.
    tissue: "plain" or "liver" (resect.envs.scene). particles: about so many. young: Pa.
    picture: width and height of pictures in pixels.
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": 10}
    title = "An operation"
    tools = ("baton",)
    task_numbers = 0  # that the task adds to the state
    settle = 1.0  # s before the first decision
    force_limit = 3.0  # N
    labels = ""

    def __init__(self, observation="state", actions="full", particles=1000, tissue="plain", young=5000.0,
                 max_steps=100, picture=(64, 64), render_mode=None):
        self.render_mode = render_mode
        if render_mode not in (None, "rgb_array"):
            raise resect.Error(f"render_mode is \"{render_mode}\"; use rgb_array or None")
        if actions not in ("full", "position"):
            raise resect.Error(f"actions is \"{actions}\"; use full or position")
        self.observation = (observation,) if isinstance(observation, str) else tuple(observation)
        for name in self.observation:
            if name not in OBSERVATIONS:
                raise resect.Error(f"there is no observation \"{name}\"; use {', '.join(OBSERVATIONS)}")
        self._single = isinstance(observation, str)
        self.max_steps, self.picture = whole_number(max_steps, "max_steps", 1, 10**9), tuple(picture)
        self.simulation = resect.Simulation(resect.Scenario.parse(
            scene_text(self.title, self.tools, particles, tissue, young, self.labels), type(self).__name__))
        self.organ = self.simulation.organ()
        self._rows = self.simulation.tool_rests()
        self._report = None
        for _ in range(round(self.settle / DECISION)):
            self._report = self.simulation.step(self._rows, DECISION)
        self._middle = self.organ.at([0.5, 0.5, 0.5])
        low, high = self.organ.at([0, 0, 0]), self.organ.at([1, 1, 1])
        self._low, self._high = low - [0.06, 0.0, 0.06], high + [0.06, 0.12, 0.06]
        self._shown = np.random.default_rng(0).permutation(self.organ.cells())[:256]
        self._camera, self._tops = None, None
        self.prepare()
        self._start = self.simulation.save()
        self._per_tool = len(ACTION) if actions == "full" else 3
        self.action_space = Box(-1.0, 1.0, (len(self.tools) * self._per_tool,), np.float32)
        spaces = {name: self._space(name) for name in self.observation}
        self.observation_space = spaces[observation] if self._single else Dict(spaces)
        self._steps = 0
        self._over, self._begun = True, False

    # What a task adds. ------------------------------------------------------------------------------------------------

    def prepare(self):
        """Once, with the organ settled."""

    def begin(self):
        """At each reset: chooses a goal by self.np_random; returns the poses of the instruments, [tools, 7]."""
        raise NotImplementedError

    def task_state(self):
        """The task's numbers in the state."""
        return ()

    def judge(self, report):
        """(reward, terminated, info) after a decision."""
        raise NotImplementedError

    def scripted_action(self):
        """What a simple operator does now, who knows the scene: for demonstrations, and as a proof that it can be done."""
        raise NotImplementedError

    # Gymnasium's interface. -------------------------------------------------------------------------------------------

    def reset(self, *, seed=None, options=None):
        super().reset(seed=None if seed is None else whole_number(seed, "seed", 0, 2**63))
        self.simulation.restore(self._start)
        poses = self.begin()
        self._rows[:, :7] = poses
        self._rows[:, 7:9] = 0
        self._rows[:, 9] = 1
        self.simulation.step(self._rows, 0.0)  # takes the instruments in hand; nothing moves
        self._steps, self._over, self._begun, self._report = 0, False, True, None
        return self._observe(), self.info()

    def step(self, action):
        if self._over:
            raise resect.Error(f"{'the episode is over' if self._begun else 'no episode has begun'}; "
                               "call reset() before step()")
        try:
            action = np.asarray(action, np.float64)
        except (TypeError, ValueError):
            action = np.empty(0)
        if action.shape != self.action_space.shape or not np.isfinite(action).all():
            raise resect.Error(f"an action is {self.action_space.shape[0]} finite numbers from -1 to 1")
        self._move(np.clip(action, -1, 1).reshape(len(self.tools), self._per_tool))
        self._report = self.simulation.step(self._rows, DECISION)
        self._steps += 1
        reward, terminated, info = self.judge(self._report)
        truncated = not terminated and self._steps >= self.max_steps
        self._over = terminated or truncated
        return self._observe(), float(reward), bool(terminated), bool(truncated), {**self.info(), "severed": self._report.severed, **info}

    def render(self):
        return self.camera().rgb() if self.render_mode == "rgb_array" else None

    def close(self):
        self._camera = None

    def info(self):
        return {"time": self.simulation.time}

    # ------------------------------------------------------------------------------------------------------------------

    def camera(self):
        """resect.Camera over the simulation; made when first asked for."""
        if self._camera is None:
            self._camera = resect.Camera(self.simulation, *self.picture)
        return self._camera

    def tips(self):
        """[tools, 3] m: where the tips are."""
        return self._rows[:, :3]

    def toward(self, tool, place, jaws=-1.0, pedal=-1.0):
        """The action that moves an instrument towards a place, m; the other instruments rest."""
        action = np.zeros((len(self.tools), self._per_tool), np.float32)
        if self._per_tool > 3:
            action[:, 6:] = -1
            action[tool, 6:] = jaws, pedal
        action[tool, :3] = np.clip((np.asarray(place) - self._rows[tool, :3]) / MOST_STEP, -1, 1)
        return action.ravel()

    def force_cost(self):
        """0.1 per N by which the force on any instrument is above the limit."""
        forces = np.linalg.norm(self.simulation.tool_force(), axis=1)
        return 0.1 * float(np.maximum(forces - self.force_limit, 0).sum())

    def _move(self, action):
        rows = self._rows
        rows[:, :3] = np.clip(rows[:, :3] + MOST_STEP * action[:, :3], self._low, self._high)
        if self._per_tool == 3:
            return
        for row, one in zip(rows, action):
            if one[3:6].any():
                q = turns.product(turns.from_vector(MOST_TURN * one[3:6]), row[3:7])
                row[3:7] = q / math.sqrt(float(q @ q))
        rows[:, 7] = (action[:, 6] + 1) / 2
        rows[:, 8] = action[:, 7] > 0

    def _space(self, name):
        width, height = self.picture
        if name == "state":
            return Box(-np.inf, np.inf, (STATE_PER_TOOL * len(self.tools) + self.task_numbers,), np.float32)
        if name == "points":
            return Box(-np.inf, np.inf, (len(self._shown), 4), np.float32)
        if name == "contact":
            return Box(-np.inf, np.inf, (len(self.tools), 5), np.float32)
        if name == "rgb":
            return Box(0, 255, (height, width, 3), np.uint8)
        if name == "depth":
            return Box(0.0, 10.0, (height, width), np.float32)
        return Box(0, 65535, (height, width), np.uint16)

    def _observe(self):
        seen = {}
        if "state" in self.observation:
            seen["state"] = self.state()
        if "points" in self.observation:
            seen["points"] = self.points()
        if "contact" in self.observation:
            seen["contact"] = self.contact()
        if "rgb" in self.observation:
            seen["rgb"] = self.camera().rgb()
        if PICTURES & set(self.observation) - {"rgb"}:
            depth, labels = self.camera().depth_and_labels()
            if "depth" in self.observation:
                seen["depth"] = np.minimum(depth, 10.0, out=depth)
            if "labels" in self.observation:
                seen["labels"] = labels
        return seen[self.observation[0]] if self._single else {name: seen[name] for name in self.observation}

    def state(self):
        """The observation "state"."""
        tools = len(self.tools)
        state = np.empty(STATE_PER_TOOL * tools + self.task_numbers, np.float32)
        own = state[:STATE_PER_TOOL * tools].reshape(tools, STATE_PER_TOOL)
        own[:, :3] = (self._rows[:, :3] - self._middle) / UNIT
        own[:, 3:7] = self._rows[:, 3:7]
        own[:, 7:10] = self.simulation.felt_force() / FORCE_UNIT
        own[:, 10:12] = self._rows[:, 7:9]
        for tool in range(tools):
            own[tool, 12] = self.organ.gripped(tool) > 0
        state[STATE_PER_TOOL * tools:] = self.task_state()
        return state

    def points(self):
        """The observation "points"."""
        points = np.empty((len(self._shown), 4), np.float32)
        points[:, :3] = self.organ.positions(self._shown)
        points[:, 3] = self.organ.alive.reshape(-1)[self._shown]
        return points

    def contact(self):
        """The observation "contact"."""
        contact = np.zeros((len(self.tools), 5), np.float32)
        if self._report is not None:
            contact[:, :3] = self._report.tool_force
            for tool in range(len(self.tools)):
                contact[tool, 3] = self._report.touched(tool)
                contact[tool, 4] = self.organ.gripped(tool)
        return contact

    def surface_cell(self, x, z):
        """The topmost particle of the whole organ near the fractions x and z of its box, as a cell."""
        if self._tops is None:
            whole = self.organ.alive  # as an episode begins
            nz, ny, nx = whole.shape
            k, i = np.nonzero(whole.any(axis=1))
            top = ny - 1 - np.argmax(whole[:, ::-1, :], axis=1)[k, i]
            spacing, origin = self.organ.spacing, self.organ.origin
            self._tops = (k * ny + top) * nx + i, origin[0] + spacing * i, origin[2] + spacing * k
        cells, across, along = self._tops
        at = self.organ.at([x, 0, z])
        return int(cells[np.argmin((across - at[0])**2 + (along - at[2])**2)])

    def places(self, cells):
        """[n, 3] m: where the tops of these cells are now."""
        return self.organ.positions(cells).astype(np.float64) + [0, self.organ.spacing / 2, 0]
