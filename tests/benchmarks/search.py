#!/usr/bin/env python3
"""Random small contact problems by all methods, side by side.

Started by './run benchmark search [OPTIONS]', which builds the program that
solves them first.
"""

import argparse
import concurrent.futures
import json
import os
import subprocess
import sys
import tempfile

from parts.errors import BenchmarkError

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SMALLEST = 1e-8  # tolerance
LARGEST = 2**32  # of the seeds of the random numbers
AT_ONCE = 10  # problems of one start of the program


def parse_options(arguments):
    """The options."""
    parser = argparse.ArgumentParser(
        prog="./run benchmark search",
        description="Solves random small contact problems (boxes and half balls, "
        "contrasts of materials up to 1e8, F up to 5, far gaps) by all methods, "
        "and lists those whose certified forces differ or that newton does not "
        "certify. Tolerance 1e-8, or what newton advises where digits do not carry "
        "so far. The same numbers are the same problems.",
        allow_abbrev=False,
    )
    parser.add_argument("--first", type=int, default=1, help="first number (1)")
    parser.add_argument("--count", type=int, default=200, help="how many (200)")
    parser.add_argument(
        "--jobs", type=int, default=os.cpu_count(), help="at once (all cores)"
    )
    parser.add_argument(
        "--output",
        default=os.path.join(ROOT, "output", "benchmark", "search.jsonl"),
        help="a line of JSON for each problem (output/benchmark/search.jsonl)",
    )
    parser.add_argument(
        "--program",
        default=os.path.join(ROOT, "build", "tests", "benchmarks", "benchmark_search"),
        help="another build of the program (build/tests/benchmarks/benchmark_search)",
    )
    options = parser.parse_args(arguments)
    if options.count < 1 or options.first < 0 or options.jobs < 1:
        raise BenchmarkError("--count and --jobs must be at least 1, --first 0")
    if options.first + options.count > LARGEST:
        raise BenchmarkError(f"the last number must be below {LARGEST}")
    return options


def solve(program, first, last):
    """The problems of these numbers; throws where the program ends early."""
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    with tempfile.TemporaryDirectory() as directory:
        try:
            run = subprocess.run(
                [program, str(first), str(last)],
                capture_output=True,
                text=True,
                check=False,
                cwd=directory,
                env=environment,
            )
        except OSError as error:
            raise BenchmarkError(f"cannot run '{program}': {error.strerror}") from error
    lines = [line for line in run.stdout.splitlines() if line.startswith("{")]
    problems = [json.loads(line) for line in lines]  # BLAS may have its say, too
    if run.returncode != 0:
        lost = first + len(problems)
        raise BenchmarkError(
            f"'{program} {lost} {lost}' ended with status {run.returncode}: "
            + (run.stderr.strip().splitlines()[-1:] or ["it says nothing"])[0]
        )
    return problems


def is_different(problem, method):
    """Whether it certifies other forces than the first one that is certified."""
    return method["certified"] and method["distance"] > problem["agreement"]


def is_worth_a_look(problem):
    """Whether certified forces differ, or newton (the first) certifies none."""
    methods = problem["methods"]
    return not methods[0]["certified"] or any(
        is_different(problem, m) for m in methods
    )


def describe(problem):
    """What the methods made of a problem."""
    lines = [f"{problem['number']}: {problem['description']}"]
    for m in problem["methods"]:
        what = f"certified, {m['distance']:.1e} away" if m["certified"] else m["reason"]
        lines.append(f"    {m['method']:<18} {m['seconds']:5.1f} s  {what}")
    return "\n".join(lines)


def table(problems):
    """A line for each method."""
    lines = ["method              certified  of  different  longest"]
    for k, method in enumerate(m["method"] for m in problems[0]["methods"]):
        results = [problem["methods"][k] for problem in problems]
        certified = sum(m["certified"] for m in results)
        different = sum(is_different(p, p["methods"][k]) for p in problems)
        longest = max(m["seconds"] for m in results)
        lines.append(
            f"{method:<18} {certified:>9} {len(results):>5} {different:>9}"
            f" {longest:>7.1f} s"
        )
    tolerances = [p["tolerance"] for p in problems if p["tolerance"] > SMALLEST]
    if tolerances:
        lines.append(
            f"{len(tolerances)} with a larger tolerance than {SMALLEST:g}, where digits "
            f"do not carry so far: up to {max(tolerances):.1e}"
        )
    return "\n".join(lines)


def main(arguments):
    """Solves, lists and writes."""
    options = parse_options(arguments)
    try:
        search(options)
    except OSError as error:
        raise BenchmarkError(
            f"'{options.output}' cannot be written: {error.strerror}"
        ) from error


def search(options):
    """The problems of the options."""
    os.makedirs(os.path.dirname(os.path.abspath(options.output)), exist_ok=True)
    end = options.first + options.count
    chunks = [(n, min(n + AT_ONCE, end) - 1) for n in range(options.first, end, AT_ONCE)]
    problems = []
    with open(options.output, "w", encoding="utf-8") as file:
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            solved = pool.map(lambda chunk: solve(options.program, *chunk), chunks)
            for chunk in solved:
                for problem in chunk:
                    file.write(json.dumps(problem) + "\n")
                    if is_worth_a_look(problem):
                        print(describe(problem), flush=True)
                problems += chunk
                if sys.stderr.isatty():
                    print(f"\r{len(problems)}", end="", file=sys.stderr, flush=True)
    print(table(problems))


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except BenchmarkError as error:
        sys.exit(f"benchmark search: {error}")
