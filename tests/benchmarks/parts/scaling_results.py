"""The figures of all runs of the scaling benchmark, and what follows of them."""

from dataclasses import dataclass

from . import figures, runs, weak_scaling
from .scaling_cases import BRICK, FRICTION, REFERENCE_RANKS
from .scaling_cases import Size

SKIPPED = "skipped"
NO_MEMORY = "no memory"

# Names in scaling.csv and where the figure stands in summary.json.
TIMES = {
    "mesh_s": "seconds/mesh",
    "assembly_s": "seconds/assembly",
    "setup_s": "seconds/stiffness_setup",
    "iteration_s": "seconds/displacement_iteration",
    "contact_solve_s": "seconds/contact_solve",
    "elastic_solve_s": "seconds/elastic_solve",
    "elastic_iteration_s": "seconds/elastic_solve_iteration",
    "output_s": "seconds/output",
    "total_s": "seconds/total",
}
COUNTS = {
    "dofs": "problem/dofs",
    "contact_nodes": "problem/contact_nodes",
    "newton_steps": "solver/newton_steps",
    "krylov_iterations": "solver/krylov_iterations",
    "coarse_krylov_iterations": "solver/coarse_krylov_iterations",
    "elastic_solve_iterations": "solver/elastic_solve_iterations",
    "fallbacks": "solver/fallbacks",
    "converged": "converged",
}
COLUMNS = (
    ["part", "variant", "size", "unknowns", "ranks", "repetitions", "status"]
    + list(COUNTS)
    + ["levels", "steps_of_levels", "krylov_ratio", "equivalents"]
    + list(TIMES)
    + ["whole_s", "memory_MB", "bytes_per_unknown", "gain", "efficiency"]
    + ["certificate", "force_x", "force_y", "force_z", "force_difference"]
    + ["others", "date", "program", "message"]
)
# Figures of the certificate that inform, the others decide.
INFORMING = ("slip_angle", "duality_gap")

# The yardstick is timed twice, and the better one counts.
YARDSTICKS = 2

MILLION = 1.2e6
TEN_MILLION = 1e7
NEARBY = 1.25  # a size this factor away is taken for the one that is asked for
FLAT_RANGE = (5e4, 1e7)
REFERENCE = "4x3x1"  # the cells of the reference brick are cubes
# Rows of the paper's table, whole run on one thread.
GETFEM_SECONDS = 50.0
GETFEM_SOURCE = "measured elsewhere on another machine: 50 s, one thread"

LIMITS = {
    "equivalents": 2.0,
    "krylov_ratio": 1.5,
    "flatness": 0.2,
    "newton_steps": 12,
    "row6": 0.1,  # of GetFEM's time
    "reference": 4.0,
    "exponent": 1.05,
    "bytes": 1000.0,
    "gain": 1.6,
    "stream": 0.9,  # of the memory's gain
    "force": 1e-8,
}


def certificate(summary):
    """The largest figure that decides."""
    entries = figures.look_up(summary, "certificate") or {}
    return figures.largest(
        value for name, value in entries.items() if name not in INFORMING
    )


def status(row):
    """As it is told: a refusal for lack of memory is no error."""
    if row["status"] == runs.ERROR and " of memory" in row["message"]:
        return NO_MEMORY
    return row["status"]


def whole_run(times):
    """Seconds without the yardstick; None if there are none."""
    if times["total_s"] is None:
        return None
    return times["total_s"] - YARDSTICKS * (times["elastic_solve_s"] or 0.0)


