#!/usr/bin/env python3
"""How 'newton multigrid' scales: sizes, ranks, friction, units; a report.

Started by './run benchmark scaling [OPTIONS]', which builds the programs
first. Runs that are finished are kept, so that a second call goes on where
the first one was stopped.
"""

import json
import os
import shlex
import sys
import time

from parts import figures, machine, runs, scaling_cases, scaling_report, stream
from parts.command import Parser, clock, exit_status, number, numbers
from parts.errors import BenchmarkError
from parts.scaling_results import Results
from parts.solve import ROOT, add_program
from parts.weak_scaling import Network

TOLERANCE = 1e-8
THREADS = 1


def parse_options(arguments):
    """The options, with all lists turned into what they mean."""
    parser = Parser(
        prog="./run benchmark scaling",
        description="Runs 'newton multigrid' on many sizes of the reference brick "
        "and writes scaling.md, scaling.csv and plots. Finished runs are kept: a "
        "second call goes on where the first one was stopped.",
        allow_abbrev=False,
    )
    add = parser.add_argument
    add(
        "--sizes",
        help="such as 4x3x1r5: cells along x, y and z, and how often they are "
        "refined (4x3x1, 6x4x1, 8x5x1, each r3 to r6)",
    )
    add(
        "--max-unknowns",
        type=number(1, 1e12),
        default=1e12,
        help="leaves larger sizes out (all)",
    )
    add(
        "--ranks",
        type=numbers(1, 1024, int),
        default=[1, 2],
        help="numbers of MPI ranks (1,2)",
    )
    add(
        "--repeat",
        type=number(1, 100, int),
        default=3,
        help="runs of each size, of which the shortest times count (3)",
    )
    add(
        "--repeat-up-to",
        type=number(1, 1e12),
        default=2e6,
        help="unknowns; larger sizes are run once (2e6)",
    )
    add(
        "--friction",
        type=numbers(0, 1e6),
        default=list(scaling_cases.FRICTION),
        help="coefficients (0,0.1,0.3,0.6,1,2,5)",
    )
    add(
        "--friction-max-unknowns",
        type=number(1, 1e12),
        default=1.3e6,
        help="largest 4x3x1 size on which they are run (1.3e6)",
    )
    add(
        "--parts",
        default=",".join(scaling_cases.PARTS),
        help=f"of {', '.join(scaling_cases.PARTS)} (all)",
    )
    add(
        "--time-limit",
        type=number(0.1, 1e6),
        default=600.0,
        help="seconds a run may take; larger sizes are then skipped (600)",
    )
    add(
        "--getfem-yardstick",
        type=number(1e-6, 1e6),
        help="seconds of the elastic solve of row 6 where GetFEM was measured; "
        "its time is taken as it is if this is left out",
    )
    add(
        "--unknowns-per-rank",
        type=number(1e3, 1e9),
        default=1e6,
        help="of the model of more ranks (1e6)",
    )
    add(
        "--latency",
        type=number(0, 1e6),
        default=2.0,
        help="of a message in that model, in microseconds (2)",
    )
    add(
        "--bandwidth",
        type=number(1e-6, 1e6),
        default=10.0,
        help="of a rank's network in that model, in GB/s (10)",
    )
    add(
        "--output",
        default=os.path.join(ROOT, "output", "benchmark", "scaling"),
        help="directory of tables, plots and stored runs (output/benchmark/scaling)",
    )
    add_program(parser)
    reference = "build/tests/benchmarks/benchmark_feevaluation_solve"
    add(
        "--reference-program",
        default=os.path.join(ROOT, *reference.split("/")),
        help=f"another build of FEEvaluation's elastic solve ({reference})",
    )
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
    parts = {part: part for part in scaling_cases.PARTS}
    options.parts = figures.parse_names("--parts", options.parts, parts)
    options.sizes = scaling_cases.choose_sizes(options.sizes, options.max_unknowns)
    if not options.sizes:
        raise BenchmarkError(
            f"no size has at most {options.max_unknowns:g} unknowns, see --max-unknowns"
        )
    options.cases = choose_cases(options)
    options.network = lambda memory: network(options, memory)
    return options


def choose_cases(options):
    """The runs of the program that the options ask for, short ones first."""
    cases = []
    if "row6" in options.parts:
        cases += scaling_cases.ROW_6_CASES
    if "units" in options.parts:
        cases += scaling_cases.unit_cases()
    if "friction" in options.parts:
        sizes = [
            size
            for size in bricks(options)
            if size.unknowns <= options.friction_max_unknowns
        ]
        cases += scaling_cases.friction_cases(sizes, options.friction)
    if "sizes" in options.parts:
        cases += scaling_cases.size_cases(
            options.sizes, options.ranks, options.repeat, options.repeat_up_to
        )
    return cases


