#!/usr/bin/env python3
"""Make things go wrong outside of the program and see that it ends as it should.

Call:   faults.py PROGRAM FAULTS_LIBRARY [--every N] [--only KIND,...]

A small problem with two steps, checkpoints and an exported problem runs once for each
moment at which something can go wrong, or each N-th: the disk is full from then on, the
output directory is gone, a sum is no number, a solve of MUMPS has a NaN or no memory,
SIGTERM, a killed rank, a full /dev/shm. What must hold each time:

- the run ends in time, with status 0 only if the fault changed nothing: the answer is
  that of a run without it, and every file is there;
- otherwise with another status and a sentence;
- a disk that is full leaves of an earlier run all or nothing, and every file that is
  there can be read to its end.

Exit status 1 and what was seen if not.
"""

import argparse
import collections
import concurrent.futures
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

BRICK = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))),
                     "errors", "brick.prm")
SECONDS = 60
SETTINGS = ("Time/Steps=2", "Time/Checkpoint every=1", "Output/Double precision=true",
            "Contact solver/Tolerance=1e-8")
WITHOUT = [("memory", "newton multigrid"), ("solve", "newton multigrid")]  # no MUMPS
METHODS = {"newton": (), "newton multigrid": ("Geometry/Global refinement=2",)}


class Run:
    """One run with a fault, in a directory of its own, over results of an earlier one."""

    def __init__(self, top, fault, method="newton", ranks=1, earlier=None):
        self.name = f"{fault}, {method}, {ranks} rank" + "s" * (ranks > 1)
        self.fault = fault
        directory = tempfile.mkdtemp(dir=top)
        self.results = os.path.join(directory, "results")
        self.before = {}
        if earlier:
            shutil.copytree(earlier, self.results)
            self.before = contents(self.results)
        command = [PROGRAM, BRICK, "--output", self.results]
        settings = SETTINGS + METHODS[method] + (f"Contact solver/Method={method}",)
        if method == "newton":
            settings += (f"Output/Export directory={self.results}/problem",)
        for setting in settings:
            command += ["--set", setting]
        count = os.path.join(directory, "count")
        environment = {"STICTION_FAULT": fault, "STICTION_FAULT_BELOW": self.results,
                       "STICTION_FAULT_COUNT": count, "LD_PRELOAD": LIBRARY}
        if ranks > 1:
            command = ["mpirun", "--oversubscribe", "-n", str(ranks)] + [
                word for name, value in environment.items()
                for word in ("-x", f"{name}={value}")] + command
            environment = {}
        done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS,
                              env={**os.environ, **environment}, check=False)
        self.status, self.stdout, self.stderr = done.returncode, done.stdout, done.stderr
        self.n = 0
        if os.path.exists(count):
            with open(count, encoding="ascii") as file:
                self.n = int(file.read())
        self.files = contents(self.results)
        self.answer = answer(self.results)
        self.faults = list(unreadable(self.results))
        shutil.rmtree(directory)

    def check(self, unharmed):
        """What is not as it should be, given a run that nothing happened to."""
        kind = self.fault.partition(":")[0]
        if self.status == 0:
            if not (self.answer and close(self.answer, unharmed.answer)):
                yield "certified, and the answer is another one"
            if kind in ("disk", "removed") and set(self.files) != set(unharmed.files):
                yield "status 0, and files are missing"
        elif self.status == 1 or kind in ("disk", "removed"):
            if self.status != 1:
                yield "status 1 is what a full disk ends in"
            if not re.search(r"^stiction: .*\.$", self.stderr, re.M):
                yield "no sentence"
            if "internal error" in self.stderr:
                yield "an internal error"
        elif self.status in (2, 3):
            if "NOT CONVERGED" not in self.stdout + self.stderr and \
                    "interrupted" not in (self.stdout + self.stderr).lower():
                yield "no verdict"
        elif kind != "killed" and not (self.status == -15 and not self.stdout):
            yield "a status that is none"
        if self.status != 0 and kind not in ("disk", "removed") and \
                "\nCERTIFIED" in self.stdout:
            yield "CERTIFIED, and another status"
        if kind == "disk":
            kept = [name for name in self.before
                    if self.files.get(name) == self.before[name]]
            if 0 < len(kept) < len(self.before):
                yield f"of the earlier run are left {sorted(kept)}"
        if kind != "removed":  # who removes files removes half of them
            yield from self.faults


