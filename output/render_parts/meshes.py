"""The outer surface of a mesh of hexahedra, with numpy alone.

Points are arrays (n, 3); cells and faces hold numbers of points, (n, 8) and
(n, 4), in VTK's order.
"""

import numpy as np

# of a hexahedron, seen from outside against the clock
FACES = np.array([[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4],
                  [3, 7, 6, 2], [0, 3, 2, 1], [4, 5, 6, 7]])

# Of the largest displacement: points that differ by less move alike.
SAME_MOTION = 1e-5

# Of a body: a distance in a file of single precision that may be zero.
SINGLE_PRECISION = 1e-6


def merge(points, bodies=None, moved=None):
    """Number the points, those alike up to rounding alike.

    Returns the position of the first point of every number, and the number of
    every point. Points in files have single precision, and the same point
    seen from two cells may differ in its last digit.

    bodies: the number of the body of every point; those of different ones differ.
    moved: how far points move; those that do not move alike differ, as the lips of a
    crack do.
    """
    close = 2 * np.finfo(np.float32).eps * np.abs(points).max()
    places = np.empty(points.shape, dtype=np.int64)
    for c in range(3):
        values, inverse = np.unique(points[:, c], return_inverse=True)
        apart = np.diff(values, prepend=values[0]) > close
        places[:, c] = np.cumsum(apart)[inverse]
    sizes = places.max(axis=0) + 1  # their product is below 2^63 up to 10^18
    keys = (places[:, 0] * sizes[1] + places[:, 1]) * sizes[2] + places[:, 2]
    if bodies is not None:
        bodies = bodies.astype(np.int64)
        keys = keys * (bodies.max() + 1) + bodies
    _, first, number = np.unique(keys, return_index=True, return_inverse=True)
    apart = moved is not None
    while np.any(apart):  # more than once where several lips meet
        away = np.linalg.norm(moved - moved[first[number]], axis=1)
        apart = away > SAME_MOTION * np.linalg.norm(moved, axis=1).max()
        _, first, number = np.unique(2 * number + apart, return_index=True,
                                     return_inverse=True)
    return first, number


def face_keys(faces, n_points):
    """A number for each face, the same for the same points in any order."""
    random = np.random.default_rng(1).integers(
        2**63, size=n_points, dtype=np.uint64)
    return random[faces].sum(axis=1)  # modulo 2^64


def outer_faces(cells, n_points, cuts=None):
    """The faces of the cells that are on the surface, seen from outside.

    cuts: faces that are on it wherever they are, from both sides: of a closed crack.
    """
    faces = cells[:, FACES].reshape(-1, 4)
    keys = face_keys(faces, n_points)
    _, first, number, count = np.unique(keys, return_index=True, return_inverse=True,
                                        return_counts=True)
    outer = faces[first[count == 1]]
    outer = outer[~between_levels(outer, n_points)]
    if cuts is None:
        return outer
    is_cut = (count[number] > 1) & np.isin(keys, face_keys(cuts, n_points))
    return np.vstack([outer, faces[is_cut]])


def between_levels(faces, n_points):
    """Which of these faces are a large one, or one of the four opposite to it.

    Four small faces meet in the middle of a large one, and their corners
    opposite to this point are its corners.
    """
    points = faces.reshape(-1)
    opposite = faces[:, [2, 3, 0, 1]].reshape(-1)
    order = np.argsort(points, kind="stable")
    count = np.bincount(points, minlength=n_points)
    of_four = order[count[points[order]] == 4].reshape(-1, 4)
    large = face_keys(opposite[of_four], n_points)
    keys = face_keys(faces, n_points)
    inside = np.isin(keys, large)
    inside[of_four[np.isin(large, keys)] // 4] = True
    return inside


def vector_areas(corners):
    """Normal times area of quadrilaterals, (n, 4, 3) to (n, 3)."""
    return 0.5 * np.cross(corners[:, 2] - corners[:, 0],
                          corners[:, 3] - corners[:, 1])


def node_normals(faces, areas, n_points):
    """Unit normals at points from the vector areas of the faces around."""
    sums = np.stack([np.bincount(faces.reshape(-1), np.repeat(areas[:, c], 4),
                                 n_points) for c in range(3)], axis=1)
    return unit(sums)


def unit(vectors):
    """The vectors with length one, zero ones as they are."""
    lengths = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors / np.where(lengths > 0, lengths, 1)


def outline(points, faces, towards, angle=30):
    """The edges to draw of a surface seen from far off in a direction, (n, 2).

    Those where it is folded by more than an angle in degrees, and those
    between faces that are seen and faces that are not.
    """
    normals = unit(vector_areas(points[faces]))
    edges = np.stack([faces, np.roll(faces, -1, axis=1)], axis=-1).reshape(-1, 2)
    _, number, count = np.unique(face_keys(edges, len(points)),
                                 return_inverse=True, return_counts=True)
    order = np.argsort(number, kind="stable")
    pairs = order[count[number[order]] == 2].reshape(-1, 2)
    one, two = normals[pairs[:, 0] // 4], normals[pairs[:, 1] // 4]
    folded = (one * two).sum(axis=1) < np.cos(np.radians(angle))
    rim = (one @ towards > 0) != (two @ towards > 0)
    return edges[pairs[folded | rim, 0]]
