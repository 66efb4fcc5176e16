"""The way of an instrument over any organ, as keys in the organ's coordinates (docs/scenarios.md)."""
from paths import vector


class OrganPath:
    """Keys over places of the organ: how far across its box, and how far from its back to its front there."""

    way = True  # in the organ's coordinates

    def __init__(self, handle, edge, start, over, depth):
        turn = f"{{ handle = {vector(handle)}, edge = {vector(edge)} }}"
        self.rows = [f"time = {start:g}, {self.place(over, depth)}, rotation = {turn}"]

    @staticmethod
    def place(over, depth):
        return f'over = {vector(over)}, depth = "{depth}"'

    def to(self, over, depth, speed):
        self.rows.append(f"speed = {speed:g}, {self.place(over, depth)}")
        return self

    def wait(self, seconds):
        self.rows.append(f"wait = {seconds:g}")
        return self

    def text(self):
        return 'frame = "organ"\nkeys = [\n' + "".join(f"  {{ {row} }},\n" for row in self.rows) + "]\n"