def entry_of(case, rows):
    """The flat entry of a case from the stored runs of its repetitions.

    Times are the shortest of them, each on its own. The worst end counts.
    """
    worst = next((row for row in rows if status(row) != runs.CERTIFIED), rows[0])
    summary = worst["summary"]
    entry = {
        "part": case.part,
        "variant": case.variant,
        "size": case.size.name if case.size else "",
        "unknowns": case.size.unknowns if case.size else None,
        "ranks": case.ranks,
        "repetitions": len(rows),
        "status": status(worst),
        "date": worst["date"],
        "program": worst["program"],
        "message": worst["message"],
        "limit_s": worst["limit"],
        "others": figures.largest(row.get("others") for row in rows),
    }
    entry.update({n: figures.look_up(summary, path) for n, path in COUNTS.items()})
    levels = figures.look_up(summary, "solver/levels") or []
    entry["coarsest_dofs"] = levels[0]["dofs"] if levels else None
    entry["levels"] = len(levels) or None
    entry["steps_of_levels"] = " ".join(
        f"{level['newton_steps']}/{level['krylov_iterations']}" for level in levels
    )
    for name, path in TIMES.items():
        entry[name] = figures.smallest(
            figures.look_up(row["summary"], path) for row in rows
        )
    entry["whole_s"] = figures.smallest(
        whole_run({n: figures.look_up(row["summary"], p) for n, p in TIMES.items()})
        for row in rows
    )
    entry["krylov_ratio"] = figures.ratio(
        entry["krylov_iterations"], entry["elastic_solve_iterations"]
    )
    entry["equivalents"] = figures.ratio(
        entry["contact_solve_s"], entry["elastic_solve_s"]
    )
    entry["memory_MB"] = figures.look_up(summary, "peak_memory_MB")
    memory = entry["memory_MB"]
    entry["bytes_per_unknown"] = figures.ratio(
        None if memory is None else memory * 2**20, entry["dofs"]
    )
    entry["certificate"] = certificate(summary)
    force = figures.look_up(summary, "contact/force_on_body")
    entry.update(zip(("force_x", "force_y", "force_z"), force or (None,) * 3))
    entry["gain"] = entry["efficiency"] = entry["force_difference"] = None
    return entry


def force(entry):
    """On the body; None if there is none."""
    values = [entry[f"force_{axis}"] for axis in "xyz"] if entry else [None]
    return None if None in values else values


def is_near(unknowns, target):
    """Whether this size stands for the one that a criterion asks for."""
    return target / NEARBY <= unknowns <= target * NEARBY


@dataclass(frozen=True)
class Check:
    """A criterion: what is asked, what was found, whether it is met."""

    number: str
    asked: str
    found: str
    met: bool  # or None

    @property
    def verdict(self):
        """In words."""
        return {True: "met", False: "not met", None: "not measured"}[self.met]


