#!/usr/bin/python3
"""Write wedges.inp, an assembly for Abaqus: one part, a wedge of 10 degrees, and two
instances of it, the upper one turned upside down onto the lower one.

Call:   make_wedges.py [DIRECTORY]
"""

import math
import os
import sys

LENGTH, WIDTH, THIN = 40.0, 20.0, 4.0  # mm
SLOPE = math.tan(math.radians(10))
CELLS = (12, 5, 3)


def node(i, j, k):
    """The number of a node by its place in the grid."""
    return 1 + i + (CELLS[0] + 1) * (j + (CELLS[1] + 1) * k)


def element(i, j, k):
    """That of an element."""
    return 1 + i + CELLS[0] * (j + CELLS[1] * k)


def grid(sizes):
    """All places (i, j, k), i first."""
    return [(i, j, k) for k in range(sizes[2]) for j in range(sizes[1])
            for i in range(sizes[0])]


def nodes():
    """Lines of numbers and coordinates."""
    for i, j, k in grid([n + 1 for n in CELLS]):
        x, y = LENGTH * i / CELLS[0], WIDTH * j / CELLS[1]
        z = (THIN + (LENGTH - x) * SLOPE) * k / CELLS[2]
        yield f"{node(i, j, k)}, {x:.9g}, {y:.9g}, {z:.9g}"


def elements():
    """Lines of numbers and eight nodes."""
    for i, j, k in grid(CELLS):
        around = [node(i + a, j + b, k + c) for c in (0, 1)
                  for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
        yield ", ".join(map(str, [element(i, j, k), *around]))


def surface(name, face, axis, last, layers=range(CELLS[2])):
    """A set of elements at one side of the grid, and the surface of their faces."""
    sides = [place for place in grid(CELLS)
             if place[axis] == (CELLS[axis] - 1 if last else 0) and place[2] in layers]
    return [f"*Elset, elset=_{name}, internal",
            *(f"{element(*place)}," for place in sides),
            f"*Surface, type=ELEMENT, name={name}", f"_{name}, {face}"]


def main():
    """Write the file."""
    middle = THIN + 0.5 * LENGTH * SLOPE
    lines = ["*Heading", "two wedges of 10 degrees, mm", "*Part, name=Wedge", "*Node",
             *nodes(), "*Element, type=C3D8, elset=All", *elements(),
             *surface("base", "S1", 2, False), *surface("slope", "S2", 2, True),
             *surface("front", "S3", 1, False),
             *surface("grip", "S6", 0, False, [1]),
             "*Solid Section, elset=All, material=Steel", "*End Part",
             "*Assembly, name=Wedges", "*Instance, name=Lower, part=Wedge",
             "*End Instance", "*Instance, name=Upper, part=Wedge", "0., 0., 0.",
             f"{LENGTH / 2:.9g}, 0., {middle:.9g}, {LENGTH / 2:.9g}, 1., {middle:.9g}, "
             "180.", "*End Instance", "*End Assembly", "*Material, name=Steel"]
    directory = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(__file__)
    with open(os.path.join(directory, "wedges.inp"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
