#!/usr/bin/env python3
"""Products with K a second, beside those of deal.II's FEEvaluation.

Started by './run benchmark products [OPTIONS]', which builds the program that
measures first.
"""

import argparse
import csv
import json
import os
import signal
import subprocess
import sys

from parts import figures, machine, tables
from parts.errors import BenchmarkError

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
REFERENCE = "FEEvaluation"
COLUMNS = ["level", "dofs", "cells", "number", "product"]
COLUMNS += ["best_seconds", "median_seconds", "dofs_per_second", "ratio", "bytes"]
LEVELS = range(1, 9)


def parse_options(arguments):
    """The options, with the levels as a list."""
    parser = argparse.ArgumentParser(
        prog="./run benchmark products",
        description="Measures products of the stiffness matrix of the reference "
        "brick with a vector on one core and writes products.md and products.csv.",
        allow_abbrev=False,
    )
    parser.add_argument(
        "--levels", default="4", help="refinements of the brick, such as 3-5 (4)"
    )
    parser.add_argument(
        "--repetitions", type=int, default=50, help="of each product (50)"
    )
    parser.add_argument(
        "--output",
        default=os.path.join(ROOT, "output", "benchmark", "products"),
        help="directory of the tables (output/benchmark/products)",
    )
    parser.add_argument(
        "--program",
        default=os.path.join(ROOT, "build", "tests", "benchmarks", "benchmark_products"),
        help="another build of the program "
        "(build/tests/benchmarks/benchmark_products)",
    )
    options = parser.parse_args(arguments)
    options.levels = figures.parse_levels(options.levels, LEVELS, "--levels")
    if options.repetitions < 1:
        raise BenchmarkError("--repetitions must be at least 1")
    return options


def measure(program, level, repetitions):
    """The rows of a level."""
    command = [program, str(level), str(repetitions)]
    try:
        run = subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError as error:
        raise BenchmarkError(f"cannot run '{program}': {error.strerror}") from error
    if run.returncode != 0:
        last = run.stderr.strip().splitlines()[-1:] or ["it says nothing"]
        raise BenchmarkError(f"'{program}' failed: {last[0]}")
    return with_ratios([json.loads(line) for line in run.stdout.splitlines()])


def with_ratios(rows):
    """Adds rates, and how many times faster than the reference they are."""
    reference = {
        (row["cells"], row["number"]): row["best_seconds"]
        for row in rows
        if row["product"] == REFERENCE
    }
    for row in rows:
        row["dofs_per_second"] = row["dofs"] / row["best_seconds"]
        slow = reference[row["cells"], row["number"]]
        row["ratio"] = slow / row["best_seconds"]
    return rows


def table_of_level(rows):
    """A line a product, a column a kind of cell and of number."""
    kinds = list(dict.fromkeys((row["cells"], row["number"]) for row in rows))
    products = list(dict.fromkeys(row["product"] for row in rows))
    lines = []
    for product in products:
        line = [product]
        for kind in kinds:
            line += [
                f"{row['dofs_per_second'] / 1e6:.1f} ({row['ratio']:.1f})"
                for row in rows
                if (row["cells"], row["number"], row["product"]) == (*kind, product)
            ]
        lines.append(line)
    header = [""] + [f"{cells}, {number}" for cells, number in kinds]
    return tables.markdown_table(header, lines)


def write_markdown(rows, program, path):
    """The tables, and what they were measured on."""
    lines = ["# Products with the stiffness matrix", ""]
    lines += ["Million unknowns a second on one core, the best of all repetitions,"]
    lines += ["and in parentheses how many times FEEvaluation's rate that is. The"]
    lines += ["products take turns. `dst += a src` reads and writes the same vectors"]
    lines += ["and does nothing else: what memory and caches allow.", ""]
    for level in dict.fromkeys(row["level"] for row in rows):
        of_level = [row for row in rows if row["level"] == level]
        lines += [f"## Level {level}: {of_level[0]['dofs']} unknowns", ""]
        lines += table_of_level(of_level)
    lines += ["## Machine", ""]
    description = machine.describe(program)
    lines += [f"- {name}: {text}" for name, text in description.items()]
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


def write_csv(rows, path):
    """All figures."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        writer.writerows(rows)


def interrupt(*_):
    """SIGTERM ends the benchmark the way Ctrl-C does."""
    raise KeyboardInterrupt


def main(arguments):
    """Runs the benchmark, returns the exit status."""
    signal.signal(signal.SIGTERM, interrupt)
    try:
        options = parse_options(arguments)
        os.makedirs(options.output, exist_ok=True)
        # the program inherits it, and stays where its data are
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
        rows = []
        for level in options.levels:
            of_level = measure(options.program, level, options.repetitions)
            print(f"Level {level}, {of_level[0]['dofs']} unknowns:\n")
            print("\n".join(table_of_level(of_level)))
            rows += of_level
        table = os.path.join(options.output, "products.md")
        write_markdown(rows, options.program, table)
        write_csv(rows, os.path.join(options.output, "products.csv"))
        print(f"Million unknowns a second (times FEEvaluation), also in {table}")
    except BenchmarkError as error:
        print(f"benchmark: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("\nStopped.")
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
