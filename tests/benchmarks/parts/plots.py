"""The plots, as .svg to zoom into and .png to look at."""

import os

import matplotlib

matplotlib.use("Agg")  # no screen is needed
# pylint: disable=wrong-import-position
from matplotlib import pyplot
from matplotlib.ticker import NullFormatter, ScalarFormatter

from . import cases, figures, runs

# Every method has its own colour, marker and line; methods of one family have
# one hue, from light to dark.
STYLES = {
    "ALG_GS": ("#0072B2", "-", "o"),
    "GS_fixed_point": ("#CC79A7", "--", "h"),
    "ALG_2": ("#F0B040", "-", "^"),
    "ALG_4": ("#C06A00", "--", "s"),
    "ALG_8": ("#6B3A00", ":", "D"),
    "QPQ_V0": ("#A6D8F5", "-", "v"),
    "QPQ_V1": ("#56B4E9", "--", "<"),
    "QPQ_V2": ("#2A7FA8", "-.", ">"),
    "QPQ_V4": ("#0B3C5D", ":", "P"),
    "MPGP": ("#009E73", "-", "X"),
    "Newton": ("#000000", "-", "*"),
    "ADMM": ("#D55E00", "-", "p"),
}
PAPER_MARKERS = {"ALG_GS": "o", "ALG_2": "^", "ALG_4": "s"}
READINGS = "Reading A: n of the paper's table counts nodes, B: it counts unknowns"
LAW_TITLES = {"given": "given friction", "coulomb": "Coulomb friction"}

pyplot.rcParams.update(
    {
        "font.size": 9,
        "axes.grid": True,
        "grid.color": "#dddddd",
        "grid.linewidth": 0.6,
        "axes.axisbelow": True,
        "svg.hashsalt": "stiction",  # the same data give the same file
        "svg.fonttype": "none",
    }
)


def line_style(method):
    """Keywords of plot() for a method."""
    color, line, marker = STYLES[method]
    size = 8 if marker == "*" else 5
    return {"color": color, "linestyle": line, "marker": marker, "markersize": size}


def panels(rows, columns, **options):
    """A grid of axes, left of a second subfigure for the legend."""
    widths = [3.7 * columns, 1.7]
    figure = pyplot.figure(
        figsize=(sum(widths), 0.4 + 2.9 * rows), layout="constrained"
    )
    left, _ = figure.subfigures(1, 2, width_ratios=widths)
    return figure, left.subplots(rows, columns, squeeze=False, **options)


def finish(figure, axes, path, order=None, title=None):
    """One legend for all panels, outside of them; writes both files.

    order: of the labels; that of the methods if it is left out.
    """
    if title:
        figure.suptitle(title)
    known = {}
    for axis in axes.flat:
        for handle, label in zip(*axis.get_legend_handles_labels()):
            known.setdefault(label, handle)
    if order is None:
        order = list(STYLES) + [f"{name}, paper" for name in cases.PAPER_SECONDS]
    labels = sorted(known, key=order.index)
    if labels:
        figure.subfigs[1].legend(
            [known[label] for label in labels],
            labels,
            loc="center left",
            frameon=False,
            handlelength=3,
        )
    figure.savefig(path + ".svg", metadata={"Date": None})
    figure.savefig(path + ".png", dpi=130)
    pyplot.close(figure)


def problem_panels(result, share=True):
    """Axes with a title for each law (row) and reading (column)."""
    laws, readings = result.chosen("law"), result.chosen("reading")
    figure, axes = panels(len(laws), len(readings), sharex=share, sharey=share)
    named = {}
    for row, law in enumerate(laws):
        for column, reading in enumerate(readings):
            axes[row][column].set_title(f"{LAW_TITLES[law]}, reading {reading}")
            named[law, reading] = axes[row][column]
    return figure, axes, named


def comparable(methods, name):
    """Those whose cost a figure tells: ADMM's is in its factorisations."""
    return [m for m in methods if name != "products" or m != "ADMM"]


def against_n(result, name, ylabel, path, title, paper=False):
    """A figure of every run against n, both in logarithms.

    title: what is counted.
    """
    levels = result.chosen("k")
    figure, axes, named = problem_panels(result)
    sizes = [cases.table_n(k) for k in levels]
    for (law, reading), axis in named.items():
        if paper and law == "given":
            for method, times in cases.PAPER_SECONDS.items():
                axis.plot(
                    sizes,
                    [times[k - 1] for k in levels],
                    color="#888888",
                    linestyle="-",
                    linewidth=1,
                    marker=PAPER_MARKERS[method],
                    markerfacecolor="white",
                    markersize=5,
                    label=f"{method}, paper",
                )
        for method in comparable(result.methods(law), name):
            # not a number leaves a gap: a line would hide a failed run
            costs = [
                result.cost(k, reading, law, method, name) or float("nan")
                for k in levels
            ]
            if any(cost > 0 for cost in costs):
                axis.plot(sizes, costs, label=method, **line_style(method))
        axis.set_xscale("log")
        axis.set_yscale("log")
        axis.set_xticks(sizes, [str(size) for size in sizes], rotation=40)
        axis.xaxis.set_minor_formatter(NullFormatter())
        axis.minorticks_off()
    for axis in axes[-1]:
        axis.set_xlabel("n of the paper's Table 1")
    for axis in axes[:, 0]:
        axis.set_ylabel(ylabel)
    finish(figure, axes, path, title=f"{title}\n{READINGS}")


