#!/usr/bin/python3
"""Solve the verification battery: problems with answers that are known from elsewhere.

Started by './run verify [OPTIONS]', which builds the program first. Prints a line a
quantity, writes verification.md, verification.json and pictures; exit status 1 if one
line fails.
"""

import argparse
import os
import platform
import sys
import time

try:
    from battery import (hertz, invariances, manufactured, patch, random_bodies, report,
                         structures, tangential)
    from battery.case import ROOT, Row, Solver, stiction
except ModuleNotFoundError as missing:
    sys.exit(f"verify.py: needs the Debian package python3-{missing.name}")

CASES = {name: function for module in (
    patch, manufactured, hertz, tangential, structures, invariances, random_bodies)
         for name, function in module.CASES.items()}


def main(arguments):
    """Returns the exit status."""
    parser = argparse.ArgumentParser(prog="./run verify", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", nargs="*", metavar="CASE",
                        help="a word of the names of the cases to solve, all unless given: "
                             + "; ".join(CASES))
    parser.add_argument("--quick", action="store_true",
                        help="coarse meshes and what these can show, half a minute")
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "stiction"))
    parser.add_argument("--output", default=os.path.join(ROOT, "build", "verification"),
                        help="where the tables go")
    options = parser.parse_args(arguments)
    chosen = [name for name in CASES if not options.cases
              or any(word.lower() in name.lower() for word in options.cases)]
    unknown = [word for word in options.cases
               if not any(word.lower() in name.lower() for name in CASES)]
    if unknown:
        parser.error(f"there is no case '{unknown[0]}', there are " + "; ".join(CASES))
    results = []
    for number, name in enumerate(chosen, 1):
        results.append(solve(name, f"{number} of {len(chosen)}", options))
    report.write(options.output, machine(options.program), results, options.quick)
    rows = [row for _, case_rows, _, _ in results for row in case_rows]
    failed = [row for row in rows if not row.passed]
    print(f"{len(rows) - len(failed)} of {len(rows)} quantities are as they have to be; "
          f"{os.path.join(options.output, 'verification.md')} has them all")
    return 1 if failed else 0


def solve(name, place, options):
    """The rows, plots and seconds of a case; prints what remains, then the rows."""
    start, solved = time.perf_counter(), [0]

    def progress():
        solved[0] += 1
        if sys.stdout.isatty():
            print(f"\r{place}, {name}: {solved[0]} problems solved", end="", flush=True)

    solver = Solver(options.program, progress)
    try:
        rows, plots = CASES[name](solver, options.quick)
    except stiction.Error as error:
        rows, plots = [Row("the case", str(error), "solved", "", kind="same")], []
    rows += solver.rows
    seconds = time.perf_counter() - start
    print(f"\r{name} ({place}, {solved[0]} problems, {seconds:.1f} s)")
    for row in rows:
        print(f"  {'pass' if row.passed else 'FAIL'}  {row.quantity}: "
              f"{report.as_text(row.computed)}, reference {report.as_text(row.reference)}, "
              f"off by {report.deviation_text(row)}, allowed {report.allowed_text(row)}",
              flush=True)
    return name, rows, plots, seconds


def machine(program):
    """Program and machine in a line."""
    system = f"{platform.system()} {platform.machine()}"
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            model = next(line.split(":")[1].strip() for line in file if "model name" in line)
    except (OSError, StopIteration):
        model = system
    return f"{os.path.basename(program)} on {model}, {time.strftime('%B %Y')}"


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
