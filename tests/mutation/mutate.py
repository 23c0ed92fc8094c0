#!/usr/bin/env python3
"""Change the program in one place and see whether a test notices.

Call:   tests/mutation/mutate.py DIRECTORY [--count N] [--seed S] [--folders A,B]
                                 [--slowest SECONDS]

Clones the project to DIRECTORY (or goes on with the clone there), builds its library, and
then makes N changes of a character or two in qp/, the certificate and the contact
conditions, one at a time: < for <=, + for -, max for min, && for ||. Each is compiled, and
the unit and physics tests that `./run tests` built run with that library, the quickest
first, until one has another output, fails or hangs. Writes DIRECTORY/mutants.csv and says
how many were caught; those that were not are to be looked at: a test is missing, a line is
superfluous, or the change changes nothing.
"""

import argparse
import csv
import os
import random
import re
import resource
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# as the test suite has it
os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1",
                  OMPI_MCA_ess_singleton_isolated="1", OMPI_ALLOW_RUN_AS_ROOT="1",
                  OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
CHANGES = {" < ": " <= ", " <= ": " < ", " > ": " >= ", " >= ": " > ", " == ": " != ",
           " != ": " == ", " + ": " - ", " - ": " + ", " * ": " / ", " / ": " * ",
           " && ": " || ", " || ": " && ", " += ": " -= ", " -= ": " += ",
           "std::max(": "std::min(", "std::min(": "std::max(", "true": "false",
           "false": "true", " = -": " = ", "return -": "return ", "cwiseMax": "cwiseMin",
           "cwiseMin": "cwiseMax", "0.5 *": "2. *", "continue;": "break;"}
SLOWEST = 5.  # seconds of the processor that a test may take, unless --slowest says more


def places(root, folders):
    """Every change that can be made: file, line, column, from, to."""
    found = []
    for folder in folders:
        for directory, _, names in os.walk(os.path.join(root, "source", folder)):
            for name in sorted(names):
                path = os.path.relpath(os.path.join(directory, name), root)
                with open(os.path.join(root, path), encoding="utf-8") as file:
                    lines = file.read().split("\n")
                for number, line in enumerate(lines):
                    code = re.sub(r'"[^"]*"', lambda text: "~" * len(text[0]),
                                  line.partition("//")[0])
                    if code.startswith("#") or "throw " in code or "assert" in code:
                        continue
                    for old, new in CHANGES.items():
                        found += [(path, number, at.start(), old, new)
                                  for at in re.finditer(re.escape(old), code)]
    return sorted(found)


class Clone:
    """The project once more, to be changed."""

    def __init__(self, directory, slowest):
        self.directory = os.path.abspath(directory)
        self.build = os.path.join(self.directory, "build")
        if not os.path.isdir(self.directory):
            run(["git", "clone", "-q", ROOT, self.directory])
            run(["cmake", "-S", self.directory, "-B", self.build, "-G", "Ninja",
                 "-DSTICTION_UNITY_BUILD=OFF", "-DCMAKE_BUILD_TYPE=Release"])
        run(["git", "-C", self.directory, "checkout", "--", "source"])
        run(["ninja", "-C", self.build, "stiction_shared"])
        os.environ["LD_LIBRARY_PATH"] = os.path.join(self.build, "tests")
        self.tests = sorted(self.measured(slowest))

    def measured(self, slowest):
        """Seconds, program and reference of each test that is quick enough."""
        tests = os.path.join(ROOT, "tests")
        for kind in ("unit", "physics"):
            for folder, _, names in os.walk(os.path.join(tests, kind)):
                for name in sorted(names):
                    if not name.endswith(".cc"):
                        continue
                    stem = name[:-len(".cc")]
                    place = os.path.join(ROOT, "build", "tests",
                                         os.path.relpath(folder, tests),
                                         f"{stem}.release")
                    test = (os.path.join(place, f"{stem}.release"),
                            os.path.join(folder, f"{stem}.output"))
                    begin = seconds_of_children()
                    if all(map(os.path.exists, test)) and passes(test, slowest):
                        yield (seconds_of_children() - begin, *test)

    def outcome(self, change):
        """caught by TEST, survived, or does not compile."""
        path, number, column, old, new = change
        file_name = os.path.join(self.directory, path)
        with open(file_name, encoding="utf-8") as file:
            text = file.read()
        lines = text.split("\n")
        line = lines[number]
        lines[number] = line[:column] + new + line[column + len(old):]
        try:
            with open(file_name, "w", encoding="utf-8") as file:
                file.write("\n".join(lines))
            if subprocess.run(["ninja", "-C", self.build, "stiction_shared"],
                              capture_output=True, check=False).returncode:
                return "does not compile"
            for seconds, *test in self.tests:
                if not passes(test, 5. * seconds + 10.):
                    return "caught by " + os.path.basename(test[0])
            return "survived"
        finally:
            with open(file_name, "w", encoding="utf-8") as file:
                file.write(text)


def seconds_of_children():
    """Of the processor, since others may use it, too."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def passes(test, seconds):
    """Whether a test has the output of its reference, in so many seconds of the processor."""
    program, reference = test
    directory = os.path.dirname(program)
    output = os.path.join(directory, "output_of_mutant")
    limit = int(seconds) + 1
    try:
        with open(output, "wb") as file:
            done = subprocess.run(
                [program], cwd=directory, stdout=file, stderr=subprocess.STDOUT,
                timeout=20. * limit, check=False, preexec_fn=lambda: resource.setrlimit(
                    resource.RLIMIT_CPU, (limit, limit)))
    except subprocess.TimeoutExpired:
        return False
    return done.returncode == 0 and subprocess.run(
        ["numdiff", "-a", "1e-6", "-r", "1e-8", "-q", reference, output],
        capture_output=True, check=False).returncode == 0


def run(command):
    """Without its output, unless it fails."""
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"{' '.join(command)}:\n{done.stdout}{done.stderr}")


def main():
    """Change, build, test, count."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("directory")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--folders", default="qp,contact/certificate")
    parser.add_argument("--slowest", type=float, default=SLOWEST,
                        help="seconds that a test may take to be run (%(default)s)")
    arguments = parser.parse_args()
    clone = Clone(arguments.directory, arguments.slowest)
    all_changes = places(clone.directory, arguments.folders.split(","))
    if not all_changes or not clone.tests:
        sys.exit(f"{clone.directory} has no place to change, or no test that passes")
    print(f"{len(all_changes)} possible changes, {len(clone.tests)} tests", flush=True)
    tally = {"caught": 0, "survived": 0, "does": 0}
    with open(os.path.join(clone.directory, "mutants.csv"), "a", newline="",
              encoding="utf-8") as file:
        rows = csv.writer(file)
        rows.writerow(("file", "line", "from", "to", "outcome"))
        for change in random.Random(arguments.seed).sample(
                all_changes, min(arguments.count, len(all_changes))):
            outcome = clone.outcome(change)
            tally[outcome.partition(" ")[0]] += 1
            path, number, _, old, new = change
            rows.writerow((path, number + 1, old.strip(), new.strip(), outcome))
            file.flush()
            print(f"{path}:{number + 1}: {old.strip()} -> {new.strip()}: {outcome}",
                  flush=True)
    n = tally["caught"] + tally["survived"]
    print(f"{tally['caught']} of {n} caught")


if __name__ == "__main__":
    main()
