"""Contact boundaries laid flat: each seen along its mean normal, or unrolled.

A panel holds for each of its faces, corner by corner, the place in the plane
and the fields. Numpy alone.
"""

from types import SimpleNamespace

import numpy as np

from . import meshes
from .words import ROUNDING, number

# what a node is drawn as, by its normal and its tangential status
(OPEN, CLOSED, SLIP, STICK, OPEN_SLIP, OPEN_STICK, MAYBE_SLIP, MAYBE_STICK,
 UNDECIDED, PRESSED, CLAMPED, TIED) = range(12)
KIND = {(0, 0): OPEN, (1, 0): CLOSED, (1, 1): SLIP, (1, 2): STICK,
        (0, 1): OPEN_SLIP, (0, 2): OPEN_STICK, (3, 1): MAYBE_SLIP,
        (3, 2): MAYBE_STICK, (-1, -1): CLAMPED, (1, 4): TIED}  # all others are undecided
AXES = "xyz"
NOTHING = 1e-6  # parts of the largest pressure that are none
EVEN = 1e-3  # of all forces: with less of a resultant a cylinder is pressed all around
AT_EDGES = 0.1  # of the force: what a few nodes at an edge bear
PEAK = 3  # times the pressure elsewhere: with more of it at edges they set no scale
HARDLY = 1e-2  # of the largest pressure: tension that is not shown
PALE = 1 / 3  # of a scale: a boundary with less than that has one of its own
OPEN_ARC = 0.1  # of the area: a closed cylinder's area vectors add to nothing
WIDE = 0.65  # the cosine of half an arc: beyond it a view has its ends edge-on


def shown_pressure(contact, certified):
    """The pressure without that of nodes which are open or may as well be, which is
    rounding alone; of a run that is not certified all nodes may, and theirs is shown."""
    return np.where(np.isin(contact.normal_status, (0, 3)) & certified, 0,
                    contact.pressure)


def scale_of(pressure, areas):
    """The largest pressure that has a colour of its own: of all, but where a few nodes
    have several times that under which most of the force is borne, this."""
    order = np.argsort(pressure)
    borne = np.cumsum((np.maximum(pressure, 0) * areas)[order])
    usual, largest = pressure[order][[np.searchsorted(borne, (1 - AT_EDGES) * borne[-1]), -1]]
    return 1.2 * usual if largest > PEAK * usual > 0 else max(largest, 0)


def end_of_colors(ends, boundary):
    """Where the colours of a boundary end: with the largest of all boundaries, or with its
    own where nothing would be seen of it beside that."""
    own, largest = ends[boundary], ends.max()
    return own if ROUNDING * largest < own < PALE * largest else largest


def has_tension(panel):
    """Whether ties pull by more than a hundredth of what presses: less is of the mesh."""
    pulls = -panel.pressure[panel.kind == TIED].min(initial=0)
    return pulls > HARDLY * panel.pressure.max()


def touched(contact):
    """Of a certified step, what a map is laid out by: at which corners there may be
    forces, and the pressures."""
    kind = kinds(contact.normal_status, contact.tangential_status)
    return SimpleNamespace(loaded=(kind != OPEN) & (kind != CLAMPED),
                           pressure=shown_pressure(contact, True))


