"""Bodies and contact boundaries for the tests of pictures; finds render_parts."""

import itertools
import os
import sys
from types import SimpleNamespace

try:
    import matplotlib.quiver  # pylint: disable=unused-import
    import numpy as np
except ImportError as error:
    print(f"Skipped: {error}")
    sys.exit(77)

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                "..", "..", "output"))
# pylint: disable=wrong-import-position
from render_parts import meshes


def hexahedra(cells, low=(0, 0, 0), high=(1, 1, 1)):
    """The corners of a grid of cells in a box, (n, 8, 3)."""
    unit = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0],
                     [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
    places = np.array(list(itertools.product(*map(range, cells))))
    low, high = np.array(low), np.array(high)
    return low + (places[:, None, :] + unit) / cells * (high - low)


def mesh_of(corners):
    """Points and outer faces of cells given by their corners."""
    first, number = meshes.merge(corners.reshape(-1, 3))
    faces = meshes.outer_faces(number.reshape(-1, 8), len(first))
    return corners.reshape(-1, 3)[first], faces


def side(points, faces, axis, place):
    """The faces in a plane."""
    return faces[np.isclose(points[faces][:, :, axis], place).all(axis=1)]


def contact_on(faces, boundary, status=(1, 1), friction=(1, 0, 0)):
    """Contact faces with the same status, pressure 2 and friction all over."""
    shape = faces.shape
    return SimpleNamespace(
        faces=faces, boundary=np.full(shape[0], boundary),
        normal_status=np.full(shape, status[0]),
        tangential_status=np.full(shape, status[1]), pressure=np.full(shape, 2.0),
        area=np.ones(shape),
        tangential_traction=np.broadcast_to(np.array(friction, dtype=float),
                                            (*shape, 3)).copy())


def joined(*contacts):
    """Several contact boundaries as one record of them all."""
    return SimpleNamespace(**{
        name: np.concatenate([getattr(contact, name) for contact in contacts])
        for name in vars(contacts[0])})


def cylinder_side(radius, length, n=24, m=3):
    """Points and faces of the side of a cylinder along z, seen from outside."""
    angles = 2 * np.pi * np.arange(n) / n
    points = np.array([[radius * np.cos(a), radius * np.sin(a), length * k / m]
                       for k in range(m + 1) for a in angles])
    faces = [[k * n + i, k * n + (i + 1) % n, (k + 1) * n + (i + 1) % n,
              (k + 1) * n + i] for k in range(m) for i in range(n)]
    return points, np.array(faces)
