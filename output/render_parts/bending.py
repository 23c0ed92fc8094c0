"""Where an obstacle is drawn beside a body whose displacement is exaggerated.

Its place is that of the nearest point of the contact boundary as it is drawn, and
the gap from there: as many times larger as the displacement above a flat boundary, so
that it can be seen, and true beside a curved one, where it would give the obstacle
another shape. So what touches in truth does so in the picture. Numpy alone.
"""

import numpy as np

from . import meshes


def has_flat_sides(areas):
    """Whether these are the vector areas of a plane, or of sides of a brick."""
    normals = meshes.unit(areas[np.linalg.norm(areas, axis=1) > 0])
    first = normals[0]
    second = normals[np.argmin(np.abs(normals @ first))]
    frame = np.array([first, second, np.cross(first, second)])
    return (np.abs(normals @ frame.T).max(axis=1) > 1 - 1e-3).all()


def is_round(points, triangles):
    """Whether a surface is folded nearly everywhere, and hardly anywhere sharply."""
    corners = points[triangles]
    areas = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    sums = np.zeros(points.shape)
    np.add.at(sums, triangles, areas[:, None])
    away = np.linalg.norm(meshes.unit(sums)[triangles] - meshes.unit(areas)[:, None],
                          axis=-1).max(axis=1)
    share = np.linalg.norm(areas, axis=1) / np.linalg.norm(areas, axis=1).sum()
    return share[away > 0.3].sum() < 0.01 and share[away > 1e-6].sum() > 0.5


def weights_of(corners, places):
    """What the corners of triangles, (n, 3, 3), weigh at places in them, (n, 3)."""
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    opposite = np.stack([np.cross(corners[:, (i + 1) % 3] - places,
                                  corners[:, (i + 2) % 3] - places)
                         for i in range(3)], axis=1)
    parts = (opposite * normals[:, None]).sum(axis=-1)
    sums = parts.sum(axis=1, keepdims=True)
    return np.where(sums > 0, parts / np.where(sums > 0, sums, 1), 1 / 3)


def bent(places, near, factor, is_curved, is_flat, little):
    """The places of an obstacle in the picture, and how far off they are there.

    near: place before loading, displacement and unit normal of the nearest points of
    the contact boundary; is_curved: this boundary; is_flat: boundary and obstacle,
    then the obstacle is not drawn along with the body, which would bend its rim.
    little: by how much further off it is drawn, so that it does not shine through
    where it is touched.
    """
    way = places - near.place - near.displacement
    gap = (way * near.normal).sum(axis=1, keepdims=True)
    lift = np.full(gap.shape, little)
    displacement = near.displacement
    if is_flat:
        displacement = (displacement * near.normal).sum(
            axis=1, keepdims=True) * near.normal
    if is_curved:  # between their nodes faces are chords, and may be cut
        lift -= np.minimum(gap, 0)
        off = np.linalg.norm(way, axis=1)
    else:
        displacement = displacement + gap * near.normal
        off = factor * np.abs((displacement * near.normal).sum(axis=1))
    return places + (factor - 1) * displacement + lift * near.normal, off


def widened(places):
    """The points of a flat surface further apart, to be seen around the body.

    A foundation ends where its contact boundary does.
    """
    off = places - places.mean(axis=0)
    thickness = np.linalg.svd(off, compute_uv=False)[2]
    is_flat = thickness <= 1e-3 * np.linalg.norm(off)
    return places + 0.15 * off if is_flat else places
