#!/usr/bin/env python3
"""What a load history costs beside as many single solves.

Started by './run benchmark history [OPTIONS]', which builds the program first.
"""

import argparse
import statistics
import sys

from parts.errors import BenchmarkError
from parts.solve import add_program, solve
from parts.tables import markdown_table

END = 2.0
PRESS = "min(2*t, 1)"
DRAG = "sin(pi*t)"
ALL = {
    "Contact solver/Tolerance": "1e-8",
    "Performance/Measure one elastic solve": "true",
    "Refinement/Estimate error": "false",
    "Output/Write solution": "false",
    "Output/Every": "1000000",
}
MULTIGRID = {"Contact solver/Method": "newton multigrid"}
BRICK = {
    **MULTIGRID,
    "Geometry/Table 1 level": "0",
    "Geometry/Lengths": "4, 3, 1",
    "Geometry/Subdivisions": "4, 3, 1",
    "Material/Young's modulus": "2.1e11",
    "Material/Poisson ratio": "0.3",
    "Boundary conditions/Traction": "",
    "Boundary conditions/Contact boundary": "bottom",
    "Boundary conditions/Prescribed displacement": f"top : 1e-3*{DRAG}; 0; -1e-3*{PRESS}",
}
FILE = {
    "Contact solver/Method": "newton",
    "Boundary conditions/Prescribed displacement": f"top : 5e-4*{DRAG}; 0; -5e-4*{PRESS}",
}
BALL = {
    **MULTIGRID,
    "Geometry/Subdivisions": "5, 5, 3",
    "Boundary conditions/Obstacle": "sphere : 0.5; 0.5; 1.5; 1",
    "Boundary conditions/Obstacle displacement": f"0.1*{DRAG}; 0; -5e-3*{PRESS}",
}
# Name, parameter file, refinements of its mesh, part of the steps, its settings.
CASES = [
    ("dragged brick", "brick.prm", 4, 1.0, BRICK),
    ("dragged ball", "sphere.prm", 3, 1.0, BALL),
    ("mesh file, newton", "mesh_file.prm", 2, 0.2, FILE),
]


def parse_options(arguments):
    """The options."""
    parser = argparse.ArgumentParser(
        prog="./run benchmark history",
        description="Solves problems that are pressed, dragged and dragged back in many "
        "steps, and single problems with the loads of some of these times, and prints "
        "ratios of the two: of seconds, of iterations (Krylov iterations of newton "
        "multigrid on the mesh itself, products with Q of newton) and of the seconds of "
        "every phase.",
        allow_abbrev=False,
    )
    parser.add_argument(
        "--steps", type=int, default=100, help="of the history (100; mesh file: a fifth)"
    )
    parser.add_argument(
        "--singles", type=int, default=10, help="how many single solves (10)"
    )
    parser.add_argument(
        "--finer",
        type=int,
        default=0,
        help="refinements more, 1: a million unknowns in place of 100,000 (0)",
    )
    add_program(parser)
    options = parser.parse_args(arguments)
    if options.steps < 10 or not 1 <= options.singles <= options.steps // 5:
        raise BenchmarkError(
            "--steps must be at least 10, --singles from 1 to a fifth of them"
        )
    if not 0 <= options.finer <= 3:
        raise BenchmarkError("--finer must be from 0 to 3")
    return options


def iterations(counts):
    """Iterations on the mesh itself, of a step or of a single solve."""
    return counts["dual_multiplications"] or counts["krylov_iterations"]


def phases(summary):
    """Seconds by phase without those of the elastic solve measured beside."""
    seconds = dict(summary["seconds"])
    seconds["total"] -= seconds.pop("yardsticks")
    iteration = seconds["displacement_iteration"] or seconds["dual_iteration"]
    names = ["mesh", "assembly", "contact_surface", "stiffness_setup", "dual_operator"]
    return {
        "set-up": sum(seconds[name] or 0.0 for name in names),
        "contact iteration": iteration,
        "certificate": seconds["certificate"],
        "output": seconds["output"],
        "other": seconds["other"],
        "total": seconds["total"],
    }


def measure(options, case):
    """The summaries of the history and of the single solves."""
    _, name, level, part, settings = case
    n = round(options.steps * part)
    settings = {
        **ALL,
        **settings,
        "Geometry/Global refinement": level + options.finer,
    }
    history = solve(
        options.program,
        name,
        {
            **settings,
            "Time/End": END,
            "Time/Steps": n,
            "Time/Smallest step": END / n / 100,
        },
    )
    times = [
        END / n * round(n * (i + 0.5) / options.singles) for i in range(options.singles)
    ]
    singles = [
        solve(options.program, name, {**settings, "Time/End": t}) for t in times
    ]
    return n, history, singles


def line_of(title, n, history, singles):
    """A line of the first table: what a step costs beside a single solve."""
    steps = history["steps"]
    elastic = history["seconds"]["elastic_solve"]
    counts = [iterations(step) for step in steps]
    cold = statistics.mean(iterations(single["solver"]) for single in singles)
    worst = max(range(len(steps)), key=counts.__getitem__)
    of_phases = [phases(single) for single in singles]
    solve_cold, run_cold = (
        statistics.mean(seconds[name] for seconds in of_phases)
        for name in ("contact iteration", "total")
    )
    solve_all, run_all = (phases(history)[name] for name in ("contact iteration", "total"))
    return [
        title,
        history["problem"]["dofs"],
        f"{n}, {len(steps)}",
        f"{run_all / run_cold / n:.2f}",
        f"{solve_all / solve_cold / n:.2f}",
        f"{iterations(history['solver']) / cold / n:.2f}",
        f"{statistics.mean(counts):.1f}, {statistics.median(counts):g}, {cold:.1f}",
        f"{counts[worst]} at {steps[worst]['t']:g}",
        f"{solve_all / elastic / n:.2f}, {solve_cold / elastic:.2f}",
    ]


def seconds_of(title, n, history, singles):
    """A line of the second table: phases of the history in those of n single runs."""
    of_history = phases(history)
    of_single = [phases(single) for single in singles]
    cells = [title]
    for name, seconds in of_history.items():
        single = statistics.mean(run[name] for run in of_single)
        cells.append(f"{seconds:.1f} ({seconds / max(single * n, 1e-9):.2f})")
    return cells


def main(arguments):
    """Prints the two tables."""
    options = parse_options(arguments)
    results = []
    for case in CASES:
        print(f"{case[0]} ...", file=sys.stderr, flush=True)
        results.append((case[0], *measure(options, case)))
    header = ["history", "unknowns", "steps: asked for, taken", "seconds, ratio"]
    header += ["seconds of contact iteration, ratio", "iterations, ratio"]
    header += ["iterations of a step: mean, median, single solve", "worst, at t"]
    header += ["elastic solves' worth: step, single solve"]
    print("\n".join(markdown_table(header, [line_of(*result) for result in results])))
    header = ["seconds (ratio)", *phases(results[0][2])]
    print("\n".join(markdown_table(header, [seconds_of(*result) for result in results])))


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except BenchmarkError as error:
        sys.exit(f"benchmark history: {error}")
