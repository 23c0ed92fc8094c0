"""The curves of a history: forces, and what friction dissipates."""

import csv
import math
import os

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from . import Unusable
from .page import NORMAL, SMALL, TEXT
from .words import ROUNDING, exponent_of, label, number, plain

AXES = "xyz"
COLORS = ("#3F8FC6", "#6FBFA5", "#B00020")  # of the components, or of boundaries
LINES = ("-", "--", ":", "-.")  # of the contact boundaries
MARKERS = (".", "s", "^", "x", "v", "D")  # and where lines begin anew
SINGLE = {"normal_force": ("normal force", "force"),  # words, kind of unit
          "torque": ("torque on the body", "moment"),
          "dissipated_total": ("dissipated by friction", "energy")}
WORDS = ("boundary", "pair", "opposite")  # columns that are no numbers
MUCH = 2e-2  # of what presses times the width that it has
SMALL_PART = 2e-2  # of the largest value: curves below it are not drawn ...
MANY = 8  # ... where there are more than these
HARDLY = 1e-2  # parts of the largest displacement over which no curve is drawn
WIDTH, HEIGHT = 6.0, 3.8  # of one diagram, in inches


def read(directory):
    """The rows of history.csv by contact boundaries, columns as arrays. Boundaries are
    called as their sections 'Contact pair NAME', if they have such.

    None where the run had one step. What a last line lacks that was being
    written when the run was killed is left out with the line.
    """
    file = os.path.join(directory, "history.csv")
    if not os.path.isfile(file):
        return None
    boundaries = {}
    try:
        with open(file, encoding="utf-8", newline="") as stream:
            for row in csv.DictReader(stream):
                if row["dissipated_total"]:
                    boundaries.setdefault((row["boundary"], row.get("pair")),
                                          []).append(row)
        names = [pair or boundary for boundary, pair in boundaries]
        names = [name if names.count(name) == 1 else ", ".join(filter(None, both[::-1]))
                 for name, both in zip(names, boundaries)]
        return {name: {column: np.array([float(row[column] or "nan")
                                         for row in rows])
                       for column in rows[0] if column not in WORDS}
                for name, rows in zip(names, boundaries.values())}
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise Unusable(f"{file} cannot be read: {error}.") from error


def moved(rows):
    """The directions in which an obstacle moved during the history."""
    places = np.array([rows["obstacle_" + axis] for axis in AXES])
    ways = np.ptp(places, axis=1)
    return [c for c in range(3) if ways[c] > HARDLY * np.abs(places).max()]


def force_or_moment(boundaries):
    """What a history shows: moments where all forces add up to rounding, and how
    hard bodies are pressed together where moments do as well."""
    def largest(*columns):
        return max(np.abs(rows[column]).max()
                   for rows in boundaries.values() for column in columns)

    pressing = largest("normal_force")
    length = np.sqrt(largest("open_area") + largest("slip_area") + largest("stick_area"))
    if largest(*("force_" + axis for axis in AXES)) >= ROUNDING * pressing:
        return "force"
    turning = largest(*("moment_" + axis for axis in AXES))
    return "moment" if turning > ROUNDING * pressing * length else "normal_force"


def twists(boundaries):
    """Whether bodies are turned about where they press, by more than forces there do."""
    def couple(rows):
        centre, force, moment = (np.array([np.nan_to_num(rows[f"{what}_{axis}"])
                                           for axis in AXES])
                                 for what in ("center", "force", "moment"))
        return np.linalg.norm(moment - np.cross(centre, force, axis=0), axis=0)

    return any(couple(rows).max() > MUCH * np.max(
        rows["normal_force"] * np.sqrt(rows["slip_area"] + rows["stick_area"]))
        for rows in boundaries.values())