def bricks(options):
    """The chosen sizes whose cells are cubes."""
    return [s for s in options.sizes if s.subdivisions == scaling_cases.BRICK]


def network(options, memory):
    """What the model takes for granted. memory: as stream.measure() found it."""
    measured = {"memory_bandwidth": memory["alone"]} if memory else {}
    return Network(1e-6 * options.latency, 1e9 * options.bandwidth, **measured)


def read_reference(row, said):
    """Adds the figures of FEEvaluation's line to a run of it."""
    if row["status"] != runs.CERTIFIED:
        return row
    try:
        return {**row, **json.loads(said.strip().splitlines()[-1])}
    except (ValueError, IndexError):
        return {**row, "status": runs.CRASHED, "message": "no line of JSON was printed"}


class Benchmark:
    """The chosen runs, and which of them have been done."""

    def __init__(self, options, identity, program=None, command=""):
        self.options = options
        self.program = program
        self.command = command
        self.store = runs.Store(options.output)
        if options.fresh:
            self.store.clear()
        self.stored = self.store.load()
        if identity is None:
            own = [row for row in self.stored.values() if "summary" in row]
            if not own:
                raise BenchmarkError(
                    f"no run is stored in '{options.output}' to report on"
                )
            identity = max(own, key=lambda row: row["date"])["program"]
        self.identity = identity
        with open(
            os.path.join(ROOT, scaling_cases.PARAMETER_FILE), encoding="utf-8"
        ) as file:
            parameters = file.read()
        self.keys = {
            case: runs.run_key(
                [*case.settings(TOLERANCE), f"{case.ranks} {case.repetition}"],
                parameters,
                THREADS,
                identity,
            )
            for case in options.cases
        }
        self.rows = {
            case: self.stored[key]
            for case, key in self.keys.items()
            if key in self.stored
        }
        self.start = time.monotonic()

    def is_done(self, case):
        """Whether it need not be run again."""
        return runs.is_finished(self.rows.get(case), self.options.time_limit)

    def is_hopeless(self, case):
        """Whether a smaller size of the same series already took too long."""
        return any(
            other.series == case.series
            and other.size
            and other.size.unknowns < case.size.unknowns
            and row["status"] == runs.LIMIT
            and self.is_done(other)
            for other, row in self.rows.items()
            if case.size
        )

    def _save(self, label, key, row, identity):
        row.update(
            key=key,
            program=identity,
            machine=machine.describe(self.program.path),
            command=self.command,
        )
        self.stored[key] = row
        self.store.save(label, row)

    def run(self):
        """Runs what has not been run, a line each."""
        options = self.options
        os.makedirs(options.output, exist_ok=True)
        todo = [case for case in options.cases if not self.is_done(case)]
        done = len(options.cases) - len(todo)
        if done:
            print(f"{done} of {len(options.cases)} runs are stored already.")
        self._measure_memory()
        for index, case in enumerate(todo):
            head = f"[{done + index + 1:3}/{len(options.cases)}] {case.words:44}"
            if self.is_hopeless(case):
                print(f"{head}  skipped, a smaller size was over the limit")
                continue
            self.program.check_unchanged()
            print(f"{head}  ", end="", flush=True)
            others = machine.others()
            row = runs.run_case(
                self.program,
                ROOT,
                case,
                TOLERANCE,
                THREADS,
                options.time_limit,
                options.output,
                case.ranks,
            )
            row["others"] = others
            self.rows[case] = row
            self._save(case.label, self.keys[case], row, self.identity)
            print(f"{outcome(row)}  ({self._gone()})")
        self._measure_reference()

    def _gone(self):
        return f"{clock(time.monotonic() - self.start)} gone"

    def _stream_key(self):
        return runs.run_key(["stream"], "", THREADS, self.identity)

    def _measure_memory(self):
        key = self._stream_key()
        if "stream" not in self.options.parts or key in self.stored:
            return
        print("Bandwidth of the memory, one process and two at once  ", end="")
        sys.stdout.flush()
        measured = stream.measure()
        if measured is None:
            print("not measured: numpy is missing (Debian: python3-numpy).")
            return
        row = {"date": time.strftime("%Y-%m-%d %H:%M"), "memory": measured}
        self._save("stream", key, row, self.identity)
        rates = " and ".join(f"{measured[k] / 1e9:.1f}" for k in ("alone", "together"))
        print(f"{rates} GB/s  ({self._gone()})")

    @property
    def memory(self):
        """What was measured of the memory, or None."""
        if "stream" not in self.options.parts:
            return None
        return self.stored.get(self._stream_key(), {}).get("memory")

    def _reference_key(self):
        """Of the run of FEEvaluation's program; None if there is none to run."""
        options = self.options
        sizes = bricks(options)
        wanted = "reference" in options.parts and "sizes" in options.parts
        if not wanted or not sizes or scaling_cases.REFERENCE_RANKS not in options.ranks:
            return None
        level = min(sizes[-1].refinement, scaling_cases.REFERENCE_MAX_REFINEMENT)
        settings = [f"reference {level}"]
        return runs.run_key(settings, "", THREADS, self.identity), level

    def _measure_reference(self):
        chosen = self._reference_key()
        if chosen is None:
            return
        key, level = chosen
        path = self.options.reference_program
        if runs.is_finished(self.stored.get(key), self.options.time_limit):
            return
        print(f"Elastic solve by FEEvaluation, 4x3x1r{level}  ", end="", flush=True)
        if not os.access(path, os.X_OK):
            print(f"not measured: there is no program '{path}'.")
            return
        ranks = scaling_cases.REFERENCE_RANKS
        command = runs.on_ranks(ranks, [path, str(level)])
        with runs.scratch_folder(self.options.output) as folder:
            row, said = runs.execute(
                command, THREADS, self.options.time_limit, folder
            )
        row = read_reference({**row, "level": level, "ranks": ranks}, said)
        self._save("reference", key, row, self.identity)
        if row["status"] != runs.CERTIFIED:
            print(row["message"] or row["status"])
            return
        print(f"{row['solve_seconds']:.2f} s  ({self._gone()})")

    @property
    def reference(self):
        """What was measured of FEEvaluation, or None."""
        chosen = self._reference_key()
        return self.stored.get(chosen[0]) if chosen else None

    def report(self):
        """Writes all tables and plots."""
        options = self.options
        if not self.rows:
            raise BenchmarkError("none of the chosen runs is stored")
        result = Results(options.cases, self.rows, self.memory, self.reference)
        folder = options.output
        scaling_report.write_csv(result, os.path.join(folder, "scaling.csv"))
        try:
            from parts import scaling_plots  # late: matplotlib may be missing
        except ImportError:
            scaling_plots = None
            print("No plots: matplotlib is missing (Debian: python3-matplotlib).")
        plots = (
            scaling_plots.draw_all(
                result, network(options, self.memory), options.unknowns_per_rank, folder
            )
            if scaling_plots
            else []
        )
        path = os.path.join(folder, "scaling.md")
        scaling_report.write_markdown(
            result, options, self.rows.values(), plots, path
        )
        for check in result.checks(options.getfem_yardstick):
            print(f"({check.number}) {check.asked}: {check.verdict}. {check.found}")
        where = os.path.relpath(folder)
        print(f"Read {where}/scaling.md; every figure is in {where}/scaling.csv.")


