"""Plain meshes: the .ply files that Resect reads without the readers of other programs."""

import struct


def plain_mesh(surface):
    """The bytes of the file, as src/io/plain_mesh.h says; lengths in metres."""
    header = "ply\nformat binary_little_endian 1.0\ncomment Resect, metres\n"
    header += f"element vertex {len(surface.points)}\n"
    header += "".join(f"property double {axis}\n" for axis in "xyz")
    header += f"element face {len(surface.triangles)}\n"
    header += "property list uchar int vertex_indices\nend_header\n"
    points = b"".join(struct.pack("<3d", *point) for point in surface.points)
    return header.encode() + points + b"".join(struct.pack("<B3i", 3, *t) for t in surface.triangles)
