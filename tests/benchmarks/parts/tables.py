"""table_1.csv for programs and table_1.md for people."""

import csv
import os
import statistics

from . import cases, figures, results, runs

READINGS_SENTENCE = (
    "Reading A takes n and m as numbers of nodes and of contact nodes, as the "
    "caption says (brick of 4 × 3 × 1 m, Q of order 3m), reading B as numbers "
    "of unknowns and of dual unknowns (3 × 1 × 1 m, Q of order m); both give "
    "every n/m exactly, so the table alone cannot decide, and as it gives no "
    "loads either, ours are our own choice."
)
EXPONENT_LEVELS = (3, 4, 5, 6)


SQUARES = """\
The paper's ratios at k = 6 are 34 and 139; they are not found here, and need
not be. Here a product with the Hessian of the squares is one with Q and a
little more, whatever their number, and the same proportioning with projected
conjugate-gradient expansions works on their bounds, so that the ratio is that
of the numbers of products, between one and three. Formed as a matrix in the larger
number of unknowns, as a predecessor may well have done, the Hessian would cost
2.8 and 9 times as much in every product; it is singular besides, which slows
conjugate gradients that do not know of it, and the paper's times grow like n²
for the squares and like n^1.1 for ALG_GS. More cannot be told from the paper.
What the squares do cost, here as there, is exactness: see the error of
the polygons below."""


def write_csv(result, path):
    """A row a run with every figure; empty where there is none."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, results.COLUMNS, extrasaction="ignore")
        writer.writeheader()
        writer.writerows(result.entries.values())


def seconds(value):
    """Three digits are more than timings repeat."""
    if value is None:
        return "–"
    digits = 0 if value >= 100 else 1 if value >= 10 else 2 if value >= 0.1 else 4
    return f"{value:.{digits}f}"


def plain(value, style=".3g"):
    """A number, or a dash where there is none."""
    return "–" if value is None else f"{value:{style}}"


def whole(value):
    """A count, which may be a fraction of products."""
    return plain(value, ".0f")


def cell(entry, *shown):
    """What a table says of a run: the texts made of it, or how it failed.

    shown: functions of the entry.
    """
    if entry is None or entry["status"] == results.NOT_RUN:
        return ""
    if entry["status"] == runs.LIMIT:
        return f"> {entry['limit_s']:g} s"
    if entry["status"] in (results.SKIPPED, runs.ERROR, runs.CRASHED):
        return entry["status"]
    mark = "" if entry["solved"] else " †"
    return " / ".join(show(entry) for show in shown) + mark


def figure(name, style):
    """For cell(): the figure of this name in this style."""
    return lambda entry: style(entry[name])


def markdown_table(header, lines):
    """Lines of a markdown table; the first column is text."""
    rule = ["---"] + ["---:"] * (len(header) - 1)
    return [
        "| " + " | ".join(str(part) for part in line) + " |"
        for line in [header, rule, *lines]
    ] + [""]


def paper_layout(result, name):
    """The table as the paper has it, its three columns beside ours."""
    readings = result.chosen("reading")
    header = ["n/m"] + [f"{method}, paper" for method in cases.PAPER_SECONDS]
    header += [f"{method}, {r}" for r in readings for method in cases.PAPER_SECONDS]
    lines = []
    for k in result.chosen("k"):
        line = [f"{cases.table_n(k)} / {cases.table_m(k)}"]
        line += [times[k - 1] for times in cases.PAPER_SECONDS.values()]
        line += [
            cell(result.get(k, reading, "given", method), figure(name, seconds))
            for reading in readings
            for method in cases.PAPER_SECONDS
        ]
        lines.append(line)
    return markdown_table(header, lines)


def growth(result):
    """Growth exponents beside the paper's."""
    sizes = [cases.table_n(k) for k in EXPONENT_LEVELS]
    columns = [
        (reading, name)
        for reading in result.chosen("reading")
        for name in ("program_s", "iteration_s")
    ]
    header = ["p in time = c·n^p", "paper"]
    short = {"program_s": "program", "iteration_s": "iteration"}
    header += [f"{reading}, {short[name]}" for reading, name in columns]
    lines = []
    for law in result.chosen("law"):
        for method in result.methods(law):
            paper = cases.PAPER_SECONDS.get(method) if law == "given" else None
            line = [f"{method}, {law}"]
            line.append(
                plain(figures.growth_exponent(sizes, paper[2:]), ".2f")
                if paper
                else ""
            )
            for reading, name in columns:
                costs = [
                    result.cost(k, reading, law, method, name)
                    for k in EXPONENT_LEVELS
                ]
                line.append(plain(figures.growth_exponent(sizes, costs), ".2f"))
                if 1 < sum(cost is not None for cost in costs) < len(costs):
                    line[-1] += " *"
            lines.append(line)
    return markdown_table(header, lines)