def contents(directory):
    """Size and time of every file."""
    found = {}
    for folder, _, names in os.walk(directory):
        for name in names:
            path = os.path.join(folder, name)
            status = os.stat(path)
            found[os.path.relpath(path, directory)] = (status.st_size,
                                                       status.st_mtime_ns)
    return found


def answer(directory):
    """The numbers of an answer, if there is one."""
    try:
        with open(os.path.join(directory, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        return summary["contact"]["force_on_body"] + [summary["energy"]["strain"]]
    except (OSError, ValueError, KeyError):
        return None


def close(some, others):
    """Whether numbers agree as two certified answers do."""
    size = max(abs(number) for number in others)
    return all(abs(a - b) <= 1e-6 * size for a, b in zip(some, others))


def unreadable(directory):
    """Every file that is cut off."""
    for folder, _, names in os.walk(directory):
        for name in names:
            path = os.path.join(folder, name)
            shown = os.path.relpath(path, directory)
            if name.endswith(".new"):
                yield f"{shown} is left"
            try:
                if name.endswith((".vtu", ".pvtu", ".pvd")):
                    xml.etree.ElementTree.parse(path)
                elif name.endswith(".json"):
                    with open(path, encoding="utf-8") as file:
                        json.load(file)
                elif name.endswith(".csv"):
                    with open(path, encoding="utf-8") as file:
                        rows = file.read().split("\n")
                    if rows[-1] or len({row.count(",") for row in rows[:-1]}) > 1:
                        yield f"{shown} is cut off"
            except (ValueError, xml.etree.ElementTree.ParseError):
                yield f"{shown} is cut off"


def planned(top, earlier):
    """What each run is made of: fault, method, ranks, earlier results."""
    for kind in KINDS:
        ranks = 2 if kind in ("killed", "shared") else 1
        every = EVERY * (10 if kind == "killed" else 1)
        before = earlier if kind in ("disk", "removed") else None
        for method in METHODS:
            n = 1 if kind == "shared" else Run(
                top, f"{'signal' if kind == 'killed' else kind}:0", method).n
            if n == 0 and (kind, method) not in WITHOUT:
                sys.exit(f"{kind}, {method}: nothing is caught, so nothing is tried")
            for k in range(1, n + 1):
                if k % every == 1 % every or kind in ("disk", "nan") and k < 10:
                    yield f"{kind}:{k}", method, ranks, before


def tried(top, one, unharmed):
    """Status of a run, or none if it hangs, and what is not as it should be."""
    try:
        run = Run(top, *one)
    except subprocess.TimeoutExpired:
        return None, [f"{one[:3]}: it hangs"]
    problems = [f"{run.name}: {problem}" for problem in run.check(unharmed[one[1]])]
    if problems:
        problems.append(f"  status {run.status}, stderr: {run.stderr[-400:]!r}, "
                        f"stdout: {run.stdout[-300:]!r}")
    return run.status, problems


def main():
    """Count, run, report."""
    bad, tally = 0, collections.Counter()
    with tempfile.TemporaryDirectory() as top:
        earlier = os.path.join(top, "earlier")
        subprocess.run([PROGRAM, BRICK, "--output", earlier],
                       check=True, stdout=subprocess.DEVNULL)
        unharmed = {method: Run(top, "none:0", method) for method in METHODS}
        for run in unharmed.values():
            assert run.status == 0, run.stdout
        plan = list(planned(top, earlier))
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            ends = pool.map(lambda one: tried(top, one, unharmed), plan)
            for one, (status, problems) in zip(plan, ends):
                tally[one[0].partition(":")[0], status] += 1
                if problems:
                    bad += 1
                    print("\n".join(problems))
    for kind in KINDS:
        if kind not in ("shared", "memory") and all(
                status == 0 for other, status in tally if other == kind):
            bad += 1
            print(f"{kind}: no run noticed anything")
    print(f"{len(plan)} faults, {bad} badly met; statuses: " + ", ".join(
        f"{kind} {status}: {n}" for (kind, status), n in tally.items()))
    return bad > 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("program")
    parser.add_argument("library")
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--only", default="disk,removed,nan,solve,memory,signal,killed,"
                                          "shared")
    arguments = parser.parse_args()
    PROGRAM = os.path.abspath(arguments.program)
    LIBRARY = os.path.abspath(arguments.library)
    EVERY, KINDS = arguments.every, arguments.only.split(",")
    sys.exit(main())
