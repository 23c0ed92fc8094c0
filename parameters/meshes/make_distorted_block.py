#!/usr/bin/env python3
"""Writes the mesh of a distorted block in every format that stiction reads.

    python3 make_distorted_block.py DIRECTORY

makes distorted_block.msh (Gmsh 4.1), distorted_block_22.msh (Gmsh 2.2),
distorted_block.inp (Abaqus) and distorted_block.vtk: 4 x 3 x 3 hexahedra in
(0, 1.5) x (0, 1.2) x (0, 1) m, the nodes inside of the block, of its faces and
of its edges moved within them. The hexahedra begin at any of their corners, as
those of mesh generators do. The material 'lower' is the first layer of cells,
'upper' the others; the faces are left, right, front, back, bottom and top.
"""
import itertools
import pathlib
import random
import sys

SIZE = (1.5, 1.2, 1.0)
CELLS = (4, 3, 3)
BOUNDARIES = {"left": 11, "right": 12, "front": 13, "back": 14,
              "bottom": 15, "top": 16}
MATERIALS = {"lower": 21, "upper": 22}
CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
           (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
# the faces S1 to S6 of Abaqus
FACES = ((0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1),
         (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0))


def make_nodes(dice):
    """Positions by indices along the axes."""
    nodes = {}
    for index in itertools.product(*(range(n + 1) for n in CELLS)):
        nodes[index] = tuple(
            length / n * (i if i in (0, n) else i + dice.uniform(-0.2, 0.2))
            for i, n, length in zip(index, CELLS, SIZE))
    return nodes


def turned(corners, dice):
    """The same hexahedron from another of its corners on."""
    for _ in range(dice.randrange(3)):  # about a diagonal
        corners = [corners[i] for i in (0, 4, 5, 1, 3, 7, 6, 2)]
    for _ in range(dice.randrange(4)):  # about an axis
        corners = [corners[i] for i in (1, 2, 3, 0, 5, 6, 7, 4)]
    return corners


def make_cells(dice):
    """Lists of (indices of eight nodes, material)."""
    cells = []
    for i, j, k in itertools.product(*map(range, CELLS)):
        corners = [(i + a, j + b, k + c) for a, b, c in CORNERS]
        cells.append((turned(corners, dice), "lower" if k == 0 else "upper"))
    return cells


def boundary_of(face):
    """The boundary with these four nodes, or None."""
    names = iter(BOUNDARIES)
    for axis, n in enumerate(CELLS):
        for place in (0, n):
            name = next(names)
            if all(node[axis] == place for node in face):
                return name
    return None


def make_faces(cells):
    """Lists of (indices of four nodes, boundary, cell, face of the cell)."""
    faces = []
    for number, (corners, _) in enumerate(cells):
        for f, face in enumerate(FACES):
            nodes = [corners[v] for v in face]
            if boundary_of(nodes):
                faces.append((nodes, boundary_of(nodes), number, f))
    return faces


class Block:
    def __init__(self):
        dice = random.Random(1)
        self.nodes = make_nodes(dice)
        self.number = {index: i for i, index in enumerate(self.nodes)}
        self.cells = make_cells(dice)
        self.faces = make_faces(self.cells)

    def position(self, index):
        return " ".join(f"{x:.12g}" for x in self.nodes[index])

    def numbers(self, nodes, first, separator=" "):
        return separator.join(str(self.number[i] + first) for i in nodes)

    def gmsh_names(self):
        lines = ["$PhysicalNames", str(len(BOUNDARIES) + len(MATERIALS))]
        lines += [f'2 {n} "{name}"' for name, n in BOUNDARIES.items()]
        lines += [f'3 {n} "{name}"' for name, n in MATERIALS.items()]
        return lines + ["$EndPhysicalNames"]

    def gmsh_22(self):
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat"]
        lines += self.gmsh_names()
        lines += ["$Nodes", str(len(self.nodes))]
        lines += [f"{self.number[i] + 1} {self.position(i)}" for i in self.nodes]
        lines += ["$EndNodes", "$Elements", str(len(self.faces + self.cells))]
        number = 0
        for nodes, name, *_ in self.faces:
            number += 1
            lines.append(f"{number} 3 2 {BOUNDARIES[name]} 1 "
                         f"{self.numbers(nodes, 1)}")
        for nodes, name in self.cells:
            number += 1
            lines.append(f"{number} 5 2 {MATERIALS[name]} 1 "
                         f"{self.numbers(nodes, 1)}")
        return lines + ["$EndElements"]

    def gmsh_41(self):
        box = "0 0 0 1.5 1.2 1"
        lines = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat"]
        lines += self.gmsh_names()
        lines += ["$Entities", f"0 0 {len(BOUNDARIES)} {len(MATERIALS)}"]
        # entities have numbers of their own
        lines += [f"{e} {box} 1 {n} 0"
                  for e, n in enumerate(BOUNDARIES.values(), 1)]
        lines += [f"{e} {box} 1 {n} 0"
                  for e, n in enumerate(MATERIALS.values(), 1)]
        n = len(self.nodes)
        lines += ["$EndEntities", "$Nodes", f"1 {n} 1 {n}", f"3 1 0 {n}"]
        lines += [str(i + 1) for i in range(n)]
        lines += [self.position(i) for i in self.nodes]
        n = len(self.faces + self.cells)
        lines += ["$EndNodes", "$Elements",
                  f"{len(BOUNDARIES) + len(MATERIALS)} {n} 1 {n}"]
        number = itertools.count(1)
        for e, name in enumerate(BOUNDARIES, 1):
            faces = [face[0] for face in self.faces if face[1] == name]
            lines.append(f"2 {e} 3 {len(faces)}")
            lines += [f"{next(number)} {self.numbers(f, 1)}" for f in faces]
        for e, name in enumerate(MATERIALS, 1):
            cells = [nodes for nodes, material in self.cells
                     if material == name]
            lines.append(f"3 {e} 5 {len(cells)}")
            lines += [f"{next(number)} {self.numbers(c, 1)}" for c in cells]
        return lines + ["$EndElements"]

    def abaqus(self):
        lines = ["*HEADING", "distorted block", "** in m", "*NODE, NSET=Nall"]
        lines += [f"{self.number[i] + 1}, "
                  + self.position(i).replace(" ", ", ") for i in self.nodes]
        lines.append("*ELEMENT, TYPE=C3D8, ELSET=Eall")
        lines += [f"{101 + e}, {self.numbers(nodes, 1, ', ')}"
                  for e, (nodes, _) in enumerate(self.cells)]
        for name in MATERIALS:
            lines.append(f"*ELSET, ELSET=E{name}")
            lines += [f"{101 + e}," for e, (_, material)
                      in enumerate(self.cells) if material == name]
        for name in BOUNDARIES:
            lines.append(f"*SURFACE, TYPE=ELEMENT, NAME={name}")
            lines += [f"{101 + cell}, S{f + 1}" for _, boundary, cell, f
                      in self.faces if boundary == name]
        for name in MATERIALS:
            lines.append(f"*SOLID SECTION, ELSET=e{name}, MATERIAL={name}")
        return lines

    def vtk(self):
        lines = ["# vtk DataFile Version 3.0", "distorted block", "ASCII",
                 "DATASET UNSTRUCTURED_GRID",
                 f"POINTS {len(self.nodes)} double"]
        lines += [self.position(i) for i in self.nodes]
        n_cells, n_faces = len(self.cells), len(self.faces)
        lines.append(f"CELLS {n_cells + n_faces} {9 * n_cells + 5 * n_faces}")
        for number, (nodes, _) in enumerate(self.cells):
            # some programs list the top first
            if number % 5 == 0:
                nodes = nodes[4:] + nodes[:4]
            lines.append(f"8 {self.numbers(nodes, 0)}")
        lines += [f"4 {self.numbers(face[0], 0)}" for face in self.faces]
        lines.append(f"CELL_TYPES {n_cells + n_faces}")
        lines += ["12"] * n_cells + ["9"] * n_faces
        lines += [f"CELL_DATA {n_cells + n_faces}", "SCALARS MaterialID int 1",
                  "LOOKUP_TABLE default"]
        lines += [str(MATERIALS[name]) for _, name in self.cells]
        return lines + [str(BOUNDARIES[face[1]]) for face in self.faces]


def main():
    directory = pathlib.Path(sys.argv[1])
    block = Block()
    for name, lines in (("distorted_block.msh", block.gmsh_41()),
                        ("distorted_block_22.msh", block.gmsh_22()),
                        ("distorted_block.inp", block.abaqus()),
                        ("distorted_block.vtk", block.vtk())):
        (directory / name).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