def panels_of(contact, points, certified=True, of_all_frames=None):
    """The panels of all contact boundaries.

    contact: faces, seen from outside, and fields at their corners; certified: the run;
    of_all_frames: what touched() returns of any of several steps that are to look alike.
    """
    corners = points[contact.faces]
    normals = meshes.vector_areas(corners)
    result = []
    for boundary in np.unique(contact.boundary):
        parts = visible_parts(normals, contact.boundary == boundary)
        for faces in parts:
            panel = SimpleNamespace(boundary=boundary, **{
                name: values[faces] for name, values in vars(contact).items()
                if name != "boundary"})
            panel.kind = kinds(panel.normal_status, panel.tangential_status)
            panel.pressure = shown_pressure(panel, certified)
            # without a certificate; with one no node like this has a pressure
            panel.kind[(panel.kind == UNDECIDED) & (panel.normal_status == 3) & (
                panel.pressure > NOTHING * contact.pressure.max())] = PRESSED
            panel.layout = SimpleNamespace(
                loaded=loaded(panel), pressure=panel.pressure) if of_all_frames is None \
                else SimpleNamespace(loaded=of_all_frames.loaded[faces],
                                     pressure=of_all_frames.pressure[faces])
            lay_flat(panel, corners[faces], normals[faces])
            if len(parts) > 1:  # opposite ones are seen from the same side
                panel.seen = f"facing {main_direction(normals[faces])}, {panel.seen}"
            show(panel, *window_of(panel))
            result.append(panel)
    return result


def kinds(normal, tangential):
    """What nodes are drawn as."""
    result = np.full(normal.shape, UNDECIDED)
    for status, kind in KIND.items():
        result[(normal == status[0]) & (tangential == status[1])] = kind
    return result


def visible_parts(normals, chosen):
    """Split a boundary into what can be seen from one side, or be unrolled."""
    faces = np.flatnonzero(chosen)
    if is_visible(normals[faces]) or cylinder_axis(normals[faces]) is not None:
        return [faces]
    across = np.argmax(np.abs(normals[faces]), axis=1)
    side = 2 * across + (normals[faces, across] > 0)
    return [faces[side == s] for s in np.unique(side)]


def is_visible(normals):
    """Whether hardly anything faces away from who looks along the mean."""
    facing = normals @ normals.sum(axis=0)
    areas = np.linalg.norm(normals, axis=1)
    scale = np.linalg.norm(normals.sum(axis=0)) * areas.sum()
    return scale > 0 and -facing[facing < 0].sum() <= 1e-3 * scale


def cylinder_axis(normals):
    """The direction of the axis if these are the normals of a cylinder.

    They are if they are in one plane, and neighbours there have small angles;
    one larger gap may be where the cylinder is not closed.
    """
    areas = np.linalg.norm(normals, axis=1)
    spread = (normals.T / areas) @ normals / areas.sum()
    values, vectors = np.linalg.eigh(spread)
    angles = np.sort(np.arctan2(*(normals @ vectors[:, 1:]).T))
    steps = np.sort(np.diff(angles, append=angles[0] + 2 * np.pi))
    if values[0] > 1e-3 or len(steps) < 4 or steps[-2] > 1:
        return None
    return snapped(vectors[:, 0])


def is_wide_arc(corners, normals):
    """Whether these are faces of a part of a cylinder that goes far around."""
    axis = cylinder_axis(normals)
    units = meshes.unit(normals)
    if axis is None or (units @ meshes.unit(units.sum(axis=0))).min() > WIDE:
        return False
    middles = corners.mean(axis=1)
    radii = np.linalg.norm(across(middles - axis_place(middles, units), axis), axis=1)
    return np.ptp(radii) < 0.05 * radii.mean()


def snapped(direction, near=1e-3):
    """A unit vector, an axis if it nearly is one, mostly upwards along it."""
    direction = direction / np.linalg.norm(direction)
    direction = np.where(np.abs(direction) < near, 0, direction)
    direction *= np.sign(direction[np.argmax(np.abs(direction))])
    return direction / np.linalg.norm(direction)


def lay_flat(panel, corners, normals):
    """Give the panel places in the plane, names of its axes, and friction."""
    if is_visible(normals) and not is_wide_arc(corners, normals):
        see_along(panel, corners, normals.sum(axis=0))
    else:
        unroll(panel, corners, normals)
    panel.friction = np.stack([(panel.tangential_traction * basis).sum(axis=-1)
                               for basis in panel.basis], axis=-1)


