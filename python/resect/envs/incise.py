import numpy as np

from resect.envs import turns
from resect.envs.operation_env import UNIT, OperationEnv


class Incise(OperationEnv):
    """Draw the scalpel along a line over the left lobe, some millimetres deep.

    The line runs through six particles of the surface, from the front to the back of the lobe or reversed, at a place
    chosen at reset. A point is cut when the blade severs tissue with its tip at most 9 mm beside the point and 3 to
    20 mm below it, in the order of the line. Reward per decision: 1 per point that is cut; minus a tenth of the way to
    the next point in units of 0.1 m; minus 0.02 per bond severed while the tip is farther than 18 mm from the line;
    minus 0.1 per N above 3 N; and 5 when all are cut, which ends the episode as a success.
    State adds: the next point, and the one after it, minus the tip / 0.1 m (6); share of the points that are cut (1).
    """

    title = "Incise along a line"
    tools = ("scalpel",)
    task_numbers = 7
    beside, shallow, deep = 0.009, 0.003, 0.020  # m
    stray = 0.018  # m

    def prepare(self):
        self._turn = turns.of_instrument([0, 0.8, 0.6], [0, -0.6, 0.8])
        self._back = turns.of_instrument([0, 0.8, -0.6], [0, -0.6, -0.8])

    def begin(self):
        x = self.np_random.uniform(0.70, 0.82)
        reverse = self.np_random.random() < 0.5
        along = np.linspace(0.50, 0.80, 6)
        if reverse:
            along = along[::-1]
        self.line = np.array([self.surface_cell(x, z) for z in along])
        self.cut = 0
        start = self.places(self.line[:1])[0] + [0, 0.04, 0] + self.np_random.uniform(-0.01, 0.01, 3)
        return np.concatenate([start, self._back if reverse else self._turn])[None]

    def task_state(self):
        ahead = self.places(self.line[np.minimum([self.cut, self.cut + 1], len(self.line) - 1)])
        return np.append(((ahead - self.tips()[0]) / UNIT).ravel(), self.cut / len(self.line))

    def _off_line(self, tip):
        """m: from the tip to the line, seen from above."""
        p = self.places(self.line)[:, [0, 2]]
        a, d = p[:-1], np.diff(p, axis=0)
        t = np.clip(((tip[[0, 2]] - a) * d).sum(1) / np.maximum((d * d).sum(1), 1e-12), 0, 1)
        return float(np.linalg.norm(a + t[:, None] * d - tip[[0, 2]], axis=1).min())

    def judge(self, report):
        tip, reward = self.tips()[0], 0.0
        if report.severed and self._off_line(tip) > self.stray:
            reward -= 0.02 * report.severed
        if report.severed:
            for place in self.places(self.line[self.cut:]):
                off = np.linalg.norm((tip - place)[[0, 2]])
                if off > self.beside or not self.shallow <= place[1] - tip[1] <= self.deep:
                    break
                self.cut += 1
                reward += 1
        success = self.cut == len(self.line)
        if not success:
            reward -= 0.1 * float(np.linalg.norm(self.places(self.line[self.cut:self.cut + 1])[0] - tip)) / UNIT
        return reward + 5.0 * success - self.force_cost(), success, {"is_success": success, "cut": self.cut}

    def scripted_action(self):
        goal = self.places(self.line[self.cut:self.cut + 1])[0]
        return self.toward(0, goal - [0, 0.009, 0])
