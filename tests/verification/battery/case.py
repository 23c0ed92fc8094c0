"""What a case is made of: rows with a reference each, curves, and its problems."""

import math
import os
import sys
from dataclasses import dataclass, field

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__)))))
sys.path.insert(0, os.path.join(ROOT, "output"))
import stiction  # pylint: disable=wrong-import-position


@dataclass
class Row:
    """A quantity beside its reference.

    kind: "relative" deviations are parts of the reference, "absolute" ones differences;
    both have to be at most what is allowed. "at least": the deviation has to be that
    large, as where friction must change something. "order": the reference less what is
    allowed has to be reached. "same": words that have to agree.
    """

    quantity: str
    computed: object
    reference: object
    source: str
    allowed: float = 0.0
    kind: str = "relative"

    @property
    def deviation(self):
        """By how much it is off."""
        if self.kind == "same":
            return 0.0 if self.computed == self.reference else math.inf
        if self.kind == "order":
            return 0.0 if self.computed >= self.reference else (
                self.reference - self.computed)
        difference = abs(self.computed - self.reference)
        return difference if self.is_difference else difference / abs(self.reference)

    @property
    def is_difference(self):
        """Whether the deviation is a difference, not a part of the reference."""
        return self.kind == "absolute" or (self.kind == "at least" and self.reference == 0)

    @property
    def passed(self):
        """Whether that is as it has to be; a NaN never is."""
        if self.kind == "at least":
            return self.deviation >= self.allowed
        return self.deviation <= self.allowed


@dataclass
class Curve:
    """Points of a plot, joined or not."""

    label: str
    x: object
    y: object
    style: str = "-"


@dataclass
class Plot:
    """One picture of a case."""

    title: str
    x: str
    y: str
    curves: list = field(default_factory=list)
    logarithmic: bool = False


class Solver:
    """Solves problems for a case; what is not certified is a row that fails."""

    def __init__(self, program, progress):
        self.program, self.progress = program, progress
        self.rows = []

    def shipped(self, name, settings=None):
        """A shipped parameter file with other settings."""
        return self(os.path.join(ROOT, "parameters", name), settings)

    def __call__(self, problem, settings=None, ranks=1):
        settings = {"Output/Print progress": "false", **(settings or {})}
        run = stiction.run(problem, settings, ranks=ranks, program=self.program)
        self.progress()
        if not run.certified:
            self.rows.append(Row("a run", "not certified", "certified", run.message,
                                 kind="same"))
        return run

    def end_of(self, problem, settings=None):
        """How a run ends in a word: "certified", "not certified" or "refused"."""
        try:
            run = stiction.run(problem, settings, program=self.program)
        except stiction.Error as error:
            self.progress()
            return "refused" if "no equilibrium exists" in str(error) else str(error)
        self.progress()
        return "certified" if run.certified else "not certified"


def sections(**entries):
    """The text of a parameter file: Section={'Entry': value}, '_' for a blank."""
    return "".join(section(name.replace("_", " "), values)
                   for name, values in entries.items())


def section(name, entries):
    """One section of a parameter file."""
    lines = "".join(f"  set {entry} = {value}\n" for entry, value in entries.items())
    return f"subsection {name}\n{lines}end\n"


def order(errors):
    """The observed order of convergence: the mean over all halvings of the cells."""
    return math.log2(abs(errors[0]) / abs(errors[-1])) / (len(errors) - 1)