def see_along(panel, corners, mean):
    """Project on the plane across the mean normal."""
    view = snapped(mean, near=0.05)
    view *= -1 if np.argmax(np.abs(view)) == 1 else 1  # x to the right
    up = np.array([0, 0, 1]) if abs(view[2]) < 0.9 else np.array([0, 1, 0])
    up = meshes.unit(up - (up @ view) * view)
    panel.basis = np.cross(up, view), up
    panel.places = np.stack([corners @ basis for basis in panel.basis], axis=-1)
    panel.axes = [name_of(basis) for basis in panel.basis]
    panel.seen = "seen from " + name_of(view, signed=True)


def unroll(panel, corners, normals):
    """Lay a cylinder flat, cut opposite to where it is pressed if it is closed."""
    axis = cylinder_axis(normals)
    units = meshes.unit(normals)
    middles = corners.mean(axis=1)
    center = axis_place(middles, units)
    # normals of a hole point to its axis
    outward = np.sign(((middles - center) * normals).sum())
    units = outward * units
    forces = outward * panel.layout.pressure.mean(axis=1)[:, None] * normals
    pressed = across(forces.sum(axis=0), axis)
    if np.linalg.norm(pressed) <= EVEN * np.linalg.norm(forces, axis=1).sum():
        pressed = -np.eye(3)[2 if abs(axis[2]) < 0.9 else 1]
    middle = outward * normals.sum(axis=0)
    is_open = np.linalg.norm(middle) > OPEN_ARC * np.linalg.norm(normals, axis=1).sum()
    front = snapped_sign(middle if is_open else pressed, axis)
    side = np.cross(axis, front)
    radius = np.linalg.norm(across(middles - center, axis), axis=1).mean()

    def angle(points):
        return np.arctan2((points - center) @ side, (points - center) @ front)

    middle = angle(middles)[:, None]
    turned = angle(corners) - middle
    turned -= 2 * np.pi * np.round(turned / (2 * np.pi))
    panel.places = np.stack([radius * (middle + turned), corners @ axis],
                            axis=-1)
    panel.basis = np.cross(axis, units)[:, None, :], axis
    panel.axes = ["arc from " + name_of(front, signed=True), name_of(axis)]
    panel.seen = "unrolled, seen from outside"


def axis_place(points, normals):
    """The point that the lines through points along normals pass closest."""
    matrices = np.eye(3) - normals[:, :, None] * normals[:, None, :]
    right = np.einsum("nij,nj->i", matrices, points)
    return np.linalg.lstsq(matrices.sum(axis=0), right, rcond=1e-6)[0]


def across(vectors, axis):
    """The parts of vectors across an axis."""
    return vectors - (vectors @ axis)[..., None] * axis


def snapped_sign(direction, axis):
    """A unit vector across an axis, a coordinate axis if it nearly is one."""
    direction = meshes.unit(across(direction, axis))
    nearest = np.argmax(np.abs(direction))
    if abs(direction[nearest]) > 0.97 and abs(axis[nearest]) < 1e-6:
        direction = np.sign(direction[nearest]) * np.eye(3)[nearest]
    return direction


def name_of(direction, signed=False):
    """How a direction is called: x, +x where signed, or its components."""
    largest = np.argmax(np.abs(direction))
    if abs(direction[largest]) > 1 - 1e-6:
        sign = "-" if direction[largest] < 0 else "+" if signed else ""
        return sign.replace("-", "\N{MINUS SIGN}") + AXES[largest]
    return "(" + ", ".join(number(round(c, 2)) for c in direction) + ")"


def main_direction(normals):
    """The coordinate axis, with its sign, along which most of these look."""
    mean = normals.sum(axis=0)
    axis = np.argmax(np.abs(mean))
    return name_of(np.sign(mean[axis]) * np.eye(3)[axis], signed=True)


def loaded(panel):
    """At which corners there may be contact forces."""
    return (panel.kind != OPEN) & (panel.kind != CLAMPED)


