"""The way of an instrument: its keys, as they are written into a scenario."""
import math

FRAME_RATE = 60


def vector(v):
    return "[" + ", ".join(f"{x:.4f}".rstrip("0").rstrip(".") for x in v) + "]"


class Path3:
    """Keys of one tool: time, tip, how far its jaws are squeezed, and where handle and edge point; its pedal is pressed
    all the time or never."""

    def __init__(self, handle, edge, speed, pedal=0):
        self.handle, self.edge, self.speed, self.pedal = handle, edge, speed, pedal
        self.keys = []
        self.way = None   # arguments of lying_liver.way() if it is given in the organ's coordinates
        self.speeds = {}  # m/s, by the number of the key that is reached with it
        self.time = 0.0
        self.squeeze = 0.0

    def wait(self, seconds):
        self.time += round(seconds * FRAME_RATE) / FRAME_RATE

    def to(self, *tip, speed=None):
        if self.keys:
            # Keys fall on frames, so that the corners of the way are passed and not cut off between two frames.
            seconds = math.dist(tip, self.keys[-1][1]) / (speed or self.speed)
            self.time += max(1, math.ceil(seconds * FRAME_RATE - 1e-6)) / FRAME_RATE
            self.speeds[len(self.keys)] = speed or self.speed
        self.keys.append((round(self.time, 5), tip, self.squeeze, self.edge))
        return self

    def turn(self, edge):
        """Turns the instrument so that its edge points elsewhere, by the next key."""
        self.edge = edge
        return self

    def snip(self, seconds=0.3):
        """Closes the jaws where they are and opens them again."""
        for self.squeeze in (1.0, 0.0):
            self.wait(seconds)
            self.keys.append((round(self.time, 5), self.keys[-1][1], self.squeeze, self.edge))
        return self

    def grasp(self, seconds):
        """Closes the jaws where they are for a time, and opens them again."""
        for self.squeeze, wait in ((1.0, 0.1), (1.0, seconds), (0.0, 0.1)):
            self.wait(wait)
            self.keys.append((round(self.time, 5), self.keys[-1][1], self.squeeze, self.edge))
        return self

    def hold_until(self, time):
        """Stays where it is, as it is."""
        self.time = time
        self.keys.append((round(self.time, 5), self.keys[-1][1], self.squeeze, self.edge))
        return self

    def jaws(self, squeeze, seconds=0.3):
        """Closes or opens the jaws where they are."""
        self.squeeze = squeeze
        self.wait(seconds)
        self.keys.append((round(self.time, 5), self.keys[-1][1], self.squeeze, self.edge))
        return self

    def rotation(self, edge):
        return f"{{ handle = {vector(self.handle)}, edge = {vector(edge)} }}"

    def text(self):
        jaws = lambda squeeze: f", squeeze = {squeeze:g}" if squeeze else ""
        pedal = f", pedal = {self.pedal:g}" if self.pedal else ""
        rows = [
            f"  {{ time = {t:.7g}, position = {vector(p)}, rotation = {self.rotation(edge)}{jaws(s)}{pedal} }},"
            for t, p, s, edge in self.keys
        ]
        return "keys = [\n" + "\n".join(rows) + "\n]\n"


def saw(path, start, end, half_width, advance):
    """From start to end while swinging by +-half_width along x; each swing advances by `advance`."""
    steps = max(1, math.ceil(math.dist(start, end) / advance))
    for i in range(steps + 1):
        share = i / steps
        x, y, z = (a + share * (b - a) for a, b in zip(start, end))
        path.to(x + (half_width if i % 2 else -half_width), y, z)
