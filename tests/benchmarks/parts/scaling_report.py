"""scaling.csv for programs and scaling.md for people."""

import csv

from . import figures, runs, weak_scaling
from .scaling_results import COLUMNS, FLAT_RANGE, GETFEM_SOURCE, MILLION
from .scaling_results import plural, solved
from .tables import markdown_table, plain, seconds, whole

MODEL_SIZES = (1e6, 8e6, 6.4e7, 2.56e8, 1e9, 1e10)
SHARE_NAMES = {
    "compute": "arithmetic",
    "ghosts": "neighbours",
    "sums": "sums",
    "contact_sums": "contact vectors, sent",
    "contact_work": "contact vectors, repeated work",
    "coarse": "coarsest mesh",
}


def write_csv(result, path):
    """A row for each run with every figure; empty where there is none."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, COLUMNS, extrasaction="ignore")
        writer.writeheader()
        writer.writerows(result.entries.values())


def integer(value):
    """A count with separators."""
    return plain(value, ",d")


def ratio(value):
    """Two decimals."""
    return plain(value, ".2f")


def tiny(value):
    """A residual."""
    return plain(value, ".1e")


def ending(entry):
    """How a run ended that has no figures; empty if it has."""
    if entry["status"] in (runs.CERTIFIED, runs.NOT_CERTIFIED):
        return ""
    if entry["status"] == runs.LIMIT:
        return f"> {entry['limit_s']:g} s"
    return entry["status"]


def lines_of(entries, name, columns):
    """A line for each entry. name: of the entry, for the first column;
    columns: {header: (figure, style)}."""
    lines = []
    for entry in entries:
        line = [name(entry)]
        failed = ending(entry)
        if failed:
            line += [failed] + [""] * (len(columns) - 1)
        else:
            line += [style(entry[key]) for key, style in columns.values()]
            if not solved(entry):
                line[1] += " †"
        lines.append(line)
    return lines


def table_of(entries, first, name, columns):
    """A markdown table of lines_of()."""
    return markdown_table([first, *columns], lines_of(entries, name, columns))


def criteria(checks):
    """The verdicts, as a list."""
    lines = []
    for check in checks:
        found = check.found or "no figure"
        lines.append(f"- ({check.number}) {check.asked}: **{check.verdict}** – {found}")
    return lines + [""]


def sizes(result):
    """All sizes: what was done, what it took, what it needed."""
    lines = []
    for ranks in result.ranks:
        entries = [e for e in result.of_part("sizes") if e["ranks"] == ranks]
        lines += [f"### On {plural(ranks, 'rank')}", ""]
        columns = {
            "Newton steps": ("newton_steps", integer),
            "Krylov": ("krylov_iterations", integer),
            "on coarser meshes": ("coarse_krylov_iterations", integer),
            "Krylov ratio": ("krylov_ratio", ratio),
            "worth in elastic solves": ("equivalents", ratio),
            "certificate": ("certificate", tiny),
            "memory [B/unknown]": ("bytes_per_unknown", whole),
        }
        name = "size: unknowns"
        lines += table_of(entries, name, size_words, columns)
        columns = {
            "set-up [s]": ("setup_s", seconds),
            "contact solve [s]": ("contact_solve_s", seconds),
            "elastic solve [s]": ("elastic_solve_s", seconds),
            "whole run [s]": ("whole_s", seconds),
        }
        if ranks > 1:
            columns["efficiency"] = ("efficiency", ratio)
            columns["force, difference"] = ("force_difference", tiny)
        lines += table_of(entries, name, size_words, columns)
    return lines


def size_words(entry):
    """A size and its unknowns."""
    return f"{entry['size']}: {entry['unknowns']:,}"


def growth(result):
    """Exponents and flatness."""
    header = ["", "time of the contact solve ∝ n^p, p"]
    header += ["whole run, p", "Krylov ratio", "worth in elastic solves", "from", "to"]
    lines = []
    for ranks in result.ranks:
        unknowns = [e["unknowns"] for e in result.solved(ranks, *FLAT_RANGE)]
        line = [plural(ranks, "rank")]
        line += [
            plain(result.exponent(ranks, name), ".3f")
            for name in ("contact_solve_s", "whole_s")
        ]
        for name in ("krylov_ratio", "equivalents"):
            value = result.flatness(ranks, name)
            line.append("–" if value is None else f"±{100 * value:.0f} %")
        line += [
            integer(figures.smallest(unknowns)),
            integer(figures.largest(unknowns)),
        ]
        lines.append(line)
    return markdown_table(header, lines)


def friction(result):
    """Coefficients of friction."""
    lines = []
    entries = result.of_part("friction")
    for size in dict.fromkeys(entry["size"] for entry in entries):
        of_size = [entry for entry in entries if entry["size"] == size]
        lines += table_of(
            of_size,
            size_words(of_size[0]),
            lambda entry: entry["variant"],
            {
                "Newton steps": ("newton_steps", integer),
                "Krylov": ("krylov_iterations", integer),
                "on coarser meshes": ("coarse_krylov_iterations", integer),
                "worth in elastic solves": ("equivalents", ratio),
                "fallbacks": ("fallbacks", integer),
                "certificate": ("certificate", tiny),
            },
        )
    return lines


def units(result):
    """Other units."""
    words = {True: "yes", False: "no", None: "–"}
    header = ["", "Newton/Krylov on each mesh", "the same", "certificate"]
    lines = []
    for entry in result.of_part("units"):
        line = [entry["variant"], ending(entry) or entry["steps_of_levels"]]
        line += [words[result.same_steps(entry)], tiny(entry["certificate"])]
        lines.append(line)
    return markdown_table(header, lines)


def row6(result, yardstick):
    """Row k = 6."""
    columns = {
        "unknowns": ("dofs", integer),
        "Newton steps": ("newton_steps", integer),
        "whole run [s]": ("whole_s", seconds),
        "elastic solve [s]": ("elastic_solve_s", seconds),
        "certificate": ("certificate", tiny),
    }
    entries = result.of_part("row6")
    lines = table_of(entries, "k = 6", lambda entry: entry["variant"], columns)
    theirs = result.getfem_seconds(yardstick)
    lines += [f"GetFEM: {GETFEM_SOURCE}."]
    if yardstick is None:
        lines[-1] += (
            " Taken as it is: how long our elastic solve takes on that machine is "
            "unknown (`--getfem-yardstick SECONDS` tells it; GetFEM's time is then "
            "multiplied by the ratio of the two machines' elastic solves)."
        )
    else:
        lines[-1] += (
            f" Scaled by the elastic solve of this problem, {yardstick:g} s there: "
            f"{theirs:.3g} s here."
        )
    primal, dual = (result.row6(name) for name in ("whole run", "Method = newton"))
    if primal and dual:
        difference = figures.relative_difference(
            *([entry[f"force_{axis}"] for axis in "xyz"] for entry in (primal, dual))
        ) if solved(primal) and solved(dual) else None
        lines[-1] += (
            " The force on the body differs from that of Method = newton by "
            f"{tiny(difference)} (relative)."
        )
    return lines + [""]


def memory_bound(result):
    """Two ranks beside what the memory allows."""
    lines = []
    header = ["", "one", "two at once", "gain"]
    entry = result.near(2, MILLION)
    one = result.near(1, MILLION)
    if entry and one and entry["size"] == one["size"]:
        name = f"contact solve at {entry['unknowns']:,} unknowns [s]"
        line = [name, seconds(one["contact_solve_s"])]
        lines.append(line + [seconds(entry["contact_solve_s"]), ratio(entry["gain"])])
    if result.memory:
        line = ["a = b + c, processes of their own [GB/s]"]
        line += [ratio(result.memory[k] / 1e9) for k in ("alone", "together")]
        lines.append(line + [ratio(result.memory_gain())])
    if not lines:
        return ["Not measured.", ""]
    return markdown_table(header, lines)


def reference(result):
    """The elastic solve beside FEEvaluation's."""
    theirs = result.reference
    if not theirs:
        return ["Not measured.", ""]
    if theirs["status"] != runs.CERTIFIED:
        said = theirs["message"] or theirs["status"]
        return [f"Not measured: {said}", ""]
    ours = result.reference_entry() or {}
    header = ["", "ours", "FEEvaluation", "ratio"]
    where = f"{theirs['dofs']:,} unknowns, {plural(theirs['ranks'], 'rank')}"
    memory = ours.get("memory_MB")
    lines = [
        [
            f"elastic solve without set-up [s], {where}",
            seconds(ours.get("elastic_iteration_s")),
            seconds(theirs["solve_seconds"]),
            ratio(result.reference_ratio()),
        ],
        [
            "iterations",
            integer(ours.get("elastic_solve_iterations")),
            integer(theirs["iterations"]),
            "",
        ],
        [
            "elastic solve with set-up [s]",
            seconds(ours.get("elastic_solve_s")),
            seconds(theirs["setup_seconds"] + theirs["solve_seconds"]),
            ratio(
                figures.ratio(
                    theirs["setup_seconds"] + theirs["solve_seconds"],
                    ours.get("elastic_solve_s"),
                )
            ),
        ],
        [
            "memory of the run [MB]",
            whole(memory),
            whole(theirs["peak_memory_MB"]),
            ratio(figures.ratio(theirs["peak_memory_MB"], memory)),
        ],
    ]
    return markdown_table(header, lines) + [
        "FEEvaluation's set-up is its mesh and everything else, ours is what "
        "follows the mesh and the loads.",
        "",
    ]


