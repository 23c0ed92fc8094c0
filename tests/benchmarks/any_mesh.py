#!/usr/bin/env python3
"""What contact costs on meshes from files, beside an elastic solve and beside a
refined brick.

Started by './run benchmark any_mesh [OPTIONS]', which builds the program first.
"""

import argparse
import os
import random
import subprocess
import sys
import tempfile

from parts.errors import BenchmarkError
from parts.solve import ROOT, add_program, solve
from parts.tables import markdown_table

MATERIAL = {"Material/Young's modulus": "2.119e11", "Material/Poisson ratio": "0.277"}
ALL = {
    "Contact solver/Method": "newton multigrid",
    "Contact solver/Tolerance": "1e-8",
    "Performance/Measure one elastic solve": "true",
    "Refinement/Estimate error": "false",
    "Output/Write solution": "false",
}
BRICK = {**MATERIAL, "Geometry/Table 1 level": "0"}
REFINED = {"Geometry/Lengths": "4, 3, 1", "Geometry/Subdivisions": "4, 3, 1"}


def brick_loads(front, back, top, bottom, middle):
    """The loads of the reference brick, boundaries by their names."""
    return {
        "Boundary conditions/Prescribed displacement": f"{front} : 0; 0; 0",
        "Boundary conditions/Traction": f"{top} : 0; 0; if(y > {middle:g}, -1e8, 0)"
        f" | {back} : 1e7; 2e7; 2e7",
        "Boundary conditions/Contact boundary": bottom,
    }


def write_mesh(file, cells, place, is_there=lambda i, j, k: True):
    """A block of cells in Gmsh's format 2.2.

    place(i, j, k) is where a node is, is_there(i, j, k) whether there is a cell.
    """
    numbers, nodes, elements = {}, [], []

    def node(i, j, k):
        if (i, j, k) not in numbers:
            numbers[i, j, k] = len(numbers) + 1
            nodes.append(place(i, j, k))
        return numbers[i, j, k]

    def is_cell(cell):
        return all(0 <= c < n for c, n in zip(cell, cells)) and is_there(*cell)

    names = {(1, -1): "front", (1, 1): "back", (2, -1): "bottom", (2, 1): "top"}
    ids = {side: n + 1 for n, side in enumerate(names)}
    for k in range(cells[2]):
        for j in range(cells[1]):
            for i in range(cells[0]):
                if not is_there(i, j, k):
                    continue
                ring = [(0, 0), (1, 0), (1, 1), (0, 1)]
                corners = [node(i + a, j + b, k + c) for c in (0, 1) for a, b in ring]
                elements.append("5 2 1 1 " + " ".join(map(str, corners)))
                for (axis, way), number in ids.items():
                    beside = [i, j, k]
                    beside[axis] += way
                    end = 0 if way < 0 else cells[axis] - 1
                    if is_cell(beside) or (i, j, k)[axis] != end:
                        continue
                    face = []
                    for a, b in ring:
                        at = [i, j, k]
                        others = [c for c in range(3) if c != axis]
                        at[others[0]] += a
                        at[others[1]] += b
                        at[axis] += way > 0
                        face.append(node(*at))
                    elements.append(f"3 2 {number} {number} " + " ".join(map(str, face)))
    with open(file, "w", encoding="utf-8") as out:
        out.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n5\n")
        for side, name in names.items():
            out.write(f'2 {ids[side]} "{name}"\n')
        out.write(f'3 1 "body"\n$EndPhysicalNames\n$Nodes\n{len(nodes)}\n')
        for n, place_of in enumerate(nodes):
            out.write(f"{n + 1} {place_of[0]:.12g} {place_of[1]:.12g} {place_of[2]:.12g}\n")
        out.write(f"$EndNodes\n$Elements\n{len(elements)}\n")
        for n, element in enumerate(elements):
            out.write(f"{n + 1} {element}\n")
        out.write("$EndElements\n")


def distorted(n):
    """The reference brick in cells whose inner nodes are moved by up to a fifth."""
    cells = (4 * n, 3 * n, n)
    noise = random.Random(1)

    def place(*at):
        return [
            (c + (noise.uniform(-0.2, 0.2) if 0 < c < end else 0)) / n
            for c, end in zip(at, cells)
        ]

    return cells, place, 1.5


def graded(n):
    """A block whose cells grow from 1 to 10 along y."""
    cells = (2 * n, 4 * n, n)
    growth = 10 ** (1 / (4 * n))

    def place(i, j, k):
        size = growth**j
        return [size * i / n, (size - 1) / (growth - 1) / n, size * k / n]

    return cells, place, place(0, 2 * n, 0)[1]


def flat(n):
    """Cells ten times as wide as high."""
    return (4 * n, 3 * n, n), lambda i, j, k: [i / n, j / n, 0.1 * k / n], 1.5


def fork(n):
    """Two arms, half a cell apart, at a handle: a cube of the grids has both."""
    cells = (2 * n + 1, 3 * n, n)

    def place(i, j, k):
        return [(i if i <= n else i - 0.5) / n, j / n, k / n]

    return cells, place, 1.5, lambda i, j, k: i != n or j < n


def cases(sizes):
    """Name, function of the mesh, its size."""
    for n in sizes:
        yield f"distorted, {n}", distorted, n
    for name, mesh in (("graded 1:10", graded), ("flat 10:10:1", flat), ("fork", fork)):
        yield name, mesh, sizes[0]


