"""Running the program once and measuring it; keeping what was measured."""

import contextlib
import datetime
import hashlib
import json
import os
import shutil
import signal
import subprocess
import tempfile
import threading
import time

from .errors import BenchmarkError
from .figures import parse_history

CERTIFIED = "certified"
NOT_CERTIFIED = "not certified"
LIMIT = "time limit"
ERROR = "error"
CRASHED = "crashed"

# Seconds between asking a program to end and ending it.
PATIENCE = 5.0


class Program:
    """The program under test: which one it is, and whether it changed."""

    def __init__(self, path):
        self.path = os.path.abspath(path)
        if not os.access(self.path, os.X_OK):
            raise BenchmarkError(
                f"there is no program '{path}', './run build' makes it"
            )
        self._stamp = self._look()
        with open(self.path, "rb") as file:
            # Two builds of one version differ: the bytes tell them apart.
            self.hash = hashlib.sha256(file.read()).hexdigest()[:16]
        said = subprocess.run(
            [self.path, "--version"], capture_output=True, text=True, check=False
        )
        self.version = (said.stdout.split("\n")[0] or "unknown").strip()
        self.identity = f"{self.version} {self.hash}"

    def _look(self):
        status = os.stat(self.path)
        return (status.st_mtime_ns, status.st_size)

    def check_unchanged(self):
        """Figures of two programs must not meet in one table."""
        if not os.path.exists(self.path) or self._look() != self._stamp:
            raise BenchmarkError(
                "the program was rebuilt while the benchmark ran, call it again"
            )


def run_key(settings, parameters, threads, identity):
    """Short hash of all that decides on the figures of a run.

    settings: list of 'Section/Entry=value'; parameters: text of the parameter
    file; identity: of the program.
    """
    everything = json.dumps([sorted(settings), parameters, threads, identity])
    return hashlib.sha256(everything.encode()).hexdigest()[:16]


class Store:
    """The finished runs, a JSON file each."""

    def __init__(self, directory):
        self.directory = os.path.join(directory, "runs")

    def clear(self):
        """Forgets all runs."""
        shutil.rmtree(self.directory, ignore_errors=True)

    def load(self):
        """All stored runs by key. Files cut short count as not stored."""
        rows = {}
        names = os.listdir(self.directory) if os.path.isdir(self.directory) else []
        for name in sorted(names):
            if not name.endswith(".json"):
                continue
            try:
                with open(os.path.join(self.directory, name), encoding="utf-8") as file:
                    row = json.load(file)
                rows[row["key"]] = row
            except (ValueError, KeyError, TypeError):
                print(f"{name} cannot be read, its run counts as not done")
        return rows

    def save(self, label, row):
        """Writes a run; never half of it, whenever we are stopped."""
        os.makedirs(self.directory, exist_ok=True)
        path = os.path.join(self.directory, f"{label}-{row['key']}.json")
        with open(path + ".part", "w", encoding="utf-8") as file:
            json.dump(row, file)
        os.replace(path + ".part", path)


def is_finished(row, limit):
    """Whether a stored run need not be repeated.

    Errors are cheap to meet again and may have been put right; a run that was
    cut short is repeated only if it may take longer now.
    """
    if row is None or row["status"] in (ERROR, CRASHED):
        return False
    return row["status"] != LIMIT or row["limit"] >= limit


def _measure(command, environment, output, errors, limit):
    """Runs a command; returns (exit status, timed out, wall, rusage)."""
    start = time.perf_counter()
    # A session of its own: Ctrl-C reaches us first and we end the program.
    # It is reaped by os.wait4 below, which tells its own times and memory.
    child = subprocess.Popen(  # pylint: disable=consider-using-with
        command,
        env=environment,
        stdin=subprocess.DEVNULL,
        stdout=output,
        stderr=errors,
        start_new_session=True,
    )
    timed_out = threading.Event()

    def kill(how=signal.SIGKILL):
        with contextlib.suppress(ProcessLookupError):  # it has just ended
            os.killpg(child.pid, how)

    # mpirun ends its ranks when it is asked to end; killed at once it may
    # leave them behind.
    last_resort = threading.Timer(PATIENCE, kill)

    def end():
        with contextlib.suppress(RuntimeError):  # it ticks already
            last_resort.start()
        kill(signal.SIGTERM)

    def stop():
        timed_out.set()
        end()

    timer = threading.Timer(limit, stop)
    timer.start()
    try:
        _, status, usage = os.wait4(child.pid, 0)
    except BaseException:
        end()
        with contextlib.suppress(ChildProcessError):
            os.wait4(child.pid, 0)
        raise
    finally:
        for waiting in (timer, last_resort):
            waiting.cancel()
            if waiting.is_alive():
                waiting.join()
    wall = time.perf_counter() - start
    child.returncode = os.waitstatus_to_exitcode(status)
    return child.returncode, timed_out.is_set(), wall, usage