def model(result, network, per_rank):
    """More ranks than there are here."""
    solver = result.model()
    if solver is None:
        return ["No run on one rank was measured that the model could start from.", ""]
    lines = [
        "A model, not a measurement: a rank holds a cube of the mesh with "
        f"{per_rank:.3g} unknowns, nothing overlaps.",
        "",
        f"- Measured here at {solver.unknowns:,} unknowns on one rank: "
        f"{1e6 * solver.seconds_per_unknown:.3g} µs an unknown for the contact solve, "
        f"{solver.krylov_iterations:g} Krylov iterations on the finest mesh in "
        f"{solver.newton_steps:g} Newton steps, {solver.coarse_iterations:.3g} on each "
        f"coarser one, growing like unknowns^{solver.growth:.3f}; "
        f"{solver.contact_factor:.3g}·unknowns^(2/3) contact nodes.",
        f"- Counted: {solver.products:g} products and {solver.transfers:g} transfers "
        "a cycle and level with the surface of the cube in float, "
        f"{solver.outer_products:g} product in double, {solver.sums:g} sums of a few "
        f"numbers, {solver.contact_sums:g} sums over all ranks of vectors of all "
        f"contact unknowns, about {solver.contact_passes:g} passes over such vectors "
        "in memory by every rank and "
        f"{weak_scaling.ORTHOGONALIZATION_PASSES} more for each direction that a new "
        "one is made orthogonal to.",
        f"- Assumed: {1e6 * network.latency:g} µs a message to at most "
        f"{weak_scaling.NEIGHBOURS} neighbours, {network.bandwidth / 1e9:g} GB/s a "
        f"rank, {1e6 * solver.coarse_seconds:g} µs for the coarsest mesh; "
        f"{network.memory_bandwidth / 1e9:.3g} GB/s of memory a rank"
        + (" (measured here)" if result.memory else "")
        + "; arithmetic on a rank among many as fast as on one alone.",
        "",
    ]
    two = result.near(2, solver.unknowns)
    if two and two["efficiency"] is not None:
        lines[-1:] = [
            "- That last assumption is kind where ranks share their memory: two "
            f"ranks here have an efficiency of {two['efficiency']:.2f} at "
            f"{two['unknowns']:,} unknowns.",
            "",
        ]
    rows = weak_scaling.table(solver, network, per_rank, MODEL_SIZES)
    distributed = weak_scaling.table(
        weak_scaling.without_contact(solver), network, per_rank, MODEL_SIZES
    )
    header = ["unknowns", "ranks", "contact solve [s]", "efficiency"]
    header += [f"{name} [%]" for name in SHARE_NAMES.values()]
    header += ["efficiency if contact vectors were distributed"]
    table = []
    for row, other in zip(rows, distributed):
        line = [f"{row['unknowns']:.3g}", integer(row["ranks"])]
        line += [seconds(row["total"]), ratio(row["efficiency"])]
        line += [f"{100 * row[name] / row['total']:.1f}" for name in SHARE_NAMES]
        table.append(line + [ratio(other["efficiency"])])
    lines += markdown_table(header, table)
    limit = weak_scaling.contact_limit(solver, network, per_rank)
    words = "is not reached by any size that makes sense"
    if limit:
        words = f"is at {limit:.2g} unknowns on {limit / per_rank:.2g} ranks"
    lines += [
        "The contact vectors are the known limit: every rank holds all of them, so "
        "what is sent and done with them does not shrink with more ranks. The size "
        f"from which they cost as much as all the rest {words}.",
        "",
    ]
    return lines


