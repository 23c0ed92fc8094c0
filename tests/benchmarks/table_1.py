#!/usr/bin/env python3
"""The paper's Table 1 for all methods: runs the program and writes tables.

Started by './run benchmark table_1 [OPTIONS]', which builds the program
first. Runs that are finished are kept, so that a second call goes on where
the first one was stopped.
"""

import os
import shlex
import sys
import time

from parts import cases, figures, machine, results, runs, tables
from parts.command import Parser, clock, exit_status, number
from parts.errors import BenchmarkError
from parts.solve import ROOT, add_program


def parse_options(arguments):
    """The options, with all lists turned into the names they mean."""
    parser = Parser(
        prog="./run benchmark table_1",
        description="Runs the paper's Table 1 with all methods and writes "
        "table_1.md, table_1.csv and plots. Finished runs are kept: a second "
        "call goes on where the first one was stopped.",
        allow_abbrev=False,
    )
    add = parser.add_argument
    add("--k", default="1-6", help="rows of the table, such as 1-4 or 1,3 (1-6)")
    add("--readings", default="A,B", help="A (nodes), B (unknowns) (A,B)")
    add("--laws", default="given,coulomb", help="given, coulomb (both)")
    add(
        "--methods",
        default=",".join(cases.METHOD),
        help=f"of {', '.join(cases.METHOD)} (all)",
    )
    add(
        "--tolerance",
        type=number(1e-12, 1e-2),
        default=1e-8,
        help="of the certificate (1e-8)",
    )
    add(
        "--limit",
        type=number(0.1, 1e6),
        default=120.0,
        help="seconds a run may take; larger k of the same method are then "
        "skipped (120)",
    )
    add(
        "--threads",
        type=number(1, 1024, int),
        default=1,
        help="of BLAS and OpenMP in the one process that runs at a time (1)",
    )
    add(
        "--output",
        default=os.path.join(ROOT, "output", "benchmark", "table_1"),
        help="directory of tables, plots and stored runs "
        "(output/benchmark/table_1)",
    )
    add_program(parser)
    add("--fresh", action="store_true", help="forget the stored runs, start over")
    add("--list", action="store_true", help="show what would be run, run nothing")
    add(
        "--report-only",
        action="store_true",
        help="only make tables and plots again, from the stored runs",
    )
    options = parser.parse_args(arguments)
    if options.fresh and (options.report_only or options.list):
        raise BenchmarkError("--fresh goes neither with --report-only nor with --list")

    readings = {"A": "A", "nodes": "A", "B": "B", "unknowns": "B"}
    laws = {law: law for law in cases.LAWS}
    methods = {method: method for method in cases.METHOD}
    options.levels = figures.parse_levels(options.k, cases.LEVELS)
    options.readings = figures.parse_names("--readings", options.readings, readings)
    options.laws = figures.parse_names("--laws", options.laws, laws)
    options.methods = figures.parse_names("--methods", options.methods, methods)
    options.cases = cases.all_cases(
        options.levels, options.readings, options.laws, options.methods
    )
    if not options.cases:
        raise BenchmarkError("none of these methods is for this law of friction")
    return options


