"""What memory gives one process, and what it gives several at once.

STREAM's kernel 'add'. As a program, 'stream.py MEGABYTES SECONDS CORE' makes
three such arrays, prints 'ready', waits for a line and prints the bytes a second
of a = b + c. It needs numpy.
"""

import os
import statistics
import subprocess
import sys
import time

REPETITIONS = 3


def kernel(megabytes, seconds, core):
    """The program."""
    import numpy  # pylint: disable=import-outside-toplevel

    os.sched_setaffinity(0, {core})
    size = int(megabytes * 2**20 / 8)
    a, b, c = (numpy.full(size, value) for value in (0.0, 1.0, 2.0))

    def sweep():
        numpy.add(b, c, out=a)

    sweep()
    print("ready", flush=True)
    sys.stdin.readline()
    done = 0
    start = time.perf_counter()
    while time.perf_counter() - start < seconds:
        sweep()
        done += 1
    gone = time.perf_counter() - start
    print(done * 3 * 8 * size / gone, flush=True)


def bandwidths(processes, megabytes, seconds):
    """Bytes a second of processes that run at once; None without numpy."""
    cores = sorted(os.sched_getaffinity(0))
    children = [
        subprocess.Popen(
            [
                sys.executable,
                "-B",
                os.path.abspath(__file__),
                str(megabytes),
                str(seconds),
                str(cores[index % len(cores)]),
            ],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )
        for index in range(processes)
    ]
    try:
        ready = [child.stdout.readline().strip() == "ready" for child in children]
        if not all(ready):
            return None
        for child in children:
            child.stdin.write("go\n")
            child.stdin.flush()
        return [float(child.stdout.readline()) for child in children]
    except (OSError, ValueError):
        return None
    finally:
        for child in children:
            child.kill()
            child.wait()
            child.stdin.close()
            child.stdout.close()


def measure(processes=2, megabytes=256, seconds=2.0):
    """The medians of bytes a second alone and of all at once; None if not."""
    alone, together = [], []
    for _ in range(REPETITIONS):  # take turns: others may use the machine
        one = bandwidths(1, megabytes, seconds)
        all_of_them = bandwidths(processes, megabytes, seconds)
        if one is None or all_of_them is None:
            return None
        alone += one
        together.append(sum(all_of_them))
    return {
        "processes": processes,
        "megabytes": megabytes,
        "alone": statistics.median(alone),
        "together": statistics.median(together),
    }


if __name__ == "__main__":
    kernel(float(sys.argv[1]), float(sys.argv[2]), int(sys.argv[3]))
