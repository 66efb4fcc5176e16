import numpy as np

from resect.envs import turns
from resect.envs.operation_env import MOST_TURN, UNIT, OperationEnv


class ResectTumour(OperationEnv):
    """Cut off the end of the left lobe with a tumour in it, with a margin of 5 mm or more, and as little else as can be.

    The tumour is a ball of 12 mm radius, a label of the organ (three times as stiff as the liver), always at the same
    place. Reward per decision: 0.05 per cm^2 of new cut, if the tip is within 60 mm of the tumour seen from above, else
    minus as much; minus 0.1 per N above 3 N; minus 5 once when the tumour is cut. When all of the tumour is in pieces
    that have come off: 10, or 5 with a smaller margin, minus 0.02 per ml of liver in them; this ends the episode, as a
    success if the margin was kept.
    State adds: middle of the tumour minus the tip of the scalpel / 0.1 m (3), cut / 100 cm^2, share of the tumour in
    pieces, margin / 10 mm (at most 2).
    """

    title = "Resect a tumour"
    tools = ("scalpel", "hook")
    task_numbers = 6
    margin = 5.0  # mm
    labels = """
[[organ.label]]
label = 1
name = "tumour"
frame = "organ"
centre = [0.90, 0.20, 0.55]
radius = 0.012
"""

    def __init__(self, *args, max_steps=350, **options):
        super().__init__(*args, max_steps=max_steps, **options)

    def prepare(self):
        self._tumour = np.flatnonzero(self.organ.labels.reshape(-1) * self.organ.alive.reshape(-1) == 1)
        self._turn = turns.of_instrument([0, 1, 0.05], [0, -0.05, 1])
        self._hook = turns.of_instrument([0.45, 0.85, 0.27], [0.85, -0.52, 0.1])

    def begin(self):
        self._measure()
        self._plane = self.middle()[0] - 0.024
        self._injured, self._way, self._left = False, self._strokes(), np.pi  # rad that the edge will be turned by
        jitter = self.np_random.uniform(-0.01, 0.01, (2, 3))
        start = self.organ.at([0.62, 0, 0.0]) + [0, 0.10, -0.03] + jitter[0]
        hook = self.organ.at([1.0, 0.8, 0.6]) + [0.03, 0, 0] + jitter[1]
        return np.stack([np.concatenate([start, self._turn]), np.concatenate([hook, self._hook])])

    def _measure(self):
        ledger = self.simulation.ledger()
        tumour = ledger["labels"]["tumour"]
        self._cut = ledger["cut_cm2"]
        self._share = (tumour["pieces"]["particles"] + tumour["debris"]["particles"]) / tumour["before"]["particles"]
        margin = tumour["margin_mm"]
        self._margin = margin if margin is not None and np.isfinite(margin) else np.inf
        self._specimen = ledger["pieces"]["ml"] - tumour["pieces"]["ml"]

    def middle(self):
        """m: the middle of the tumour now."""
        return self.organ.positions(self._tumour).mean(axis=0).astype(np.float64)

    def task_state(self):
        return np.append((self.middle() - self.tips()[0]) / UNIT,
                         [self._cut / 100, self._share, min(self._margin / 10, 2.0)])

    def judge(self, report):
        before = self._cut
        if report.severed or report.torn:
            self._measure()
        near = np.linalg.norm((self.middle() - self.tips()[0])[[0, 2]]) < 0.06
        reward = (0.05 if near else -0.05) * (self._cut - before) - self.force_cost()
        if self._margin == 0 and not self._injured:
            self._injured = True
            reward -= 5
        off = self._share >= 1
        kept = self._margin >= self.margin
        if off:
            reward += (10 if kept else 5) - 0.02 * self._specimen
        return reward, off, {"is_success": bool(off and kept), "margin_mm": self._margin, "cut_cm2": self._cut,
                             "specimen_ml": self._specimen}

    def scripted_action(self):
        """Strokes from the back to the front, each deeper, in a plane beside the tumour. Then, with the edge turned round,
        one from the front, which cuts the strip that gave way where the others left the tissue."""
        here = self.tips()[0]
        if self._way and np.linalg.norm(self._way[0] - here) < 0.002:
            self._way.pop(0)
        if self._way:
            return self.toward(0, self._way[0])
        action = self.toward(0, here)
        if self._per_tool > 3 and self._left > 0:
            turn = min(self._left, MOST_TURN)
            action[4] = turn / MOST_TURN
            self._left -= turn
            if self._left == 0:
                self._way = self._stroke(0.001)[::-1]
        return action

    def _stroke(self, low):
        x, back, front = self._plane, self._low[2] + 0.02, self._high[2] - 0.02
        return [np.array([x, y, z]) for y, z in ((0.09, back), (low, back), (low, front), (0.09, front))]

    def _strokes(self):
        return sum((self._stroke(low) for low in (0.03, 0.001, 0.001)), [])
