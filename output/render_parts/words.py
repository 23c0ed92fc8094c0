"""Numbers and units as they are written."""

import math

ROUNDING = 1e-6  # parts of what is largest that tolerances leave open


def exponent_of(largest):
    """The power of ten in steps of three that numbers are written with."""
    if not largest > 0 or 1e-2 <= largest < 1e4:
        return 0
    return 3 * math.floor(math.log10(largest) / 3)


def label(words, unit, exponent=0):
    """What an axis shows and in which unit, if that is known."""
    factor = f"$10^{{{exponent}}}$" if exponent else ""
    unit = " ".join(word for word in (factor, unit) if word)
    return f"{words} [{unit}]" if unit else words


def units_of(summary):
    """The units of what a picture shows, empty where the summary names none."""
    said = summary.get("units", {})
    return {kind: said.get(kind, "")
            for kind in ("length", "force", "moment", "stress", "energy")}


def number(value):
    """A number as it stands at an axis."""
    return f"{value + 0.0:.4g}".replace("-", "\N{MINUS SIGN}")


def quantity(unit, *values):
    """Numbers, in brackets if there are several, with a unit if it is known."""
    largest = max(abs(value) for value in values)
    exponent = exponent_of(largest)
    if largest > 0:  # what is rounding beside the largest is zero
        digits = 3 - math.floor(math.log10(largest))
        values = [round(value, digits) for value in values]
    words = ", ".join(number(value / 10.0**exponent) for value in values)
    words = f"({words})" if len(values) > 1 else words
    words += f"$\\times10^{{{exponent}}}$" if exponent else ""
    return f"{words} {unit}".strip()


def plain(name):
    """A name of the user's, in which nothing is a formula."""
    return name.replace("$", r"\$")
