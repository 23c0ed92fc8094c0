#!/usr/bin/env python3
"""What contact of two elastic bodies costs, beside one body on a rigid foundation and
beside an elastic solve of both.

Started by './run benchmark pairs [OPTIONS]', which builds the program first.
"""

import argparse
import os
import sys
import tempfile

from parts.errors import BenchmarkError
from parts.solve import add_program, solve
from parts.tables import markdown_table

YOUNG = 2.119e11
LEVELS = "8, 6, 2", "10, 8, 2"  # coarse cells of brick and slab, to be refined
WITHOUT_LEVELS = "28, 24, 8", "30, 26, 6"
PILE = 50  # blocks

ALL = """
subsection Contact solver
  set Method    = newton multigrid
  set Tolerance = {tolerance}
end
subsection Refinement
  set Estimate error = false
end
subsection Output
  set Write solution = false
end
subsection Performance
  set Measure one elastic solve = {measure}
end
"""


def body(name, lengths, cells, place, stiffness=YOUNG, poisson=0.277):
    """A brick of a material of its own."""
    return f"""
subsection Body {name}
  set Lengths         = {lengths}
  set Subdivisions    = {cells}
  set Translation     = {place}
  set Young's modulus = {stiffness:g}
  set Poisson ratio   = {poisson:g}
  set Density         = 1
end
"""


def brick(cells, refinement, slab_cells=None, slab_stiffness=YOUNG):
    """The reference brick on a rigid foundation, or on a slab."""
    text = body("brick", "4, 3, 1", cells, "0; 0; 0")
    if slab_cells:
        text += body("slab", "6, 5, 1", slab_cells, "-1; -1; -1", slab_stiffness)
    opposite = "boundary : slab.top" if slab_cells else "foundation"
    # newton multigrid wants the forces on the softer side
    side = "obstacle" if slab_stiffness < YOUNG else "boundary"
    held = " | slab.bottom : 0; 0; 0" if slab_cells else ""
    return f"""{text}
subsection Geometry
  set Global refinement = {refinement}
end
subsection Boundary conditions
  set Prescribed displacement = brick.front : 0; 0; 0{held}
  set Traction                = brick.top : 0; 0; -1e8 * (y > 1.5) \\
                              | brick.back : 1e7; 2e7; 2e7
  set Contact boundary        = brick.bottom
  set Obstacle                = {opposite}
  set Slave side              = {side if slab_cells else "automatic"}
end
subsection Friction
  set Law         = coulomb
  set Coefficient = 0.3
end
""" + ALL.format(tolerance="1e-8", measure="true")


def pile(slope):
    """Blocks on one another on a slope, of which the joint below the last five bears
    least, 0.02."""
    text = ""
    for i in range(1, PILE + 1):
        cells = "3, 3, 1" if i % 2 == 0 else "2, 2, 1"
        text += body(f"b{i}", "1, 1, 0.5", cells, f"0; 0; {0.5 * (i - 1):g}", 1000, 0.3)
        if i > 1:
            text += f"""
subsection Contact pair {i}
  set Boundary    = b{i}.bottom
  set Obstacle    = boundary : b{i - 1}.top
  set Law         = coulomb
  set Coefficient = {0.02 if i == PILE - 4 else 0.5}
end
"""
    return f"""{text}
subsection Boundary conditions
  set Prescribed displacement = b1.bottom : 0; 0; 0
  set Gravity                 = {slope}; 0; -1
end
""" + ALL.format(tolerance="1e-6", measure="false")


def cases(finest):
    """Name, parameter file."""
    for level in range(2, finest + 1):
        yield f"one body, refined {level} times", brick(LEVELS[0], level)
        for ratio in (1.0, 1e3, 1e-3):
            yield (
                f"two, the lower {ratio:g} times as stiff",
                brick(LEVELS[0], level, LEVELS[1], ratio * YOUNG),
            )
    yield "one body without levels", brick(WITHOUT_LEVELS[0], 0)
    yield "two without levels", brick(WITHOUT_LEVELS[0], 0, WITHOUT_LEVELS[1])
    yield f"{PILE} blocks in a pile, at 0.99 of the slope they bear", pile(0.0198)


def row(name, summary):
    """A line of the table."""
    solver, seconds = summary["solver"], summary["seconds"]
    worth, elastic = solver["elastic_solve_equivalents"], solver["elastic_solve_iterations"]
    return [
        name,
        f"{summary['problem']['dofs']:,}",
        solver["newton_steps"],
        f"{solver['krylov_iterations']}, {elastic or '-'}",
        f"{seconds['contact_surface']:.2f}",
        f"{seconds['contact_solve']:.2f}",
        f"{worth:.2f}" if worth else "-",
    ]


def parse_options(arguments):
    """The options."""
    parser = argparse.ArgumentParser(
        prog="./run benchmark pairs",
        description="Solves contact of two bodies whose meshes do not match, and a pile "
        "of many, by newton multigrid, and prints what it costs.",
    )
    add_program(parser)
    parser.add_argument(
        "--finest",
        type=int,
        default=4,
        metavar="N",
        help="refinements of the largest pair (4: three million unknowns, 5: 26)",
    )
    options = parser.parse_args(arguments)
    if options.finest < 2:
        raise BenchmarkError("--finest must be at least 2")
    return options


def main(arguments):
    """Prints the table."""
    options = parse_options(arguments)
    rows = []
    with tempfile.TemporaryDirectory() as directory:
        file = os.path.join(directory, "case.prm")
        for name, text in cases(options.finest):
            print(f"{name} ...", file=sys.stderr, flush=True)
            with open(file, "w", encoding="utf-8") as out:
                out.write(text)
            rows.append(row(name, solve(options.program, file, {})))
    header = ["bodies", "unknowns", "Newton steps", "Krylov iterations: contact, elastic"]
    header += ["finding what lies opposite [s]", "contact solve [s]"]
    header += ["worth in elastic solves of both"]
    print("\n".join(markdown_table(header, rows)))


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except BenchmarkError as error:
        sys.exit(f"benchmark pairs: {error}")
