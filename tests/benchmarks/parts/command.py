"""What the benchmarks' command lines have in common."""

import argparse
import signal
import sys

from .errors import BenchmarkError


class Parser(argparse.ArgumentParser):
    """Says what is wrong in one sentence, as the program does."""

    def error(self, message):
        raise BenchmarkError(f"{message}, --help lists the options")


def number(low, high, kind=float):
    """A converter for numbers in [low, high]."""

    def convert(text):
        try:
            value = kind(text)
        except ValueError:
            value = None
        if value is None or not low <= value <= high:
            raise argparse.ArgumentTypeError(
                f"'{text}' is no number from {low:g} to {high:g}"
            )
        return value

    return convert


def numbers(low, high, kind=float):
    """A converter for lists of such numbers with commas, in their order."""
    convert = number(low, high, kind)

    def convert_all(text):
        return list(dict.fromkeys(convert(part) for part in text.split(",")))

    return convert_all


def clock(seconds):
    """Seconds as m:ss."""
    return f"{int(seconds) // 60}:{int(seconds) % 60:02}"


def interrupt(*_):
    """SIGTERM ends a benchmark the way Ctrl-C does."""
    raise KeyboardInterrupt


def exit_status(benchmark, arguments):
    """Runs benchmark(arguments); every end in a sentence and a status."""
    signal.signal(signal.SIGTERM, interrupt)
    try:
        benchmark(arguments)
        return 0
    except BenchmarkError as error:
        print(f"benchmark: {error}.", file=sys.stderr)
    except OSError as error:
        where = f"{error.filename}: " if error.filename else ""
        print(f"benchmark: {where}{error.strerror}.", file=sys.stderr)
    except KeyboardInterrupt:
        print("\nStopped. The finished runs are stored, call again to go on.")
        return 130
    return 1
