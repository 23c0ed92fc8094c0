"""What the figures were measured on, from what Linux tells."""

import os
import platform
import re
import subprocess
import time


def _first_match(path, pattern, default="unknown"):
    try:
        with open(path, encoding="utf-8") as file:
            found = re.search(pattern, file.read(), re.MULTILINE)
    except OSError:
        found = None
    return found.group(1).strip() if found else default


def _blas(program):
    """The BLAS behind libblas.so, which alternatives decide on Debian."""
    try:
        listing = subprocess.run(
            ["ldd", program], capture_output=True, text=True, check=False
        ).stdout
    except OSError:
        return "unknown"
    found = re.search(r"libblas\.so\S* => (\S+)", listing) or re.search(
        r"lib\w*blas\w*\.so\S* => (\S+)", listing
    )
    if not found:
        return "unknown"
    folder, name = os.path.split(os.path.realpath(found.group(1)))
    return f"{os.path.basename(folder)}/{name}"


def describe(program):
    """Words for the machine and the BLAS that the program is linked with."""
    kilobytes = _first_match("/proc/meminfo", r"^MemTotal:\s*(\d+)", "0")
    return {
        "CPU": _first_match("/proc/cpuinfo", r"^model name\s*:\s*(.*)$"),
        "cores": os.cpu_count(),
        "memory": f"{int(kilobytes) / 2**20:.1f} GiB",
        "operating system": _first_match(
            "/etc/os-release", r'^PRETTY_NAME="?([^"\n]*)'
        )
        + f", Linux {platform.release()}",
        "BLAS": _blas(program),
    }


def others(samples=20, seconds=0.2):
    """How many other processes are running, the mean over a short time.

    None where Linux does not tell.
    """
    total = 0
    for _ in range(samples):
        running = _first_match("/proc/loadavg", r"(\d+)/\d+", "")
        if not running:
            return None
        total += int(running) - 1  # without this one
        time.sleep(seconds / samples)
    return total / samples