def diagrams(boundaries):
    """What is drawn: quantity, words of the abscissa, its unit (None: of lengths), and
    for each boundary the abscissa and its rows."""
    what = force_or_moment(boundaries)
    over_time = {name: (rows["t"], rows) for name, rows in boundaries.items()}
    turned = {name: (rows["obstacle_angle"], rows)
              for name, rows in boundaries.items() if np.ptp(rows["obstacle_angle"]) > 0}
    result = [(what, "t", "", over_time)]
    if what == "force" and not turned and twists(boundaries):
        result.append(("moment", "t", "", over_time))
    for c, axis in enumerate(AXES):
        curves = {name: (rows["obstacle_" + axis], rows)
                  for name, rows in boundaries.items() if c in moved(rows)}
        if curves:
            result.append((what, f"obstacle displacement along {axis}", None, curves))
    if turned:
        result.append(("torque", "obstacle turned by", "rad", turned))
    if any(rows["slip_area"].max() > 0 for rows in boundaries.values()):
        result.append(("dissipated_total", "t", "", over_time))
    return result


def ordinates(what, curves, names):
    """What is drawn over the abscissa: words, kind of unit, and the curves of
    each boundary by label and colour; names: of all boundaries."""
    if what in SINGLE:
        return (*SINGLE[what], {
            name: {"": (COLORS[names.index(name) % len(COLORS)], rows[what])}
            for name, (_, rows) in curves.items()})
    forces = {name: np.array([rows[f"{what}_{axis}"] for axis in AXES])
              for name, (_, rows) in curves.items()}
    largest = max(np.abs(force).max() for force in forces.values())
    return f"{what} on the body", what, {
        name: {AXES[c]: (COLORS[c], force[c]) for c in range(3)
               if np.abs(force[c]).max() > ROUNDING * largest}
        for name, force in forces.items()}


def draw_curves(axes, names, start, what, words, unit, curves, units):
    """A diagram; over t with dotted lines from the start, where the body is as it is made,
    whatever the loads there. Of ways of obstacles it is not known where they begin."""
    ordinate, kind, lines = ordinates(what, curves, names)
    largest = max((np.abs(values).max() for those in lines.values()
                   for _, values in those.values()), default=0)
    n_lines = sum(map(len, lines.values()))
    if n_lines > MANY:
        lines = {name: {axis: line for axis, line in those.items()
                        if np.abs(line[1]).max() > SMALL_PART * largest}
                 for name, those in lines.items()}
    left_out = n_lines - sum(map(len, lines.values()))
    furthest = max(np.abs(place).max() for place, _ in curves.values())
    exponents = (exponent_of(furthest), exponent_of(largest))
    for name, (place, _) in curves.items():
        again, line = divmod(names.index(name), len(LINES))
        for axis, (color, values) in lines[name].items():
            parts = [axis] * bool(axis) + [plain(name)] * (len(curves) > 1)
            place_shown, shown = place / 10.0**exponents[0], values / 10.0**exponents[1]
            axes.plot(place_shown, shown, LINES[line], color=color,
                      marker=MARKERS[again % len(MARKERS)], markersize=4,
                      linewidth=1.2, label=", ".join(parts) or None)
            if words == "t" and start < place[0]:
                axes.plot([start / 10.0**exponents[0], place_shown[0]], [0, shown[0]],
                          ":", color=color, linewidth=1)
    if left_out:
        axes.plot([], [], " ",
                  label=f"and {left_out} below {100 * SMALL_PART:.0f} % of the largest")
    axes.axhline(0, color="#C4C4C4", linewidth=0.8, zorder=0)
    axes.set_xlabel(label(words, units["length"] if unit is None else unit,
                          exponents[0]), size=NORMAL, color=TEXT)
    axes.set_ylabel(label(ordinate, units[kind], exponents[1]), size=NORMAL, color=TEXT)
    if axes.get_legend_handles_labels()[0]:
        # above, where no curve is
        axes.legend(fontsize=SMALL, frameon=False, labelcolor=TEXT, loc="lower left",
                    bbox_to_anchor=(0, 1), ncol=3, borderpad=0)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter(lambda value, _: number(value))


def draw(boundaries, units, start=math.inf):
    """The figure of all diagrams, side by side; start: t before the first step."""
    shown = diagrams(boundaries)
    figure = Figure(figsize=(WIDTH * len(shown), HEIGHT), facecolor="white",
                    layout="constrained")
    FigureCanvasAgg(figure)
    for axes, diagram in zip(figure.subplots(1, len(shown), squeeze=False)[0], shown):
        draw_curves(axes, list(boundaries), start, *diagram, units)
    return figure
