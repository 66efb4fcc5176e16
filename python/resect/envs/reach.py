import numpy as np

from resect.envs import turns
from resect.envs.operation_env import UNIT, OperationEnv


class Reach(OperationEnv):
    """Bring the tip of the baton to a point of the organ's surface, and do not press.

    The point is a particle of the upper side, chosen at reset. Reward per decision: minus the distance in units of
    0.1 m, minus 0.1 per N above 3 N; and 10 when the tip is within 8 mm, which ends the episode as a success.
    State adds: the point minus the tip / 0.1 m (3).
    """

    title = "Reach a point of the liver"
    task_numbers = 3
    radius = 0.008  # m

    def prepare(self):
        # Places all over the upper side, by fractions of the box.
        self._targets = sorted({self.surface_cell(x, z) for x in np.linspace(0.2, 0.85, 14)
                                for z in np.linspace(0.3, 0.8, 11)})
        self._turn = turns.of_instrument([0, 0.95, 0.3], [0, 0.3, -0.95])

    def begin(self):
        self._target = np.array([self._targets[self.np_random.integers(len(self._targets))]])
        start = self.organ.at(self.np_random.uniform([0.2, 1.1, 0.3], [0.8, 1.4, 0.8]))
        return np.concatenate([start, self._turn])[None]

    def target(self):
        """m: where the point is now."""
        return self.places(self._target)[0]

    def task_state(self):
        return (self.target() - self.tips()[0]) / UNIT

    def judge(self, report):
        distance = float(np.linalg.norm(self.target() - self.tips()[0]))
        success = distance < self.radius
        return 10.0 * success - distance / UNIT - self.force_cost(), success, {"is_success": success,
                                                                             "distance": distance}

    def scripted_action(self):
        return self.toward(0, self.target())