def window_of(panel):
    """What of the plane is shown: its lower left and upper right corner.

    All of the boundary, or a small part where forces act with some room around.
    """
    low, high = (f(panel.places.reshape(-1, 2), axis=0) for f in (np.min, np.max))
    near = panel.places[panel.layout.loaded.any(axis=1)].reshape(-1, 2)
    if len(near):
        room = 0.15 * np.ptp(near, axis=0).max()
        inner = np.maximum(low, near.min(axis=0) - room)
        outer = np.minimum(high, near.max(axis=0) + room)
        if np.prod(outer - inner) < 0.3 * np.prod(high - low):
            return inner, outer
    return low, high


def show(panel, low, high):
    """Choose what of the plane is shown, and mark the faces that are then seen."""
    panel.window = low, high
    ends = panel.places.min(axis=1), panel.places.max(axis=1)
    panel.enlarged = (low > ends[0].min(axis=0)).any() or (high < ends[1].max(axis=0)).any()
    panel.shown = ((ends[1] >= low) & (ends[0] <= high)).all(axis=1)


def counts(panel):
    """How many nodes are of each kind that there is.

    Hanging nodes, which have no area, are no contact nodes of their own.
    """
    own = (panel.area > 0) | (panel.kind == CLAMPED)
    _, first = np.unique(panel.faces[own], return_index=True)
    found, count = np.unique(panel.kind[own][first], return_counts=True)
    return dict(zip(found.tolist(), count.tolist()))


def quarters(panel, kind):
    """The parts of faces nearest to corners of a kind, (n, 4, 2)."""
    places = panel.places[panel.shown]
    middle = places.mean(axis=1, keepdims=True)
    after = (places + np.roll(places, -1, axis=1)) / 2
    before = (places + np.roll(places, 1, axis=1)) / 2
    parts = np.stack([places, after, np.broadcast_to(middle, places.shape),
                      before], axis=2)
    return parts[panel.kind[panel.shown] == kind]


def subdivided(panel, pieces):
    """Places and pressures of faces cut into pieces x pieces, (n, k, k, ...)."""
    s = np.linspace(0, 1, pieces + 1)
    one, two = np.meshgrid(s, s, indexing="ij")
    weights = np.stack([(1 - one) * (1 - two), one * (1 - two), one * two,
                        (1 - one) * two])
    return (np.einsum("kij,nkc->nijc", weights, panel.places[panel.shown]),
            np.einsum("kij,nk->nij", weights, panel.pressure[panel.shown]))


def some_arrows(panel, scale, apart):
    """Places and friction of loaded nodes, not too many, and their distance.

    scale: inches a unit of length to the right and upwards; apart: the least
    distance in inches.
    """
    low, high = panel.window
    near = loaded(panel) & ((panel.places >= low)
                              & (panel.places <= high)).all(axis=-1)
    _, first = np.unique(panel.faces[near], return_index=True)
    places, friction, areas = (values[near][first] for values in
                               (panel.places, panel.friction, panel.area))
    chosen = spread_out(places * scale, apart)
    area = areas.sum() * np.prod(scale)
    return (places[chosen], friction[chosen],
            max(apart, np.sqrt(area / max(len(chosen), 1))))


def spread_out(places, apart):
    """Choose places, row by row, that are not nearer to one another."""
    chosen, squares = [], {}
    for i in np.lexsort(np.round(places / apart, 3).T):
        x, y = places[i]
        column, row = int(x // apart), int(y // apart)
        around = (place for dx in (-1, 0, 1) for dy in (-1, 0, 1)
                  for place in squares.get((column + dx, row + dy), ()))
        if all(np.hypot(x - a, y - b) > 0.999 * apart for a, b in around):
            squares.setdefault((column, row), []).append((x, y))
            chosen.append(i)
    return np.array(chosen, dtype=int)
