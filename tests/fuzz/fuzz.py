#!/usr/bin/python3
"""Give the program inputs that are almost right and see that it ends as it should.

Call:   tests/fuzz/fuzz.py PROGRAM FORK_SERVER [--count N] [--seed S] [--jobs J]
                           [--keep DIRECTORY]

Takes the shipped parameter files, meshes and surfaces and some that the script makes
itself, changes a few characters, numbers, lines or entries of one, and runs it on a
small mesh. A run has to end within its time with status 0, 1, 2 or 3; with 1 it has to
say one sentence, from "stiction: " to a full stop, and with 0 CERTIFIED or that the input
is valid. Inputs that break this are kept, with what was said. Exit status 1 if there are
any. The same seed makes the same inputs. FORK_SERVER is what tests/fuzz/fork_server.cc
compiles to; with it a hundred thousand inputs take hours, not days.
"""

import argparse
import collections
import concurrent.futures
import glob
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SECONDS = 60  # of the processor, for a run: meshes that take longer are refused by size
NUMBERS = ("0", "-1", "1", "1e-300", "1e300", "nan", "inf", "-0", "0.5", "1e-12", "3",
           "1e10", "-1e5", "2147483648", "99999999999999999999", "1/0", "0x10", "1,5")
WORDS = ("", "|", ";", ":", "free", "x", "t", "end", "subsection A", "set", "é", "\0",
         "'", '"', "\\", "#", "boundary : top", "sqrt(-1)", "if(x, 1", "$(id)", "../..",
         "coulomb", "tied", "file", "a" * 5000)
SMALL = {"Geometry/Global refinement": "0", "Geometry/Contact refinement": "0",
         "Time/Steps": "1", "Contact solver/Maximum iterations": "30",
         "Refinement/Adaptive steps": "0", "Geometry/Table 1 level": "1"}


def corpus():
    """Parameter files by their text, each with the directory of the files it names."""
    names = glob.glob(os.path.join(ROOT, "parameters", "**", "*.prm"), recursive=True)
    names += glob.glob(os.path.join(ROOT, "tests", "errors", "*.prm"))
    texts = []
    for name in sorted(names):
        texts.append((read(name), os.path.dirname(name)))
    for case in sorted(glob.glob(os.path.join(ROOT, "tests", "errors", "*.case"))):
        whole = read(case)
        if "\nprm alone:\n" in whole:
            texts.append((whole.partition("\nprm alone:\n")[2], os.path.dirname(case)))
    return texts


def read(name):
    """The text of a file, whatever is in it."""
    with open(name, encoding="utf-8", errors="replace") as file:
        return file.read()


def with_small_mesh(text):
    """The text with fewer cells, where it says how many."""
    for entry, value in SMALL.items():
        name = re.escape(entry.partition("/")[2])
        text = re.sub(rf"(set {name}\s*=).*", rf"\1 {value}", text)
    return re.sub(r"(set Subdivisions\s*=)\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)",
                  lambda found: found[1] + " " + ", ".join(
                      str(min(int(found[k]), 3)) for k in (2, 3, 4)), text)


def change(text, rng):
    """One change somewhere."""
    lines = text.splitlines()
    kind = rng.randrange(9)
    place = rng.randrange(len(lines)) if lines else 0
    numbers = list(re.finditer(r"-?\d+\.?\d*(?:e-?\d+)?", text))
    if kind in (0, 1, 2) and numbers:
        found = rng.choice(numbers)
        return text[:found.start()] + rng.choice(NUMBERS) + text[found.end():]
    if kind == 3 and lines:
        lines.insert(place, rng.choice(lines))
    elif kind == 4 and lines:
        del lines[place]
    elif kind == 5 and lines:
        key, _, _ = lines[place].partition("=")
        lines[place] = key + "= " + rng.choice(WORDS + NUMBERS)
    elif kind == 6 and lines:
        other = rng.choice(lines).partition("=")[2]
        key, _, _ = lines[place].partition("=")
        lines[place] = key + "=" + other
    elif kind == 7 and text:
        k = rng.randrange(len(text))
        return text[:k] + rng.choice(WORDS) + text[k + rng.randrange(4):]
    elif text:
        k = rng.randrange(len(text))
        return text[:k]
    return "\n".join(lines) + "\n"


