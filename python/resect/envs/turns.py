"""Unit quaternions as arrays x y z w."""

import math

import numpy as np


def product(a, b):
    """The turn b, then the turn a."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return np.array([aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
                     aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz])


def from_vector(v):
    """The turn about v by its length, rad."""
    angle = math.sqrt(float(v @ v))
    if angle < 1e-12:
        return np.array([0.0, 0.0, 0.0, 1.0])
    return np.append(np.asarray(v) * (math.sin(angle / 2) / angle), math.cos(angle / 2))


def rotate(q, v):
    """v turned by q."""
    axis, w = q[:3], q[3]
    return v + 2 * np.cross(axis, np.cross(axis, v) + w * v)


def of_instrument(handle, edge):
    """The pose of an instrument whose handle (+Z) and edge (-Y) point in these directions of the world."""
    z = np.asarray(handle, float) / np.linalg.norm(handle)
    y = -np.asarray(edge, float)
    y -= z * (y @ z)
    y /= np.linalg.norm(y)
    m = np.column_stack([np.cross(y, z), y, z])
    # Shepperd's method: the largest component first.
    trace = m.trace()
    choices = np.array([m[0, 0], m[1, 1], m[2, 2], trace])
    i = int(np.argmax(choices))
    q = np.empty(4)
    if i == 3:
        q[3] = 1 + trace
        q[:3] = m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]
    else:
        j, k = (i + 1) % 3, (i + 2) % 3
        q[i] = 1 - trace + 2 * m[i, i]
        q[j], q[k] = m[j, i] + m[i, j], m[k, i] + m[i, k]
        q[3] = m[k, j] - m[j, k]
    return q / np.linalg.norm(q)