def outcome(row):
    """How a run ended, for its line."""
    if row["status"] == runs.LIMIT:
        return f"> {row['limit']:g} s"
    if row["status"] in (runs.ERROR, runs.CRASHED):
        return f"{row['status']}: {row['message']}"
    contact = figures.look_up(row["summary"], "seconds/contact_solve")
    words = f"{row['status']:13} {row['wall']:7.2f} s"
    return words if contact is None else f"{words}, contact {contact:7.2f} s"


def show_plan(options, benchmark):
    """What --list prints."""
    for case in options.cases:
        if benchmark is None or not benchmark.is_done(case):
            state = "to run"
        else:
            state = f"stored, {outcome(benchmark.rows[case])}"
        print(f"{case.words:44}  {state}")
    print(f"{len(options.cases)} runs, of at most {options.time_limit:g} s each.")


def run_benchmark(arguments):
    """The benchmark with these options."""
    options = parse_options(arguments)
    if options.list and not os.path.exists(options.program):
        show_plan(options, None)
        return
    if options.report_only:
        Benchmark(options, None).report()
        return
    program = runs.Program(options.program)
    command = shlex.join(["./run", "benchmark", "scaling", *arguments])
    benchmark = Benchmark(options, program.identity, program, command)
    if options.list:
        show_plan(options, benchmark)
        return
    benchmark.run()
    benchmark.report()


def main(arguments):
    """Runs the benchmark, returns the exit status."""
    return exit_status(run_benchmark, arguments)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
