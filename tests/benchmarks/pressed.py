#!/usr/bin/env python3
"""What it costs to press an obstacle on with a force instead of moving it.

Started by './run benchmark pressed [OPTIONS]', which builds the program first.
"""

import argparse
import sys

from parts.errors import BenchmarkError
from parts.solve import add_program, solve

FORCE = "Boundary conditions/Obstacle force"
PLACE = "Boundary conditions/Obstacle displacement"
TWO = {
    "Geometry/Table 1 level": "0",
    "Geometry/Lengths": "4,3,1",
    "Geometry/Subdivisions": "4,3,1",
    "Boundary conditions/Traction": "",
    "Boundary conditions/Contact boundary": "bottom | top",
    "Boundary conditions/Obstacle": "foundation | sphere : 2; 2; 11; 10",
    "Contact solver/Tolerance": "1e-8",
}
# Name, parameter file, settings that belong to it.
CASES = [
    ("Hertz", "hertz.prm", {}),
    ("sliding sphere", "sliding_sphere.prm", {}),
    ("two obstacles", "brick.prm", {**TWO, FORCE: "0; 0; 3e7 | 0; 0; -2e7"}),
    ("forces 1e5 apart", "brick.prm", {**TWO, FORCE: "0; 0; 2e2 | 0; 0; -2e7"}),
]


def parse_options(arguments):
    """The options."""
    parser = argparse.ArgumentParser(
        prog="./run benchmark pressed",
        description="Solves contact problems with obstacles that forces press on, and "
        "again with the obstacles moved to where they were found, and prints the "
        "ratio of the two: of iterations (Krylov iterations of newton multigrid on "
        "the mesh itself, products with Q of newton) and of the seconds of the "
        "contact iteration.",
        allow_abbrev=False,
    )
    parser.add_argument(
        "--refinement", type=int, default=3, help="Geometry/Global refinement (3)"
    )
    parser.add_argument(
        "--methods", default="newton multigrid,newton", help="separated by commas"
    )
    add_program(parser)
    options = parser.parse_args(arguments)
    if not 0 <= options.refinement <= 8:
        raise BenchmarkError("--refinement must be from 0 to 8")
    return options


def cost(summary):
    """Iterations on the mesh itself, and seconds of the contact iteration."""
    solver, seconds = summary["solver"], summary["seconds"]
    products = solver.get("dual_multiplications") or solver["krylov_iterations"]
    time = seconds.get("displacement_iteration") or seconds.get("dual_iteration")
    return products, time


def compare(options, method, case):
    """A line of the table."""
    title, name, settings = case
    settings = {
        **settings,
        "Geometry/Global refinement": options.refinement,
        "Contact solver/Method": method,
        "Output/Write solution": "false",
        "Refinement/Estimate error": "false",
    }
    pressed = solve(options.program, name, settings)
    boundaries = pressed["contact"]["boundaries"]
    places = [
        "; ".join(f"{u:.17g}" for u in part["obstacle_displacement"])
        for part in boundaries
    ]
    still = " | ".join(["0; 0; 0"] * len(places))
    moved = solve(
        options.program, name, {**settings, FORCE: still, PLACE: " | ".join(places)}
    )
    forces = [
        [part["force_on_body"][2] for part in run["contact"]["boundaries"]]
        for run in (pressed, moved)
    ]
    apart = max(abs(a - b) / abs(b) for a, b in zip(*forces))
    (products, time), (products_moved, time_moved) = cost(pressed), cost(moved)
    return (
        f"{title:<18} {method:<18} {products:>8} {products_moved:>8}"
        f" {products / max(products_moved, 1):>6.2f} {time / time_moved:>8.2f}"
        f"   {apart:.0e}"
    )


def main(arguments):
    """Prints a line for each method and case."""
    options = parse_options(arguments)
    print("problem            method              pressed    moved  ratio  seconds   forces")
    for case in CASES:
        for method in options.methods.split(","):
            print(compare(options, method.strip(), case), flush=True)


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except BenchmarkError as error:
        sys.exit(f"benchmark pressed: {error}")