def _read(path):
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            return file.read()
    except OSError:
        return ""


def _read_json(path):
    try:
        return json.loads(_read(path))
    except ValueError:
        return None


def _last_word(status, said, complained):
    """The sentence in which the program explains its exit status."""
    if status == NOT_CERTIFIED:
        lines = [line for line in said.splitlines() if line.startswith("NOT ")]
    else:
        # mpirun has words of its own after the program's, and rules around them
        lines = [line for line in complained.splitlines() if line.strip("- ")]
        lines = [line for line in lines if line.startswith("stiction: ")] or lines
    return lines[-1].removeprefix("stiction: ") if lines else ""


def on_ranks(ranks, command):
    """The command that runs this one on several MPI ranks."""
    if ranks == 1:
        return command
    return ["mpirun", "--oversubscribe", "-n", str(ranks), *command]


def execute(command, threads, limit, folder):
    """Runs a command; returns what was measured as a dict, and what it said.

    folder: an existing directory for files that it leaves there.
    """
    with tempfile.TemporaryDirectory() as session:
        environment = dict(
            os.environ,
            OMP_NUM_THREADS=str(threads),
            OPENBLAS_NUM_THREADS=str(threads),
            # Open MPI leaves its files there when it is killed; the names of
            # its sockets must be short, so not below the results.
            TMPDIR=session,
        )
        said = os.path.join(folder, "said")
        complained = os.path.join(folder, "complained")
        with open(said, "wb") as output, open(complained, "wb") as errors:
            exit_status, timed_out, wall, usage = _measure(
                command, environment, output, errors, limit
            )
    if timed_out:
        status = LIMIT
    else:
        status = {0: CERTIFIED, 1: ERROR, 2: NOT_CERTIFIED}.get(exit_status, CRASHED)
    message = _last_word(status, _read(said), _read(complained))
    if status == CRASHED and not message:
        message = f"ended with exit status {exit_status}"
    return {
        "status": status,
        "exit_status": exit_status,
        "message": "" if status == LIMIT else message,
        "threads": threads,
        "limit": limit,
        "date": datetime.datetime.now().isoformat(" ", "minutes"),
        "wall": wall,
        "cpu": usage.ru_utime + usage.ru_stime,
        "memory_MB": usage.ru_maxrss / 1024,  # Linux counts in KiB
    }, _read(said)


def scratch_folder(directory):
    """A directory below this one for the files of a run, for a with block."""
    os.makedirs(directory, exist_ok=True)
    return tempfile.TemporaryDirectory(prefix="running-", dir=directory)


def run_case(program, root, case, tolerance, threads, limit, scratch, ranks=1):
    """Runs the program on a case and returns what was measured, as a dict.

    All files of the run are removed; the dict has summary.json and the
    residuals of convergence.csv in it. Time and memory beside them are those
    of mpirun if there are several ranks.
    """
    settings = case.settings(tolerance)
    with scratch_folder(scratch) as folder:
        results = os.path.join(folder, "results")
        command = [program.path, os.path.join(root, case.parameter_file)]
        for setting in settings:
            command += ["--set", setting]
        command += ["--output", results]
        row, _ = execute(on_ranks(ranks, command), threads, limit, folder)
        solved = row["status"] in (CERTIFIED, NOT_CERTIFIED)
        return {
            **row,
            "settings": settings,
            "tolerance": tolerance,
            "summary": _read_json(os.path.join(results, "summary.json"))
            if solved
            else None,
            "history": parse_history(_read(os.path.join(results, "convergence.csv"))),
        }
