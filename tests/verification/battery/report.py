"""The results as verification.json, verification.md, and a picture a plot."""

import json
import math
import os
import re


def as_text(value):
    """A value for people."""
    return value if isinstance(value, str) else f"{value:.6g}"


def allowed_text(row):
    """What a row has to keep to."""
    if row.kind == "same":
        return "none"
    if row.kind == "order":
        return f"{row.allowed:.3g}"
    least = "at least " if row.kind == "at least" else ""
    return least + (f"{row.allowed:.3g}" if row.is_difference
                    else f"{100 * row.allowed:.3g} %")


def deviation_text(row):
    """By how much it is off."""
    if row.kind == "same":
        return "none" if row.passed else "another"
    if row.is_difference or row.kind == "order":
        return f"{row.deviation:.2g}"
    return f"{100 * row.deviation:.2g} %"


def file_of(title):
    """A file name without blanks."""
    return re.sub(r"[^a-z0-9]+", "_", title.lower()).strip("_")


def write(directory, machine, results, quick):
    """Writes everything; results: name, rows, plots, seconds of each case."""
    os.makedirs(directory, exist_ok=True)
    entries = [{"case": name, "quantity": row.quantity, "computed": row.computed,
                "reference": row.reference, "source": row.source,
                "deviation": row.deviation if math.isfinite(row.deviation) else None,
                "kind": row.kind, "allowed": row.allowed, "passed": bool(row.passed)}
               for name, rows, _, _ in results for row in rows]
    with open(os.path.join(directory, "verification.json"), "w", encoding="utf-8") as file:
        json.dump({"machine": machine, "quick": quick, "rows": entries}, file, indent=1,
                  default=float)
    lines = ["# Verification", "", machine + (", coarse meshes" if quick else ""), ""]
    for name, rows, plots, seconds in results:
        lines += [f"## {name}", "",
                  "| quantity | computed | reference | deviation | allowed | | source |",
                  "|---|---|---|---|---|---|---|"]
        lines += ["| " + " | ".join([
            row.quantity, as_text(row.computed), as_text(row.reference),
            deviation_text(row), allowed_text(row), "pass" if row.passed else "FAIL",
            row.source.replace("|", "/")]) + " |" for row in rows]
        lines += ["", f"{seconds:.1f} s", ""]
        for plot in plots:
            if draw(plot, os.path.join(directory, file_of(plot.title) + ".png")):
                lines += [f"![{plot.title}]({file_of(plot.title)}.png)", ""]
    with open(os.path.join(directory, "verification.md"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines))


def draw(plot, name):
    """One picture, where there is matplotlib."""
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError:
        return False
    figure = Figure(figsize=(6, 4))
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    for curve in plot.curves:
        axes.plot(curve.x, curve.y, curve.style, label=curve.label, markersize=4)
    if plot.logarithmic:
        axes.set_xscale("log")
        axes.set_yscale("log")
    axes.set(title=plot.title, xlabel=plot.x, ylabel=plot.y)
    axes.legend()
    axes.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(name, dpi=90)
    return True