def failures(result):
    """What was not solved, in the program's words."""
    lines = []
    for entry in result.entries.values():
        if solved(entry):
            continue
        words = [entry["part"], entry["size"], entry["variant"]]
        name = ", ".join(word for word in words if word)
        said = entry["message"] or (
            f"over {entry['limit_s']:g} s" if entry["status"] == runs.LIMIT else ""
        )
        on = plural(entry["ranks"], "rank")
        lines.append(f"- {name}, {on}: {entry['status']}. {said}")
    return (lines or ["Everything that was asked for was solved."]) + [""]


def busy(rows):
    """Whether the machine was ours, in words."""
    known = [row["others"] for row in rows if row.get("others") is not None]
    if not known:
        return "unknown"
    return f"{sum(known) / len(known):.1f} on average, at most {max(known):.1f}"


def write_markdown(result, options, rows, plots, path):
    """The report. rows: stored runs; plots: of scaling_plots.draw_all()."""
    newest = max(rows, key=lambda row: row["date"])
    lines = ["# Newton's method in displacements: how it scales", ""]
    lines += [f"- {name}: {text}" for name, text in newest["machine"].items()]
    lines += [f"- date: {newest['date']}", f"- program: {newest['program']}"]
    lines += [f"- other processes running when a run began: {busy(rows)}"]
    lines += [f"- command: `{newest['command']}`", "", "## Criteria", ""]
    lines += criteria(result.checks(options.getfem_yardstick))
    lines += ["## All sizes", ""]
    lines += [
        "The reference brick with Coulomb friction (`parameters/brick.prm`), cells "
        "along its edges and how often they are refined. The Krylov ratio is that of "
        "the iterations on the finest mesh to those of one elastic solve; the worth "
        "is the time of the contact solve, set-up and coarser meshes with it, in "
        "times of one elastic solve with its own set-up. Times are the shortest of "
        f"{plural(options.repeat, 'run')} (of one above "
        f"{options.repeat_up_to:.2g} unknowns); the whole run is without the "
        "elastic solves. Memory is the peak of all ranks together. "
        "† not certified; *no memory*: refused, last section but one.",
        "",
        *sizes(result),
        "## Growth",
        "",
        "Least squares in logarithms, and the narrowest band c·(1 ± d), over "
        f"{FLAT_RANGE[0]:g} to {FLAT_RANGE[1]:g} unknowns.",
        "",
        *growth(result),
    ]
    lines += ["## Friction", "", *friction(result), "## Units", "", *units(result)]
    lines += ["## Row k = 6 of the paper's table", ""]
    lines += row6(result, options.getfem_yardstick)
    lines += ["## Two ranks and the memory", "", *memory_bound(result)]
    lines += ["## The elastic solve beside FEEvaluation's", "", *reference(result)]
    lines += ["## Beyond this machine", ""]
    lines += model(result, options.network(result.memory), options.unknowns_per_rank)
    if plots:
        lines += ["## Plots", ""]
        for name, caption in plots:
            lines += [caption, "", f"![{caption}]({name})", ""]
    lines += ["## What is missing above, and why", "", *failures(result)]
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(lines))
