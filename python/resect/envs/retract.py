import numpy as np

from resect.envs import turns
from resect.envs.operation_env import UNIT, OperationEnv


class Retract(OperationEnv):
    """Catch the front edge of the left lobe with the hook, and lift it without tearing it.

    What counts is the mean height of the particles within 20 mm of the place to be caught. Reward per decision: the
    height gained / 10 mm; minus 0.02 per bond that tore; minus 0.1 per N above 3 N; and 10 when the place is 20 mm
    higher than at first while the hook holds tissue, which ends the episode as a success. While nothing is held, minus
    a tenth of the way from tip to place in units of 0.1 m.
    State adds: the place minus the tip / 0.1 m (3), the height gained / 20 mm (1).
    """

    title = "Retract a lobe"
    tools = ("hook",)
    task_numbers = 4
    lift = 0.020  # m

    def prepare(self):
        self._turn = turns.of_instrument([0, 0.75, 0.66], [0, -0.66, 0.75])

    def begin(self):
        x = self.np_random.uniform(0.80, 0.90)
        alive, organ = self.organ.alive, self.organ
        i = int(round((organ.at([x, 0, 0])[0] - organ.origin[0]) / organ.spacing))
        k, j = np.nonzero(alive[:, :, i])
        front = k.max()
        row = j[k == front]
        nz, ny, nx = alive.shape
        edge = (front * ny + int(np.median(row))) * nx + i
        cells = organ.cells()
        places = organ.positions(cells)
        self._edge = np.array([edge])
        self._marked = cells[np.linalg.norm(places - organ.positions(self._edge), axis=1) < 0.02]
        self._first = self._height()
        self._gain = 0.0
        start = self.place() + [0, 0.04, 0.05] + self.np_random.uniform(-0.01, 0.01, 3)
        return np.concatenate([start, self._turn])[None]

    def place(self):
        """m: where the edge that is to be caught is now."""
        return self.organ.positions(self._edge)[0].astype(np.float64)

    def _height(self):
        return float(self.organ.positions(self._marked)[:, 1].mean())

    def task_state(self):
        return np.append((self.place() - self.tips()[0]) / UNIT, self._gain / self.lift)

    def judge(self, report):
        gain = self._height() - self._first
        reward = (gain - self._gain) / 0.01 - 0.02 * report.torn - self.force_cost()
        self._gain = gain
        holds = self.organ.gripped(0) > 0
        if not holds:
            reward -= 0.1 * float(np.linalg.norm(self.place() - self.tips()[0])) / UNIT
        success = holds and gain >= self.lift
        return reward + 10.0 * success, success, {"is_success": success, "gain": gain, "holds": holds}

    def scripted_action(self):
        tip = self.tips()[0]
        if self.organ.gripped(0):
            return self.toward(0, tip + [0, 0.002, 0])
        goal = self.place() + [0, -0.3 * self.organ.spacing, -0.018]
        if tip[2] > goal[2] + 0.038 and tip[1] > goal[1] + 0.012:  # first down in front of the lobe
            return self.toward(0, [goal[0], goal[1], tip[2]])
        return self.toward(0, goal)