def squares_ratios(result):
    """How much slower the squares are, beside the paper's factors."""
    readings = result.chosen("reading")
    pairs = [("ALG_2", "ALG_GS"), ("ALG_4", "ALG_GS")]
    header = ["k"]
    for over, under in pairs:
        header += [f"{over}/{under}, paper"]
        for reading in readings:
            header += [f"{reading}, program", f"{reading}, iteration"]
    lines = []
    for k in result.chosen("k"):
        line = [k]
        for over, under in pairs:
            paper = cases.PAPER_SECONDS
            line.append(plain(paper[over][k - 1] / paper[under][k - 1], ".1f"))
            for reading in readings:
                for name in ("program_s", "iteration_s"):
                    quotient = figures.ratio(
                        result.cost(k, reading, "given", over, name),
                        result.cost(k, reading, "given", under, name),
                    )
                    line.append(plain(quotient, ".1f"))
        lines.append(line)
    return markdown_table(header, lines)


def all_methods(result, law, reading, *shown):
    """A table of all methods, a column a k."""
    levels = result.chosen("k")
    lines = []
    for method in result.methods(law, reading=reading):
        entries = [result.get(k, reading, law, method) for k in levels]
        lines.append([method] + [cell(entry, *shown) for entry in entries])
    return markdown_table([f"{law}, {reading}"] + [f"k = {k}" for k in levels], lines)


def agreement(result):
    """How far the certified answers are apart."""
    lines = []
    for law in result.chosen("law"):
        for reading in result.chosen("reading"):
            for method in result.methods(law, ("disc",)):
                entries = [
                    entry
                    for case, entry in result.entries.items()
                    if case.series == (reading, law, method) and entry["solved"]
                ]
                if not entries:
                    continue
                lines.append([f"{method}, {law}, {reading}"])
                lines[-1].append(", ".join(str(entry["k"]) for entry in entries))
                for name in ("force_difference", "kkt_residual", "duality_gap"):
                    known = [e[name] for e in entries if e[name] is not None]
                    lines[-1].append(plain(max(known, default=None), ".1e"))
                if all(entry["force_reference"] == method for entry in entries):
                    lines[-1][2] = "reference"
    header = ["method", "certified at k =", "force", "KKT residual", "duality gap"]
    return markdown_table(header, lines)


def polygons(result):
    """What replacing the disc by a polygon does to the answer."""
    lines = []
    levels = result.chosen("k")
    for method in result.methods("given", ("polygon",)):
        for reading in result.chosen("reading"):
            entries = [result.get(k, reading, "given", method) for k in levels]
            shown = (
                figure("kkt_residual", lambda value: plain(value, ".1e")),
                figure("force_difference", lambda value: plain(value, ".1e")),
            )
            lines.append([f"{method}, {reading}"] + [cell(e, *shown) for e in entries])
    return markdown_table(["method"] + [f"k = {k}" for k in levels], lines)


def factorisations(result):
    """Newton's time in units of the two factorisations."""
    header = ["Newton", "iteration [s]", "Cholesky of Q [s]", "ratio"]
    header += ["program [s]", "factorisation of K [s]", "ratio"]
    lines = []
    for case, entry in result.entries.items():
        if case.method != "Newton_measured" or not entry["solved"]:
            continue
        program = result.cost(case.k, case.reading, case.law, "Newton", "program_s")
        pairs = [
            (entry["iteration_s"], entry["dense_cholesky_s"]),
            (program, entry["sparse_factorization_s"]),
        ]
        line = [f"k = {case.k}, {case.law}, {case.reading}"]
        for over, under in pairs:
            quotient = plain(figures.ratio(over, under), ".2f")
            line += [seconds(over), seconds(under), quotient]
        lines.append(line)
    return markdown_table(header, lines) if lines else ["Not measured.", ""]


def failures(result):
    """What went wrong, a line a sentence."""
    sentences = {}
    for case, entry in result.entries.items():
        failed = entry["status"] in (runs.ERROR, runs.CRASHED, runs.NOT_CERTIFIED)
        if failed and not entry["solved"]:
            sentences.setdefault(entry["message"], []).append(case)
    lines = []
    for sentence, failed in sentences.items():
        methods = ", ".join(dict.fromkeys(case.method for case in failed))
        lines.append(f"- {methods} ({len(failed)} runs): {sentence}")
    count = [entry["status"] for entry in result.entries.values()].count
    for status in (runs.LIMIT, results.SKIPPED, results.NOT_RUN):
        if count(status):
            lines.append(f"- {count(status)} runs: {status}")
    return (lines or ["Nothing."]) + [""]


