#!/usr/bin/python3
"""Give the program inputs that are almost right and see that it ends as it should.

Call:   tests/fuzz/fuzz.py PROGRAM [--count N] [--seed S] [--keep DIRECTORY]

Takes the shipped parameter files, meshes and surfaces and some that the script makes
itself, changes a few characters, numbers, lines or entries of one, and runs it on a
small mesh. A run has to end within its time with status 0, 1, 2 or 3; with 1 it has to
say one sentence, from "stiction: " to a full stop, and with 0 CERTIFIED or that the input
is valid. Inputs that break this are kept, with what was said. Exit status 1 if there are
any. The same seed makes the same inputs.
"""

import argparse
import glob
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SECONDS = 60  # of a run: the largest meshes that a change makes are refused by their size
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
        with open(name, encoding="utf-8") as file:
            texts.append((file.read(), os.path.dirname(name)))
    for case in sorted(glob.glob(os.path.join(ROOT, "tests", "errors", "*.case"))):
        with open(case, encoding="utf-8", errors="replace") as file:
            whole = file.read()
        if "\nprm alone:\n" in whole:
            texts.append((whole.partition("\nprm alone:\n")[2], os.path.dirname(case)))
    return texts


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
            with open(path, encoding="utf-8", errors="replace") as file:
                data = file.read()
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


def wrong(end):
    """What is wrong with the way a run ended, or nothing."""
    said = end.stderr.decode(errors="replace")
    told = end.stdout.decode(errors="replace")
    if end.returncode not in (0, 1, 2, 3):
        return f"status {end.returncode}"
    if end.returncode == 1:
        last = said.strip().splitlines()
        sentences = [line for line in last if line.startswith("stiction: ")]
        if len(sentences) != 1 and not said.startswith(("--", "The following")):
            return f"{len(sentences)} sentences"
        if len(said) > 3000:
            return "a very long sentence"
        if "exception" in said.lower() or "assert" in said.lower():
            return "an exception of somebody else's"
    if end.returncode == 0 and not ("CERTIFIED" in told or "The input is valid" in told):
        return "status 0 without CERTIFIED"
    if end.returncode == 0 and re.search(r"(?<![\w.])-?nan(?![\w.])", told):
        return "a certified NaN"
    return ""


def main():
    """Returns the exit status."""
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", default="fuzz")
    options = parser.parse_args()
    program, texts, bad, statuses = os.path.abspath(options.program), corpus(), 0, {}
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1",
                   "OMPI_MCA_ess_singleton_isolated": "1", "OMPI_MCA_pml": "ob1"}
    for number in range(options.count):
        rng = random.Random(f"{options.seed} {number}")
        with tempfile.TemporaryDirectory() as directory:
            arguments = make_input(rng, texts, directory)
            try:
                end = subprocess.run([program, *arguments], cwd=directory,
                                     stdin=subprocess.DEVNULL, capture_output=True,
                                     env=environment, timeout=SECONDS, check=False)
                reason, said = wrong(end), end.stderr + end.stdout[-2000:]
                statuses[end.returncode] = statuses.get(end.returncode, 0) + 1
            except subprocess.TimeoutExpired as over:
                reason, said = "no end", (over.stdout or b"")[-2000:]
            if reason:
                bad += 1
                kept = os.path.join(options.keep, f"{options.seed}_{number}")
                shutil.rmtree(kept, ignore_errors=True)
                shutil.copytree(directory, kept)
                with open(os.path.join(kept, "said"), "wb") as file:
                    file.write(said)
                print(f"{reason}: {kept}, stiction {' '.join(arguments)!r}", flush=True)
    print(f"{options.count} inputs, {bad} bad; status: "
          + ", ".join(f"{status}: {n}" for status, n in sorted(statuses.items())))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