def residual_histories(result, path):
    """The residual against products with Q at the largest k that was done.

    ADMM is left out: what it does is not products.
    """
    figure, axes, named = problem_panels(result, share=False)
    for (law, reading), axis in named.items():
        entries = [
            entry
            for entry in result.entries.values()
            if (entry["law"], entry["reading"]) == (law, reading)
            and entry["method"] in comparable(STYLES, "products")
            and len(entry["history"]) > 1
        ]
        largest = max((entry["k"] for entry in entries), default=None)
        for entry in entries:
            if entry["k"] != largest:
                continue
            style = dict(line_style(entry["method"]), markersize=3)
            points = [(p, r) for p, r in entry["history"] if p > 0 and r > 0]
            axis.plot(
                *zip(*points),
                label=entry["method"],
                markevery=max(1, len(points) // 15),
                linewidth=1,
                **style,
            )
        axis.set_xscale("log")
        axis.set_yscale("log")
        # A divergent start must not squeeze what matters.
        axis.set_ylim(top=min(axis.get_ylim()[1], 1e2))
        if largest:
            axis.set_title(axis.get_title() + f", k = {largest}")
    for axis in axes[-1]:
        axis.set_xlabel("products with Q")
    for axis in axes[:, 0]:
        axis.set_ylabel("KKT residual (relative)")
    finish(figure, axes, path)


def profile_costs(result, law, name):
    """{method: costs} over all k and readings in which every method is known.

    None where a method failed. Polygons are another problem and left out.
    """
    methods = comparable(result.methods(law, ("disc",)), name)
    known = (runs.CERTIFIED, runs.NOT_CERTIFIED, runs.LIMIT, "skipped")
    problems = [
        (k, reading)
        for k in result.chosen("k")
        for reading in result.chosen("reading")
        if all(
            (entry := result.get(k, reading, law, method))
            and entry["status"] in known
            for method in methods
        )
    ]
    costs = {
        method: [
            result.cost(k, reading, law, method, name) for k, reading in problems
        ]
        for method in methods
    }
    return costs, len(problems)


def performance_profiles(result, path):
    """Dolan and More's profiles of iteration time and of products."""
    laws = result.chosen("law")
    columns = {
        "iteration_s": "iteration time / best",
        "products": "products with Q / best",
    }
    figure, axes = panels(len(laws), len(columns), sharey=True)
    for row, law in zip(axes, laws):
        for axis, (name, label) in zip(row, columns.items()):
            costs, number = profile_costs(result, law, name)
            profile = figures.performance_profile(costs)
            ends = [factor for line in profile.values() for factor, _ in line]
            end = 1.3 * max(ends, default=2)
            for method, corners in profile.items():
                # from nothing solved at factor 1 up to the right edge
                corners = [(1, 0), *corners]
                corners.append((end, corners[-1][1]))
                style = dict(line_style(method), markersize=4)
                axis.step(*zip(*corners), where="post", label=method, **style)
            axis.set_xscale("log")
            axis.set_xlim(1 / 1.03, end)
            axis.set_ylim(-0.03, 1.05)
            if end < 30:  # too few powers of ten for ticks there alone
                ticks = [tick for tick in (1, 2, 3, 5, 10, 20) if tick < end]
                axis.set_xticks(ticks)
                axis.xaxis.set_major_formatter(ScalarFormatter())
                axis.xaxis.set_minor_formatter(NullFormatter())
            axis.set_title(f"{LAW_TITLES[law]}, {number} problems")
            axis.set_xlabel(label)
        row[0].set_ylabel("share of the problems solved")
    finish(figure, axes, path)


def draw_all(result, directory):
    """Draws everything; returns [(name of the .png, caption), ...]."""
    made = []

    def draw(name, caption, function, *arguments):
        function(*arguments, os.path.join(directory, name))
        made.append((name + ".png", caption))

    def iteration_time(path):
        label = "iteration alone [s]"
        title = "Time of the iteration alone until a method has solved its problem"
        against_n(result, "iteration_s", label, path, title, paper=True)

    def program_time(path):
        title = "Time of the whole program, from mesh to files"
        label = "whole program [s]"
        against_n(result, "program_s", label, path, title, paper=True)

    def products(path):
        title = "Multiplications by Q until a method has solved its problem"
        against_n(result, "products", "multiplications by Q", path, title)

    draw("time_program", "Time of the whole program against n", program_time)
    draw("time_iteration", "Time of the iteration alone against n", iteration_time)
    draw("products", "Products with Q against n", products)
    draw(
        "residuals",
        "KKT residual against products with Q at the largest k",
        residual_histories,
        result,
    )
    draw(
        "profiles",
        "Performance profiles (Dolan and Moré) over all k and readings: how "
        "many problems a method solves within a factor of the best one; "
        "polygons are another problem and left out",
        performance_profiles,
        result,
    )
    return made
