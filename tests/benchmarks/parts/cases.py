"""What the benchmark of the paper's Table 1 runs: methods, readings, cases."""

from dataclasses import dataclass

from .figures import short

GAUSS_SEIDEL = "Contact solver/Method=gauss seidel"


@dataclass(frozen=True)
class Method:
    """A column of the tables and the settings that choose it."""

    name: str
    what: str
    laws: tuple
    settings: tuple
    # 'disc' solves the problem itself, 'polygon' one with polygons for the
    # discs, 'yardstick' only measures what the others are compared with.
    kind: str = "disc"


BOTH = ("given", "coulomb")
GIVEN = ("given",)
COULOMB = ("coulomb",)


def _squares(number):
    return Method(
        f"ALG_{number}",
        f"the circle replaced by {number} squares",
        GIVEN,
        ("Contact solver/Method=squares", f"Contact solver/Squares={number}"),
        "polygon",
    )


def _qpq(version, disc_solver):
    return Method(
        f"QPQ_{version}",
        f"ALG_GS with ALGORITHM QPQ {disc_solver}",
        GIVEN,
        (GAUSS_SEIDEL, f"Contact solver/Disc solver={disc_solver}"),
    )


METHODS = (
    Method("ALG_GS", "the paper's Gauss-Seidel", BOTH, (GAUSS_SEIDEL,)),
    _squares(2),
    _squares(4),
    _squares(8),
    _qpq("V0", "as printed"),
    _qpq("V1", "with expansion"),
    _qpq("V2", "with proportioning"),
    _qpq("V4", "robust"),
    Method(
        "GS_fixed_point",
        "ALG_GS in an outer fixed point",
        COULOMB,
        (GAUSS_SEIDEL, "Contact solver/Coulomb iteration=fixed point"),
    ),
    Method(
        "MPGP",
        "proportioning on all constraints at once",
        BOTH,
        ("Contact solver/Method=mpgp",),
    ),
    Method(
        "Newton", "semismooth Newton", BOTH, ("Contact solver/Method=newton",)
    ),
    Method("ADMM", "ADMM", BOTH, ("Contact solver/Method=admm",)),
    # A run of its own: what it measures would count as time of Newton.
    Method(
        "Newton_measured",
        "Newton again, which also times both factorisations",
        BOTH,
        (
            "Contact solver/Method=newton",
            "Performance/Measure factorizations=true",
        ),
        "yardstick",
    ),
)
METHOD = {method.name: method for method in METHODS}

# The first of these that is certified says what the force should be.
REFERENCE_METHODS = ("Newton", "ALG_GS", "MPGP", "ADMM")

READINGS = {"A": "nodes", "B": "unknowns"}
LAWS = {"given": "given_friction", "coulomb": "coulomb"}

LEVELS = (1, 2, 3, 4, 5, 6)
PAPER_SECONDS = {
    "ALG_GS": (1, 2, 18, 25, 60, 148),
    "ALG_2": (1, 15, 101, 486, 1542, 5004),
    "ALG_4": (3, 61, 548, 2114, 7724, 20534),
}


def table_n(k):
    """n of row k: nodes in reading A, unknowns in reading B."""
    return (6 * k + 3) * (6 * k + 1) * (2 * k + 1)


def table_m(k):
    """m of row k: contact nodes in reading A, dual unknowns in reading B."""
    return 6 * k * (6 * k + 3)


@dataclass(frozen=True)
class Case:
    """One run of the program."""

    k: int
    reading: str
    law: str
    method: str

    @property
    def series(self):
        """What this case has in common with those of other k."""
        return (self.reading, self.law, self.method)

    @property
    def label(self):
        """A name for files and lines."""
        return f"k{self.k}_{self.reading}_{self.law}_{self.method}"

    @property
    def parameter_file(self):
        """The shipped parameter file, from the root of the project."""
        name = f"{READINGS[self.reading]}_{LAWS[self.law]}.prm"
        return f"parameters/table_1/{name}"

    def settings(self, tolerance):
        """All that is set on the command line, as 'Section/Entry=value'."""
        return [
            f"Geometry/Table 1 level={self.k}",
            f"Contact solver/Tolerance={short(tolerance)}",
            *METHOD[self.method].settings,
        ]


def all_cases(levels, readings, laws, methods):
    """The cases of a choice, small ones first.

    So an interrupted benchmark has complete rows of the small k, and it is
    known which methods were too slow before the larger k begin.
    """
    return [
        Case(k, reading, law, method.name)
        for k in sorted(levels)
        for reading in readings
        for law in laws
        for method in METHODS
        if method.name in methods and law in method.laws
    ]
