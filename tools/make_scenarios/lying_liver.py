"""The built-in liver at rest on the table, and places on it in its own coordinates, as Resect finds them again on any
organ (src/operation/way/place_ways.h; docs/scenarios.md, "Ways in the organ's coordinates")."""
import functools
import math
import struct
from pathlib import Path

LIVER = Path(__file__).resolve().parents[2] / "data/organs/liver.ply"
# How the liver lies when it has rolled to rest: a unit quaternion (w, x, y, z), as loadOrganMesh() gives it.
TURN = (0.94593347948991346, -0.058821160247774791, 0, -0.31898263822222528)
OUTERMOST = 0.02        # of the box: how near to its sides sections are made


def turned(v):
    w, x, y, z = TURN
    t = (2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0]))
    return (v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2],
            v[2] + w * t[2] + x * t[1] - y * t[0])


@functools.cache
def surface():
    """Points, triangles and box: centred over the origin, on the table."""
    data = LIVER.read_bytes()
    at = data.index(b"end_header\n") + len(b"end_header\n")
    count = {line.split()[1]: int(line.split()[2]) for line in data[:at].decode().splitlines()
             if line.startswith("element")}
    points = [turned(p) for p in struct.iter_unpack("<3d", data[at:at + 24 * count["vertex"]])]
    triangles = [t[1:] for t in struct.iter_unpack("<Biii", data[at + 24 * count["vertex"]:])]
    low, high = ([f(p[a] for p in points) for a in range(3)] for f in (min, max))
    shift = (-(low[0] + high[0]) / 2, -low[1], -(low[2] + high[2]) / 2)
    points = [tuple(p[a] + shift[a] for a in range(3)) for p in points]
    return points, triangles, ([low[a] + shift[a] for a in range(3)], [high[a] + shift[a] for a in range(3)])


@functools.cache
def section(x):
    """Where the plane at x meets triangles, as pairs of (z, y), the lesser z first; and the longest stretch in z."""
    points, triangles, _ = surface()
    lines = []
    for t in triangles:
        above = [points[i][0] >= x for i in t]
        if above[0] == above[1] == above[2]:
            continue
        ends = []
        for k in range(3):
            i, j = sorted((t[k], t[(k + 1) % 3]))
            a, b = points[i], points[j]
            if (a[0] >= x) != (b[0] >= x):
                share = (x - a[0]) / (b[0] - a[0])
                ends.append((a[2] + share * (b[2] - a[2]), a[1] + share * (b[1] - a[1])))
        lines.append(sorted(ends))
    lines.sort(key=lambda line: line[0][0])
    best, begin, end = (0, 0), 0, float("-inf")
    for (z0, _), (z1, _) in lines:
        if z0 > end:
            begin = z0
        end = max(end, z1)
        if end - begin > best[1] - best[0]:
            best = begin, end
    return lines, best


def top(x, z):
    """How high the liver's top is there."""
    lines, (back, front) = section(x)
    z = min(max(z, back), front)
    ys = [y0 + ((z - z0) / (z1 - z0) if z1 > z0 else 0) * (y1 - y0) for (z0, y0), (z1, y1) in lines if z0 <= z <= z1]
    return max(ys)


def over(x, tip):
    """The place of a tip, m, in the upright plane at x: how far across and how far to the front, and its depth."""
    _, _, (low, high) = surface()
    across = (x - low[0]) / (high[0] - low[0])
    at = low[0] + min(max(across, OUTERMOST), 1 - OUTERMOST) * (high[0] - low[0])
    back, front = section(at)[1]
    return across, (tip[2] - back) / (front - back), top(at, tip[2]) - tip[1]


def way(path, x, spacing, swing):
    """A path as keys in the liver's coordinates: its strokes lie in the plane at x, and swing by so many cells."""
    number = lambda v: f"{v:.6f}".rstrip("0").rstrip(".")
    rows = []
    for i, (time, tip, squeeze, edge) in enumerate(path.keys):
        tip = [round(c, 4) for c in tip]
        beside = round(tip[0] - x, 4)
        swings = beside and abs(abs(beside) - swing * spacing) < 1e-4
        across, front, depth = over(x if swings else tip[0], tip)
        keys = [f"speed = {path.speeds[i]:g}" if i else f"time = {time:.7g}",
                f"over = [{number(across)}, {number(front)}]", f"depth = {number(depth)}"]
        if swings:
            keys.append(f"cells = [{math.copysign(swing, beside):g}, 0, 0]")
        if i == 0:
            keys.append(f"rotation = {path.rotation(edge)}")
        rows.append("  { " + ", ".join(keys) + " },")
    return 'frame = "organ"\nkeys = [\n' + "\n".join(rows) + "\n]\n"