class Results:
    """All figures.

    rows: {case: stored run}; memory and reference: what was measured of the
    bandwidth and of FEEvaluation, or None.
    """

    def __init__(self, cases, rows, memory=None, reference=None):
        self.memory = memory
        self.reference = reference
        self.ranks = list(dict.fromkeys(c.ranks for c in cases if c.part == "sizes"))
        self.entries = {}
        groups = {}
        for case in cases:
            groups.setdefault(case.group, []).append(case)
        for group, members in groups.items():
            known = [rows[case] for case in members if case in rows]
            if known:
                self.entries[group] = entry_of(members[0], known)
            elif members[0].size:
                self.entries[group] = self._skipped(members[0])
        for entry in self.of_part("sizes"):
            self._compare_with_one_rank(entry)

    @staticmethod
    def _skipped(case):
        entry = dict.fromkeys([*COLUMNS, "limit_s", "coarsest_dofs"])
        entry.update(
            part=case.part,
            variant=case.variant,
            size=case.size.name,
            unknowns=case.size.unknowns,
            ranks=case.ranks,
            status=SKIPPED,
            message="not run, or a smaller size was over the time limit",
        )
        return entry

    def _compare_with_one_rank(self, entry):
        one = self.entries.get(("sizes", "", self._size(entry), 1))
        if one is None:
            return
        entry["gain"] = figures.ratio(one["contact_solve_s"], entry["contact_solve_s"])
        if entry["gain"] is not None:
            entry["efficiency"] = entry["gain"] / entry["ranks"]
        if entry["ranks"] > 1:
            entry["force_difference"] = figures.relative_difference(
                force(entry), force(one)
            )

    def _size(self, entry):
        return next(
            size
            for _, _, size, _ in self.entries
            if size and size.name == entry["size"]
        )

    def of_part(self, part):
        """Its entries, in the order in which they are run."""
        return [entry for entry in self.entries.values() if entry["part"] == part]

    def solved(self, ranks, low=0.0, high=float("inf"), cells=""):
        """Certified runs of the sizes in this range, on so many ranks.

        cells: along x, y, z, before they are refined; all if empty.
        """
        return [
            entry
            for entry in self.of_part("sizes")
            if entry["ranks"] == ranks
            and entry["status"] == runs.CERTIFIED
            and low <= entry["unknowns"] <= high
            and entry["size"].startswith(cells)
        ]

    def near(self, ranks, target):
        """The certified run nearest to so many unknowns; None if none is near."""
        near = [e for e in self.solved(ranks) if is_near(e["unknowns"], target)]
        return min(
            near, key=lambda entry: abs(entry["unknowns"] - target), default=None
        )

    def covers_range(self, ranks, cells=""):
        """Whether a trend from 5e4 to 1e7 unknowns can be told."""
        sizes = [entry["unknowns"] for entry in self.solved(ranks, *FLAT_RANGE, cells)]
        # every refinement of the same cells has eight times the unknowns
        first = (8 if cells else 2) * FLAT_RANGE[0]
        return bool(sizes) and (
            min(sizes) <= first and max(sizes) >= FLAT_RANGE[1] / NEARBY
        )

    def exponent(self, ranks, name="contact_solve_s"):
        """Of its growth with the unknowns over the range; None if unknown."""
        entries = self.solved(ranks, *FLAT_RANGE)
        return figures.growth_exponent(
            [entry["unknowns"] for entry in entries],
            [entry[name] for entry in entries],
        )

    def flatness(self, ranks, name, cells=""):
        """Half the width of the band around it over the range, relative."""
        return figures.flatness(
            entry[name] for entry in self.solved(ranks, *FLAT_RANGE, cells)
        )

    def row6(self, variant):
        """The entry of row k = 6."""
        return self.entries.get(("row6", variant, None, 1))

    # What follows, a method each, of the criteria

    def _limit_at_sizes(self, number, name, words):
        limit = LIMITS[name]
        found, answers = [], []
        for target in (MILLION, TEN_MILLION):
            for ranks in self.ranks:
                entry = self.near(ranks, target)
                value = entry[name] if entry else None
                answers.append(figures.at_most(value, limit))
                if value is not None:
                    on = plural(ranks, "rank")
                    found.append(f"{value:.2f} at {entry['unknowns']:.3g} ({on})")
        asked = f"{words} at most {limit:g} at 1.2e6 and at 1e7 unknowns"
        return Check(number, asked, ", ".join(found), figures.all_true(answers))

    def _flat(self, number, name, words, cells=""):
        found, answers = [], []
        for ranks in self.ranks:
            value = self.flatness(ranks, name, cells)
            met = figures.at_most(value, LIMITS["flatness"])
            if met and not self.covers_range(ranks, cells):
                met = None  # too much stays too much
            answers.append(met)
            if value is not None:
                entries = self.solved(ranks, *FLAT_RANGE, cells)
                sizes = [entry["unknowns"] for entry in entries]
                found.append(
                    f"±{100 * value:.0f} % from {min(sizes):.2g} to {max(sizes):.2g} "
                    f"({plural(ranks, 'rank')})"
                )
        asked = f"{words} flat to ±{100 * LIMITS['flatness']:.0f} % "
        asked += "from 5e4 to 1e7 unknowns, "
        asked += f"{cells} refined" if cells else "all shapes of cells"
        return Check(number, asked, ", ".join(found), figures.all_true(answers))

    def _friction(self):
        entries = self.of_part("friction")
        limit = LIMITS["newton_steps"]
        done = [entry for entry in entries if entry["status"] != SKIPPED]
        good = [
            e["status"] == runs.CERTIFIED and e["newton_steps"] <= limit for e in done
        ]
        met = figures.all_true(good)
        chosen = {entry["variant"] for entry in done}
        if met and not all(f"F = {F:g}" in chosen for F in FRICTION):
            met = None
        found = ""
        if done:
            most = figures.largest(entry["newton_steps"] for entry in done)
            found = f"{sum(good)} of {len(good)} runs, at most {most} steps"
        values = ", ".join(f"{F:g}" for F in FRICTION)
        asked = f"F = {values} certified in at most {limit} Newton steps on the "
        return Check("2", asked + "finest mesh", found, met)

    def getfem_seconds(self, yardstick):
        """GetFEM's time on this machine.

        yardstick: seconds of the elastic solve of row 6 on the machine on
        which GetFEM was measured; None if unknown.
        """
        entry = self.row6("with the yardstick")
        ours = entry["elastic_solve_s"] if entry else None
        if yardstick is None or ours is None:
            return GETFEM_SECONDS
        return GETFEM_SECONDS * ours / yardstick

    def _row6(self, yardstick):
        entry = self.row6("whole run")
        value = entry["total_s"] if entry and solved(entry) else None
        theirs = self.getfem_seconds(yardstick)
        limit = LIMITS["row6"] * theirs
        found = ""
        if value is not None:
            found = f"{value:.2f} s, {100 * value / theirs:.1f} % of {theirs:.3g} s"
            found += " (not scaled)" if yardstick is None else " (scaled)"
        asked = f"k = 6: the whole run in at most 1/{1 / LIMITS['row6']:.0f} of "
        asked += f"GetFEM's {GETFEM_SECONDS:g} s"
        return Check("3", asked, found, figures.at_most(value, limit))

    def reference_entry(self):
        """Our run of the size that FEEvaluation was given."""
        if not self.reference or self.reference["status"] != runs.CERTIFIED:
            return None
        size = Size(BRICK, self.reference["level"])
        entry = self.entries.get(("sizes", "", size, self.reference["ranks"]))
        return entry if entry and solved(entry) else None

    def reference_ratio(self):
        """FEEvaluation's time for an elastic solve to ours, without set-ups."""
        entry = self.reference_entry()
        if entry is None:
            return None
        theirs = self.reference["solve_seconds"]
        return figures.ratio(theirs, entry["elastic_iteration_s"])

    def _reference(self):
        ratio = self.reference_ratio()
        met = figures.at_least(ratio, LIMITS["reference"])
        found = ""
        if ratio is not None:
            dofs, ranks = self.reference["dofs"], self.reference["ranks"]
            found = f"{ratio:.2f} times at {dofs:.3g} ({plural(ranks, 'rank')})"
            if not is_near(dofs, TEN_MILLION) or ranks != REFERENCE_RANKS:
                met = None
        asked = f"elastic solve at least {LIMITS['reference']:g} times as fast as "
        asked += "FEEvaluation's at 1e7 unknowns on two ranks"
        return Check("4", asked, found, met)

    def _exponent(self):
        found, answers = [], []
        for ranks in self.ranks:
            value = self.exponent(ranks)
            met = figures.at_most(value, LIMITS["exponent"])
            answers.append(met if self.covers_range(ranks) else None)
            if value is not None:
                found.append(f"{value:.3f} ({plural(ranks, 'rank')})")
        asked = "time of the contact solve grows at most like unknowns^"
        asked += f"{LIMITS['exponent']} from 5e4 to 1e7"
        return Check("5a", asked, ", ".join(found), figures.all_true(answers))

    def _memory(self):
        entries = [e for r in self.ranks for e in self.solved(r, 1e6)]
        worst = max(entries, key=lambda e: e["bytes_per_unknown"], default=None)
        found, met = "", None
        if worst:
            found = f"at most {worst['bytes_per_unknown']:.0f} B, at "
            found += f"{worst['unknowns']:.3g} ({plural(worst['ranks'], 'rank')})"
            met = worst["bytes_per_unknown"] <= LIMITS["bytes"]
        asked = f"at most {LIMITS['bytes']:g} B of memory an unknown from 1e6 on"
        return Check("5b", asked, found, met)

    def memory_gain(self):
        """What two processes get of the memory to what one gets."""
        if not self.memory:
            return None
        return figures.ratio(self.memory["together"], self.memory["alone"])

    def _gain(self):
        entry = self.near(2, MILLION)
        gain = entry["gain"] if entry else None
        memory = self.memory_gain()
        found, met = "", figures.at_least(gain, LIMITS["gain"])
        if gain is not None:
            found = f"{gain:.2f} times at {entry['unknowns']:.3g}"
            if memory is not None:
                found += f", the memory's {memory:.2f}: {100 * gain / memory:.0f} %"
                met = met or gain >= LIMITS["stream"] * memory
            elif met is False:
                met = None
        asked = f"two ranks at least {LIMITS['gain']:g} times as fast as one at "
        asked += f"1.2e6 unknowns, or {100 * LIMITS['stream']:.0f} % of the gain of "
        return Check("6a", asked + "the memory's bandwidth", found, met)

    def _same_force(self):
        values = [
            entry["force_difference"]
            for entry in self.of_part("sizes")
            if entry["force_difference"] is not None
        ]
        worst = figures.largest(values)
        found = "" if worst is None else f"at most {worst:.1e} ({len(values)} sizes)"
        asked = f"the same force on one and two ranks to {figures.short(LIMITS['force'])}"
        met = figures.at_most(worst, LIMITS["force"])
        return Check("6b", asked, found, met)

    def same_steps(self, entry):
        """Whether it took the steps of the problem as shipped, on all meshes."""
        first = next(iter(self.of_part("units")), None)
        if first is None or not solved(first) or not solved(entry):
            return None
        return entry["steps_of_levels"] == first["steps_of_levels"]

    def _units(self):
        entries = self.of_part("units")
        met = figures.all_true(
            False if entry["status"] == runs.NOT_CERTIFIED else self.same_steps(entry)
            for entry in entries
        )
        steps = sorted({e["steps_of_levels"] for e in entries if e["steps_of_levels"]})
        asked = "in other units the same numbers of steps"
        found = "Newton/Krylov on each mesh: " + " or ".join(steps) if steps else ""
        return Check("7", asked, found, met)

    def checks(self, yardstick=None):
        """All criteria. yardstick: see getfem_seconds()."""
        return [
            self._limit_at_sizes("1a", "equivalents", "worth in elastic solves"),
            self._limit_at_sizes("1b", "krylov_ratio", "Krylov ratio"),
            self._flat("1c", "equivalents", "worth in elastic solves", REFERENCE),
            self._flat("1d", "krylov_ratio", "Krylov ratio", REFERENCE),
            self._flat("1e", "equivalents", "worth in elastic solves"),
            self._flat("1f", "krylov_ratio", "Krylov ratio"),
            self._friction(),
            self._row6(yardstick),
            self._reference(),
            self._exponent(),
            self._memory(),
            self._gain(),
            self._same_force(),
            self._units(),
        ]

    def largest_on_one_rank(self):
        """The certified run that the model starts from; None if there is none."""
        return max(
            self.solved(1), key=lambda entry: entry["unknowns"], default=None
        )

    def model(self):
        """The solver as the model of weak scaling takes it; None if unknown."""
        entry = self.largest_on_one_rank()
        if entry is None or not entry["krylov_iterations"] or not entry["levels"]:
            return None
        growth = self.exponent(1, "krylov_iterations")
        return weak_scaling.Solver(
            seconds_per_unknown=entry["contact_solve_s"] / entry["unknowns"],
            unknowns=entry["unknowns"],
            n_levels=entry["levels"],
            krylov_iterations=entry["krylov_iterations"],
            coarse_iterations=(entry["coarse_krylov_iterations"] or 0)
            / max(entry["levels"] - 1, 1),
            growth=max(growth or 0.0, 0.0),
            contact_factor=entry["contact_nodes"] / entry["unknowns"] ** (2 / 3),
            newton_steps=entry["newton_steps"],
            coarsest_unknowns=entry["coarsest_dofs"],
        )


def solved(entry):
    """Whether it has figures to compare."""
    return entry["status"] == runs.CERTIFIED


def plural(number, word):
    """1 rank, 2 ranks."""
    return f"{number} {word}" + ("" if number == 1 else "s")
