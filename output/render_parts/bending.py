"""Where an obstacle is drawn beside a body whose displacement is exaggerated.

It has its own shape, moved along with what it touches, and is bent where the body as it
is drawn would cover it: a dent is as many times deeper as all displacements. Above a
flat boundary that is dented deeply its place is that of the nearest point there and the
gap from it, as many times larger as well. So what touches in truth does so in the
picture. Numpy alone.
"""

import numpy as np

from . import meshes

LITTLE = 0.003  # parts of the body by which an obstacle is drawn off it, to be seen

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
    return share[away > 0.5].sum() < 0.01 and share[away > 1e-6].sum() > 0.5


def weights_of(corners, places):
    """What the corners of triangles, (n, 3, 3), weigh at places in them, (n, 3)."""
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    opposite = np.stack([np.cross(corners[:, (i + 1) % 3] - places,
                                  corners[:, (i + 2) % 3] - places)
                         for i in range(3)], axis=1)
    parts = (opposite * normals[:, None]).sum(axis=-1)
    sums = parts.sum(axis=1, keepdims=True)
    return np.where(sums > 0, parts / np.where(sums > 0, sums, 1), 1 / 3)


def rigid_way(normals, displacement, weights, sticks):
    """How far an obstacle moves along with what it touches, (3,).

    It goes with nodes that stick to it, and along the normals with all others; where
    hardly any of these look there is no telling, and it stays.
    """
    held = np.where(sticks[:, None, None], np.eye(3),
                    normals[:, :, None] * normals[:, None, :])
    moved = weights @ (held @ displacement[:, :, None])[..., 0]
    return np.linalg.pinv((weights[:, None, None] * held).sum(axis=0), rcond=0.04,
                          hermitian=True) @ moved


def out_of_body(places, near, size):
    """Where a rigid obstacle is bent to, out of the body as it is drawn and onto its
    nodes that touch, and by how much.

    near: places, unit normals and closed, from 0 to 1, of the nearest points of the
    contact boundary; size: of the body.
    """
    way = places - near.place
    gap = (way * near.normal).sum(axis=1, keepdims=True)
    beside = np.linalg.norm(way - gap * near.normal, axis=1, keepdims=True)
    # what is far above is another side of the obstacle
    touches = near.closed * np.clip(2 - gap / (0.05 * size), 0, 1)
    way = -gap * np.where(gap < 0, 1, touches) * np.clip(
        1 - (beside / (0.1 * size))**2, 0, 1)
    return places + (way + LITTLE * size) * near.normal, np.abs(way).max(initial=0)


def with_large_gaps(places, near, factor, is_flat, size):
    """An obstacle above a flat boundary, and how far off it is.

    near: place before loading, displacement and unit normal of the nearest points of
    the contact boundary; is_flat: the obstacle as well, then it is not drawn along
    with the body, which would bend its rim.
    """
    way = places - near.place - near.displacement
    gap = (way * near.normal).sum(axis=1, keepdims=True)
    along = (near.displacement * near.normal).sum(axis=1, keepdims=True) + gap
    moved = along * near.normal if is_flat else near.displacement + gap * near.normal
    return (places + (factor - 1) * moved + LITTLE * size * near.normal,
            factor * np.abs(along[:, 0]))


def widened(places):
    """The points of a flat surface further apart, to be seen around the body.

    A foundation ends where its contact boundary does.
    """
    off = places - places.mean(axis=0)
    thickness = np.linalg.svd(off, compute_uv=False)[2]
    is_flat = thickness <= 1e-3 * np.linalg.norm(off)
    return places + 0.15 * off if is_flat else places