def make_input(rng, texts, directory):
    """Writes an input into a directory; returns the arguments of the program."""
    text, home = rng.choice(texts)
    text = with_small_mesh(text)
    for name in re.findall(r"([\w/.]+\.(?:msh|inp|vtk|stl))", text):
        path = os.path.join(home, name)
        if os.path.exists(path) and os.path.getsize(path) < 300000:
            target = os.path.join(directory, name)
            os.makedirs(os.path.dirname(target), exist_ok=True)
            data = read(path)
            if rng.random() < 0.7:
                for _ in range(rng.randint(1, 3)):
                    data = change(data, rng)
            with open(target, "w", encoding="utf-8", errors="replace") as file:
                file.write(data)
    for _ in range(rng.choice((0, 1, 1, 1, 2, 3))):
        text = change(text, rng)
    arguments = ["input.prm", "--output", "out"]
    entries = re.findall(r"set ([^=\n]+?)\s*=", text)
    if entries and rng.random() < 0.3:
        section = rng.choice(re.findall(r"subsection (.*)", text) or ["Geometry"])
        arguments += ["--set", f"{section}/{rng.choice(entries)}="
                               f"{rng.choice(WORDS + NUMBERS)}".replace("\0", "")]
    if rng.random() < 0.3:
        arguments.append("--validate")
    with open(os.path.join(directory, "input.prm"), "w", encoding="utf-8",
              errors="replace") as file:
        file.write(text)
    return arguments


def wrong(status, told, said):
    """What is wrong with the way a run ended, by what it wrote; or nothing."""
    if status in (-signal.SIGXCPU, -signal.SIGALRM):
        return "no end"
    if status not in (0, 1, 2, 3):
        return f"status {status}"
    if status == 1:
        last = said.strip().splitlines()
        sentences = [line for line in last if line.startswith("stiction: ")]
        if len(sentences) != 1 and not said.startswith(("--", "The following")):
            return f"{len(sentences)} sentences"
        if len(said) > 3000:
            return "a very long sentence"
        if "exception" in said.lower() or "assert" in said.lower():
            return "an exception of somebody else's"
    elif said:
        return "something on the error output"
    if status == 0 and not ("CERTIFIED" in told or "The input is valid" in told):
        return "status 0 without CERTIFIED"
    if status == 0 and re.search(r"(?<![\w.])-?nan(?![\w.])", told):
        return "a certified NaN"
    return ""


def run_inputs(options, texts, numbers):
    """Runs the inputs with these numbers; returns how often each status was met."""
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1",
                   "OMPI_MCA_ess_singleton_isolated": "1", "OMPI_MCA_pml": "ob1",
                   "LD_PRELOAD": os.path.abspath(options.fork_server),
                   "LD_BIND_NOW": "1", "FORK_SERVER_SECONDS": str(SECONDS)}
    statuses = collections.Counter()
    # what Open MPI makes and removes there for each run, other programs are using
    sessions = tempfile.TemporaryDirectory()
    environment["OMPI_MCA_orte_tmpdir_base"] = sessions.name
    with sessions, subprocess.Popen([os.path.abspath(options.program)], env=environment,
                                    text=True, stdin=subprocess.PIPE,
                                    stdout=subprocess.PIPE) as server:
        for number in numbers:
            rng = random.Random(f"{options.seed} {number}")
            with tempfile.TemporaryDirectory() as directory:
                arguments = make_input(rng, texts, directory)
                server.stdin.write("\t".join([directory, *arguments]) + "\n")
                server.stdin.flush()
                status = int(server.stdout.readline())
                outputs = [os.path.join(directory, name) for name in ("stdout", "stderr")]
                told, said = (read(name) for name in outputs)
                reason = wrong(status, told, said)
                statuses["bad" if reason else status] += 1
                if reason:
                    kept = os.path.join(options.keep, f"{options.seed}_{number}")
                    shutil.rmtree(kept, ignore_errors=True)
                    shutil.copytree(directory, kept)
                    print(f"{reason}: {kept}, stiction {' '.join(arguments)!r}", flush=True)
        server.stdin.close()
    return statuses


def main():
    """Returns the exit status."""
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("fork_server")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--keep", default="fuzz")
    options = parser.parse_args()
    texts = corpus()
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        runs = [pool.submit(run_inputs, options, texts,
                            range(job, options.count, options.jobs))
                for job in range(options.jobs)]
        statuses = sum((run.result() for run in runs), collections.Counter())
    print(f"{options.count} inputs, {statuses['bad']} bad; status: "
          + ", ".join(f"{status}: {statuses[status]}" for status in range(4)))
    return 1 if statuses["bad"] else 0


if __name__ == "__main__":
    sys.exit(main())
