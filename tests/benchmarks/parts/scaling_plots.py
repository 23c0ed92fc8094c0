"""The plots of the scaling benchmark, as .svg and as .png."""

import math
import os

from matplotlib.ticker import NullFormatter

from . import weak_scaling
from .plots import finish, panels
from .scaling_report import SHARE_NAMES
from .scaling_results import LIMITS, plural

COLORS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")
MARKERS = ("o", "s", "^", "D", "v", "P")
AS_IT_IS = "as it is"
DISTRIBUTED = "contact vectors\ndistributed"
SHARE_COLORS = ("#BBBBBB", "#0072B2", "#56B4E9", "#D55E00", "#E69F00", "#009E73")


def curves(axis, result, value):
    """A curve for each number of ranks; value: of an entry."""
    for index, ranks in enumerate(result.ranks):
        points = [
            (entry["unknowns"], value(entry))
            for entry in result.solved(ranks)
            if value(entry) is not None
        ]
        if points:
            axis.plot(
                *zip(*points),
                color=COLORS[index % len(COLORS)],
                marker=MARKERS[index % len(MARKERS)],
                # curves that agree stay visible
                markersize=5 + 3 * index,
                markerfacecolor="none" if index else None,
                linestyle="--" if index else "-",
                linewidth=1.2,
                label=plural(ranks, "rank"),
            )
    axis.set_xscale("log")
    axis.set_xlabel("unknowns")
    low, high = (math.log10(end) for end in axis.get_xlim())
    axis.set_xlim(10 ** math.floor(low), 10 ** math.ceil(high))
    axis.xaxis.set_minor_formatter(NullFormatter())


def limit(axis, value):
    """A criterion's line."""
    axis.axhline(value, color="#555555", linestyle=":", label="criterion")


def save(figure, axes, path, result):
    """Legend and files."""
    order = [plural(ranks, "rank") for ranks in result.ranks]
    finish(figure, axes, path, [*order, "criterion"])


def time_per_unknown(result, path):
    """Of the contact solve and of an elastic solve."""
    figure, axes = panels(1, 2, sharey=True)
    for axis, name, title in zip(
        axes[0],
        ("contact_solve_s", "elastic_solve_s"),
        ("contact solve", "one elastic solve"),
    ):

        def microseconds(entry, name=name):
            seconds = entry[name]
            return None if seconds is None else 1e6 * seconds / entry["unknowns"]

        curves(axis, result, microseconds)
        axis.set_title(title)
        axis.set_ylim(bottom=0)
    axes[0][0].set_ylabel("time an unknown [µs]")
    save(figure, axes, path, result)


def worth(result, path):
    """Equivalents and Krylov ratio."""
    figure, axes = panels(1, 2)
    for axis, name, title in zip(
        axes[0],
        ("equivalents", "krylov_ratio"),
        ("contact solve / elastic solve, time", "Krylov iterations / elastic solve's"),
    ):
        curves(axis, result, lambda entry, name=name: entry[name])
        limit(axis, LIMITS[name])
        axis.set_title(title)
        axis.set_ylim(bottom=0)
    save(figure, axes, path, result)


def memory(result, path):
    """Bytes an unknown."""
    figure, axes = panels(1, 1)
    axis = axes[0][0]
    curves(axis, result, lambda entry: entry["bytes_per_unknown"])
    limit(axis, LIMITS["bytes"])
    axis.set_yscale("log")
    axis.set_ylabel("peak memory an unknown [B]")
    save(figure, axes, path, result)


def model(result, network, per_rank, path):
    """Weak scaling, time by share and efficiency."""
    solver = result.model()
    sizes = [2**power * per_rank for power in range(15)]
    rows = weak_scaling.table(solver, network, per_rank, sizes)
    other = weak_scaling.table(
        weak_scaling.without_contact(solver), network, per_rank, sizes
    )
    unknowns = [row["unknowns"] for row in rows]
    figure, axes = panels(1, 2)
    left, right = axes[0]
    left.stackplot(
        unknowns,
        [[row[name] for row in rows] for name in SHARE_NAMES],
        colors=SHARE_COLORS,
    )
    shares = [name.replace(", ", ",\n") for name in SHARE_NAMES.values()]
    for name, color in zip(shares, SHARE_COLORS):
        left.plot([], [], color=color, linewidth=6, label=name)  # for the legend
    left.set_title(f"contact solve [s], {per_rank:.3g} unknowns a rank")
    right.plot(
        unknowns,
        [row["efficiency"] for row in rows],
        color="black",
        label=AS_IT_IS,
    )
    right.plot(
        unknowns,
        [row["efficiency"] for row in other],
        color="black",
        linestyle="--",
        label=DISTRIBUTED,
    )
    right.set_title("efficiency of weak scaling")
    right.set_ylim(0, 1.05)
    for axis in (left, right):
        axis.set_xscale("log")
        axis.set_xlabel("unknowns (model)")
        axis.set_xlim(unknowns[0], unknowns[-1])
    finish(figure, axes, path, [*reversed(shares), AS_IT_IS, DISTRIBUTED])


def draw_all(result, network, per_rank, directory):
    """Draws everything; returns [(name of the .png, caption), ...]."""
    made = []

    def draw(name, caption, function, *arguments):
        function(*arguments, os.path.join(directory, name))
        made.append((name + ".png", caption))

    if any(result.solved(ranks) for ranks in result.ranks):
        caption = "Time an unknown against the number of unknowns"
        draw("time_per_unknown", caption, time_per_unknown, result)
        caption = "What a contact solve is worth, and its Krylov ratio"
        draw("worth", caption, worth, result)
        draw("memory", "Peak memory an unknown", memory, result)
    if result.model():
        caption = "Weak scaling beyond this machine: the model"
        draw("weak_scaling", caption, model, result, network, per_rank)
    return made
