#!/usr/bin/python3
"""Write crack.inp for Abaqus: a slice of a plate with a crack in its middle.

The lips of the crack, 'lower' and 'upper', have nodes of their own but for those of the
two tips, which both share.

Call:   make_crack.py [DIRECTORY]
"""

import os
import sys

HALF_LENGTH = 2.0  # mm
THICKNESS = 0.5
CELLS_OF_HALF = 10  # along the crack, and as many of this size beyond and across
GROWTH, HALF_WIDTH = 1.3, 20.0


def places():
    """Coordinates along x or z of one half: even cells, then ever larger ones."""
    size = HALF_LENGTH / CELLS_OF_HALF
    result = [size * i for i in range(CELLS_OF_HALF + 4)]
    while result[-1] + size < HALF_WIDTH:
        size *= GROWTH
        result.append(min(result[-1] + size, HALF_WIDTH))
    result[-1] = HALF_WIDTH
    return result


HALF = places()
LINES = [-x for x in HALF[:0:-1]] + HALF
CELLS = len(LINES) - 1
MIDDLE = CELLS // 2


def node(i, j, k, is_above=False):
    """The number of a node by its place in the grid; on the crack of two."""
    is_second = is_above and k == MIDDLE and abs(i - MIDDLE) < CELLS_OF_HALF
    return 1 + i + (CELLS + 1) * (j + 2 * k) + (100000 if is_second else 0)


def element(i, k):
    """The number of an element."""
    return 1 + i + CELLS * k


def nodes():
    """Lines of numbers and coordinates."""
    for k, z in enumerate(LINES):
        for j, y in enumerate((0, THICKNESS)):
            for i, x in enumerate(LINES):
                for number in sorted({node(i, j, k), node(i, j, k, True)}):
                    yield f"{number}, {x:.9g}, {y:.9g}, {z:.9g}"


def elements():
    """Lines of numbers and eight nodes."""
    for k in range(CELLS):
        for i in range(CELLS):
            around = [node(i + a, b, k + c, k >= MIDDLE) for c in (0, 1)
                      for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
            yield ", ".join(map(str, [element(i, k), *around]))


def surface(name, face, cells):
    """A surface of faces of elements."""
    return [f"*Surface, type=ELEMENT, name={name}",
            *(f"{element(i, k)}, {face}" for i, k in cells)]


def main():
    """Write the file."""
    everywhere = range(CELLS)
    along = range(MIDDLE - CELLS_OF_HALF, MIDDLE + CELLS_OF_HALF)
    grid = [(i, k) for k in everywhere for i in everywhere]
    lines = ["*Heading", "a plate with a crack, made by make_crack.py", "*Node",
             *nodes(), "*Element, type=C3D8, elset=plate", *elements(),
             *surface("bottom", "S1", [(i, 0) for i in everywhere]),
             *surface("top", "S2", [(i, CELLS - 1) for i in everywhere]),
             *surface("front", "S3", grid), *surface("back", "S5", grid),
             *surface("left", "S6", [(0, k) for k in everywhere]),
             *surface("right", "S4", [(CELLS - 1, k) for k in everywhere]),
             *surface("lower", "S2", [(i, MIDDLE - 1) for i in along]),
             *surface("upper", "S1", [(i, MIDDLE) for i in along])]
    directory = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(__file__)
    with open(os.path.join(directory, "crack.inp"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