def start_up(result):
    """Seconds of a run before the program's own clock starts, the median."""
    waits = [
        entry["wall_s"] - entry["program_s"]
        for entry in result.entries.values()
        if entry["program_s"] is not None
    ]
    return statistics.median(waits) if waits else 0.0


def disturbance(result):
    """How far wall time was above CPU time: others used the machine, or not."""
    long_runs = [
        entry["wall_s"] / entry["cpu_s"]
        for entry in result.entries.values()
        if entry["cpu_s"] and entry["wall_s"] > 5
    ]
    return plain(max(long_runs, default=None), ".2f")


def description(result):
    """Where, when and how."""
    row = result.newest_row()
    about = dict(row["machine"], threads=row["threads"])
    about["program"] = row["program"]
    about["tolerance of the certificate"] = figures.short(row["tolerance"])
    dates = sorted(other["date"] for other in result.rows.values())
    about["runs made"] = f"{dates[0]} to {dates[-1]}"
    about["largest wall time / CPU time, runs above 5 s"] = disturbance(result)
    about["command"] = f"`{row['command']}`"
    return [f"- {key}: {value}" for key, value in about.items()] + [""]


def write_markdown(result, plots, path):
    """The whole report. plots: [(file name, caption), ...]."""
    row = result.newest_row()
    lines = ["# The paper's Table 1", "", READINGS_SENTENCE, ""]
    lines += [
        "Times are seconds on the machine described at the end, those of the "
        "paper are from the hardware of its time: compare growth and ratios, "
        "not seconds. *Program* is the whole program by its own clock, from "
        "mesh to the last file; *iteration* is the dual method alone, with Q "
        "given, without the certificate. Loading libraries and starting MPI "
        f"came to {seconds(start_up(result))} s more in each run (median); with "
        "it, and as CPU time, `table_1.csv` has every run. "
        "Every run aims at a certificate of "
        f"{figures.short(row['tolerance'])}. † means that the tolerance was not "
        f"reached, *{results.SKIPPED}* that a smaller k was over the time limit, "
        f"*{runs.ERROR}* that the program said why it cannot run (last but one "
        "section).",
        "",
    ]
    if "given" in result.chosen("law"):
        lines += ["## In the paper's layout: program, given friction [s]", ""]
        lines += paper_layout(result, "program_s")
        lines += ["## The same: iteration alone [s]", ""]
        lines += paper_layout(result, "iteration_s")
        lines += ["## The price of squares instead of discs", ""]
        lines += [SQUARES, ""]
        lines += squares_ratios(result)
    lines += ["## Growth", "", "Least squares in logarithms over k = 3…6"]
    lines[-1] += "; * over those of them that were reached."
    lines += ["", *growth(result)]
    pairs = [(w, r) for w in result.chosen("law") for r in result.chosen("reading")]
    lines += ["## All methods: program / iteration [s]", ""]
    for law, reading in pairs:
        shown = (figure("program_s", seconds), figure("iteration_s", seconds))
        lines += all_methods(result, law, reading, *shown)
    lines += [f"## Products with Q: to 1e-6 / to {figures.short(row['tolerance'])}", ""]
    if any("ADMM" in result.methods(law) for law in result.chosen("law")):
        lines += ["ADMM factorises Q and solves with the factor once an iteration, which "
            "products do not show; the plots of products leave it out.", ""]
    for law, reading in pairs:
        shown = (figure("products_to_1e-6", whole), figure("products", whole))
        lines += all_methods(result, law, reading, *shown)
    lines += ["## Agreement", ""]
    lines += [
        "Largest relative difference of the contact force to the first of "
        f"{', '.join(cases.REFERENCE_METHODS)} that is certified at the same "
        "k, and the largest certified errors.",
        "",
        *agreement(result),
    ]
    if result.methods("given", ("polygon",)):
        lines += ["## The error of the polygons: KKT residual / force", ""]
        lines += [
            "The certificate is that of the disc, so it refuses an answer that "
            "is exact for the polygon: what it finds is the polygon's error.",
            "",
            *polygons(result),
        ]
    lines += ["## Newton in units of one factorisation", "", *factorisations(result)]
    if plots:
        lines += ["## Plots", ""]
        for name, caption in plots:
            lines += [caption, "", f"![{caption}]({os.path.basename(name)})", ""]
    lines += ["## What is missing above, and why", "", *failures(result)]
    lines += ["## Machine, program, command", "", *description(result)]
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(lines))