def write_bracket(file, size):
    """The shipped bracket in tetrahedra with edges of so many mm."""
    meshes = os.path.join(ROOT, "parameters", "meshes")
    command = [sys.executable, os.path.join(meshes, "step_to_msh.py")]
    command += [os.path.join(meshes, "bracket.step"), file, "--size", str(size)]
    command += ["--boundary", "wall=12", "--boundary", "hole=16"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise BenchmarkError(run.stderr.strip())


def numbers(text, option, kind):
    """What an option lists."""
    try:
        listed = [kind(word) for word in text.split(",") if word]
        if all(number > 0 for number in listed):
            return listed
    except ValueError:
        pass
    raise BenchmarkError(f"{option} must be numbers above 0, separated by commas")


def parse_options(arguments):
    """The options."""
    parser = argparse.ArgumentParser(
        prog="./run benchmark any_mesh",
        description="Solves contact on meshes from files without levels, of hexahedra "
        "and of cut tetrahedra, on row k = 6 of the paper's table and on a refined "
        "brick, and prints what it costs.",
    )
    add_program(parser)
    parser.add_argument(
        "--sizes",
        default="10,20",
        metavar="N,N",
        help="cells along the shortest edge of the bricks (10,20: 41,943 and 311,283 "
        "unknowns)",
    )
    parser.add_argument(
        "--brackets",
        default="4,2,1",
        metavar="MM,MM",
        help="edges of the bracket's tetrahedra (4,2,1: up to two million unknowns)",
    )
    parser.add_argument(
        "--poisson",
        default="0.49,0.499",
        metavar="NU,NU",
        help="Poisson ratios of a brick refined three times and of the first distorted "
        "one, with cell means of the volume strain",
    )
    options = parser.parse_args(arguments)
    options.poisson = numbers(options.poisson, "--poisson", float)
    options.sizes = numbers(options.sizes, "--sizes", int)
    options.brackets = numbers(options.brackets, "--brackets", float)
    if min(options.sizes, default=2) < 2:
        raise BenchmarkError("--sizes must be at least 2")
    return options


def row(name, summary, reference):
    """A line of the table; reference: microseconds an unknown of the refined brick."""
    solver, seconds = summary["solver"], summary["seconds"]
    unknowns = summary["problem"]["dofs"]
    cost = 1e6 * seconds["contact_solve"] / unknowns
    return [
        name,
        f"{unknowns:,}",
        solver["newton_steps"],
        f"{solver['krylov_iterations']}, {solver['elastic_solve_iterations']}",
        f"{seconds['contact_solve']:.2f} ({seconds['stiffness_setup']:.2f})",
        f"{seconds['elastic_solve']:.2f}",
        f"{solver['elastic_solve_equivalents']:.2f}",
        f"{cost / reference:.1f}" if reference else "1",
    ]


def main(arguments):
    """Prints the table."""
    options = parse_options(arguments)
    loads = brick_loads(2, 3, 5, 4, 1.5)
    rows, reference = [], None

    def measure(name, settings, parameters):
        print(f"{name} ...", file=sys.stderr, flush=True)
        summary = solve(options.program, parameters, {**ALL, **settings})
        rows.append(row(name, summary, reference))
        return summary

    def measure_brick(name, settings):
        return measure(name, {**BRICK, **settings}, "brick.prm")

    refined = measure_brick(
        "brick refined 4 times", {**REFINED, **loads, "Geometry/Global refinement": "4"}
    )
    reference = 1e6 * refined["seconds"]["contact_solve"] / refined["problem"]["dofs"]
    measure_brick("k = 6, refined once", {"Geometry/Table 1 level": "6"})
    rubber = [("0.277, cell mean", {"Material/Volume strain": "cell mean"})]
    rubber += [(f"{nu:g}", {"Material/Poisson ratio": f"{nu:g}"}) for nu in options.poisson]
    for name, material in rubber:
        measure_brick(
            f"brick refined 3 times, {name}",
            {**REFINED, **loads, **material, "Geometry/Global refinement": "3"},
        )
    with tempfile.TemporaryDirectory() as directory:
        for name, mesh, n in cases(options.sizes):
            file = os.path.join(directory, "mesh.msh")
            cells, place, middle, *is_there = mesh(n)
            write_mesh(file, cells, place, *is_there)
            settings = {
                "Geometry/Type": "file",
                "Geometry/Mesh file": file,
                **brick_loads("front", "back", "top", "bottom", middle),
            }
            measure_brick(name, settings)
            if (mesh, n) == (distorted, options.sizes[0]):
                for nu, material in rubber:
                    measure_brick(f"{name}, {nu}", {**settings, **material})
        for size in options.brackets:
            file = os.path.join(directory, "mesh.msh")
            write_bracket(file, size)
            measure(f"bracket, {size:g} mm", {"Geometry/Mesh file": file}, "bracket.prm")
    header = ["mesh", "unknowns", "Newton steps", "Krylov iterations: contact, elastic"]
    header += ["contact solve (its set-up) [s]", "elastic solve [s]"]
    header += ["worth in elastic solves", "contact solve an unknown / refined brick"]
    print("\n".join(markdown_table(header, rows)))


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except BenchmarkError as error:
        sys.exit(f"benchmark any_mesh: {error}")
