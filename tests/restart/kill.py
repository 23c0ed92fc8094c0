#!/usr/bin/env python3
"""Kills a run with checkpoints at random moments and has it go on each time:

    kill.py STICTION FILE.prm KILLS [SEED]

A restart must always work, lose no more than a step, and end with the same digits as
a run that nobody killed.
"""

import os
import random
import re
import subprocess
import sys
import tempfile
import time

STEPS = 12
SETTINGS = (
    "Geometry/Table 1 level=3",
    f"Time/Steps={STEPS}",
    "Time/Checkpoint every=1",
    "Boundary conditions/Traction=5 : 0; 0; -1e8 | 3 : 1e8*sin(5*t); 0; 0",
    "Contact solver/Method=newton",
    "Output/Write solution=false",
    "Output/Double precision=true",
)


def command(directory, restart):
    """The run, from its start or from a checkpoint."""
    line = [STICTION, FILE, "--output", directory]
    for setting in SETTINGS:
        line += ["--set", setting]
    return line + (["--restart", directory] if restart else [])


def start(directory, restart):
    """The run, on its way."""
    return subprocess.Popen(
        command(directory, restart),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )


def has_checkpoint(directory):
    """Whether there is one to go on from."""
    names = ("checkpoint", "checkpoint.old")
    return any(os.path.isdir(os.path.join(directory, name)) for name in names)


def content(directory):
    """All digits of the contact nodes at the end."""
    name = os.path.join(directory, f"contact_{STEPS:04d}.csv")
    with open(name, encoding="ascii") as file:
        return file.read()


def main():
    """Kill, go on, compare."""
    with tempfile.TemporaryDirectory() as top:
        straight, killed = os.path.join(top, "straight"), os.path.join(top, "killed")
        began = time.monotonic()
        run = start(straight, False)
        run.communicate()
        seconds = time.monotonic() - began
        if run.returncode != 0:
            sys.exit(f"the run itself ends with status {run.returncode}")

        reached = 0  # steps that are certainly on disk
        for k in range(KILLS + 1):
            restart = has_checkpoint(killed)
            if reached > 1 and not restart:
                sys.exit("there is no checkpoint after a step")
            run = start(killed, restart)
            if k < KILLS:
                time.sleep(random.uniform(0.0, 0.5 * seconds))
                run.kill()
            said = run.communicate()[0]
            if run.returncode not in (0, -9):
                if "must go on after" in said:
                    break  # it was killed after its last step
                sys.exit(f"status {run.returncode} after {k} kills:\n{said}")
            for text in re.findall(r"Going on after step (\d+)", said):
                if int(text) < reached - 1:
                    sys.exit(f"step {text} is gone on from, but {reached} was reached")
            steps = [int(text) for text in re.findall(r"^Step (\d+):", said, re.M)]
            reached = max([reached] + [step - 1 for step in steps])
            if run.returncode == 0:
                break
        if content(straight) != content(killed):
            sys.exit("the digits are not those of a run that was not killed")
        print(f"killed {k} times, the same digits at the end")


if __name__ == "__main__":
    STICTION, FILE, KILLS = sys.argv[1], sys.argv[2], int(sys.argv[3])
    random.seed(int(sys.argv[4]) if len(sys.argv) > 4 else None)
    main()