class Benchmark:
    """The chosen cases, and which of them have been run."""

    def __init__(self, options, identity, program=None):
        self.options = options
        self.program = program
        self.store = runs.Store(options.output)
        if options.fresh:
            self.store.clear()
        stored = self.store.load()
        if identity is None:
            if not stored:
                raise BenchmarkError(
                    f"no run is stored in '{options.output}' to report on"
                )
            newest = max(stored.values(), key=lambda row: row["date"])
            identity = newest["program"]
        self.keys = {case: self._key(case, identity) for case in options.cases}
        self.rows = {
            case: stored[key] for case, key in self.keys.items() if key in stored
        }

    def _key(self, case, identity):
        with open(os.path.join(ROOT, case.parameter_file), encoding="utf-8") as file:
            parameters = file.read()
        options = self.options
        return runs.run_key(
            case.settings(options.tolerance), parameters, options.threads, identity
        )

    def is_done(self, case):
        """Whether the case has been run and need not be again."""
        return runs.is_finished(self.rows.get(case), self.options.limit)

    def is_hopeless(self, case):
        """Whether a smaller k of the same series already took too long."""
        return any(
            other.series == case.series
            and other.k < case.k
            and row["status"] == runs.LIMIT
            and self.is_done(other)
            for other, row in self.rows.items()
        )

    def what_is_left(self, todo):
        """Words for the runs to come and a guess of their time.

        The guess is that what a program does after its start grows like n^2
        from the last k of the same series.
        """
        seconds = 0.0
        known = True
        for case in todo:
            if self.is_hopeless(case):
                continue
            smaller = [
                (other.k, row)
                for other, row in self.rows.items()
                if other.series == case.series and other.k < case.k
            ]
            if not smaller:
                known = False
                continue
            k, row = max(smaller, key=lambda pair: pair[0])
            work = figures.look_up(row["summary"], "seconds/total") or 0.0
            growth = (cases.table_n(case.k) / cases.table_n(k)) ** 2
            guess = row["wall"] + work * (growth - 1)
            seconds += min(guess, self.options.limit)
        words = "about" if known else "more than"
        return f"{len(todo)} runs left, {words} {clock(seconds)}"

    def run(self, command):
        """Runs what has not been run, a line each."""
        options = self.options
        os.makedirs(options.output, exist_ok=True)
        todo = [case for case in options.cases if not self.is_done(case)]
        stored = len(options.cases) - len(todo)
        if stored:
            print(f"{stored} of {len(options.cases)} runs are stored already.")
        computer = machine.describe(self.program.path)
        start = time.monotonic()
        for index, case in enumerate(todo):
            head = f"[{stored + index + 1:3}/{len(options.cases)}] {describe(case)}"
            if self.is_hopeless(case):
                print(f"{head}  skipped, a smaller k was over the limit")
                continue
            self.program.check_unchanged()
            print(f"{head}  ", end="", flush=True)
            row = runs.run_case(
                self.program,
                ROOT,
                case,
                options.tolerance,
                options.threads,
                options.limit,
                options.output,
            )
            row.update(
                key=self.keys[case],
                program=self.program.identity,
                machine=computer,
                command=command,
            )
            self.rows[case] = row
            self.store.save(case.label, row)
            elapsed = clock(time.monotonic() - start)
            left = self.what_is_left(todo[index + 1 :])
            print(f"{outcome(row)}  ({elapsed} gone, {left})")


def describe(case):
    """A case in a line of fixed width."""
    return f"k={case.k} {case.reading} {case.law:7} {case.method:15}"


def outcome(row):
    """How a run ended, for its line."""
    if row["status"] == runs.LIMIT:
        return f"> {row['limit']:g} s"
    if row["status"] in (runs.ERROR, runs.CRASHED):
        return f"{row['status']}: {row['message']}"
    products = figures.look_up(row["summary"], "solver/dual_multiplications")
    words = f"{row['status']:13} {row['wall']:7.2f} s"
    return words if products is None else f"{words} {products:7.0f} products"


def show_plan(options, benchmark):
    """What --list prints."""
    for case in options.cases:
        if benchmark is None or not benchmark.is_done(case):
            state = "to run"
        else:
            state = f"stored, {outcome(benchmark.rows[case])}"
        print(f"{describe(case)}  {state}")
    print(f"{len(options.cases)} runs, of at most {options.limit:g} s each.")


def report(benchmark):
    """Writes all tables and plots."""
    options = benchmark.options
    if not benchmark.rows:
        raise BenchmarkError("none of the chosen runs is stored")
    result = results.Results(options.cases, benchmark.rows)
    tables.write_csv(result, os.path.join(options.output, "table_1.csv"))
    try:
        from parts import plots  # late: it would count as memory of the runs
    except ImportError:
        plots = None
        print("No plots: matplotlib is missing (Debian: python3-matplotlib).")
    names = plots.draw_all(result, options.output) if plots else []
    tables.write_markdown(result, names, os.path.join(options.output, "table_1.md"))
    where = os.path.relpath(options.output)
    print(f"Read {where}/table_1.md; every figure is in {where}/table_1.csv.")


def run_benchmark(arguments):
    """The benchmark with these options."""
    options = parse_options(arguments)
    if options.list and not os.path.exists(options.program):
        show_plan(options, None)
        return
    if options.report_only:
        report(Benchmark(options, None))
        return
    program = runs.Program(options.program)
    benchmark = Benchmark(options, program.identity, program)
    if options.list:
        show_plan(options, benchmark)
        return
    benchmark.run(shlex.join(["./run", "benchmark", "table_1", *arguments]))
    report(benchmark)


def main(arguments):
    """Runs the benchmark, returns the exit status."""
    return exit_status(run_benchmark, arguments)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
