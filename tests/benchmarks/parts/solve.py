"""One run of the program on a parameter file, for the sake of its summary."""

import json
import os
import subprocess
import tempfile

from .errors import BenchmarkError

ROOT = os.path.dirname(
    os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
)


def add_program(parser):
    """The option of another build of the program."""
    parser.add_argument(
        "--program",
        default=os.path.join(ROOT, "build", "stiction"),
        help="another build of the program (build/stiction)",
    )


def solve(program, name, settings):
    """The summary of a run that has to be certified."""
    with tempfile.TemporaryDirectory() as directory:
        command = [program, os.path.join(ROOT, "parameters", name)]
        for entry, value in {**settings, "Output/Directory": directory}.items():
            command += ["--set", f"{entry}={value}"]
        environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
        try:
            run = subprocess.run(
                command, capture_output=True, text=True, check=False, env=environment
            )
        except OSError as error:
            raise BenchmarkError(f"cannot run '{program}': {error.strerror}") from error
        if run.returncode != 0:
            raise BenchmarkError(
                f"'{name}' ended with status {run.returncode}: "
                + (run.stderr.strip() or run.stdout.strip()).splitlines()[-1]
            )
        with open(os.path.join(directory, "summary.json"), encoding="utf-8") as file:
            return json.load(file)
