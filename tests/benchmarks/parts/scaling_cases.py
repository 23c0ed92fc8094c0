"""What the benchmark of 'newton multigrid' runs: sizes, parts, cases."""

import re
from dataclasses import dataclass

from .errors import BenchmarkError
from .figures import short

PARAMETER_FILE = "parameters/brick.prm"
METHOD = "Contact solver/Method=newton multigrid"
YARDSTICK = "Performance/Measure one elastic solve=true"
MAX_REFINEMENT = 9

PARTS = {
    "sizes": "all sizes on all numbers of ranks",
    "friction": "coefficients of friction from 0 to large ones",
    "units": "other units of stress and of length",
    "row6": "row k = 6 of the paper's table, with Method = newton beside it",
    "stream": "bandwidth of the memory for one and for two processes",
    "reference": "the elastic solve by deal.II's FEEvaluation",
}
FRICTION = (0.0, 0.1, 0.3, 0.6, 1.0, 2.0, 5.0)
REFERENCE_RANKS = 2
REFERENCE_MAX_REFINEMENT = 6


@dataclass(frozen=True)
class Size:
    """The reference brick in so many cells along x, y, z, so often refined."""

    subdivisions: tuple
    refinement: int

    @property
    def name(self):
        """As on the command line."""
        return "x".join(str(n) for n in self.subdivisions) + f"r{self.refinement}"

    @property
    def unknowns(self):
        """Of the displacement, with those that are prescribed."""
        number = 3
        for cells in self.subdivisions:
            number *= cells * 2**self.refinement + 1
        return number

    @property
    def settings(self):
        """That choose the mesh."""
        subdivisions = ",".join(str(n) for n in self.subdivisions)
        return (
            "Geometry/Table 1 level=0",
            "Geometry/Lengths=4,3,1",
            f"Geometry/Subdivisions={subdivisions}",
            f"Geometry/Global refinement={self.refinement}",
        )


BRICK = (4, 3, 1)  # cubes
SIZES = [
    Size(subdivisions, refinement)
    for subdivisions in (BRICK, (6, 4, 1), (8, 5, 1))
    for refinement in (3, 4, 5, 6)
]


def parse_sizes(text):
    """Names such as 4x3x1r5, the smallest first."""
    sizes = set()
    for part in text.split(","):
        found = re.fullmatch(r"(\d{1,3})x(\d{1,3})x(\d{1,3})r(\d)", part.strip())
        numbers = [int(number) for number in found.groups()] if found else [0]
        if min(numbers[:3]) == 0:
            raise BenchmarkError(
                f"--sizes {text}: '{part}' is no size such as 4x3x1r5, cells "
                f"along x, y and z and refinements, of which there are at most "
                f"{MAX_REFINEMENT}"
            )
        sizes.add(Size(tuple(numbers[:3]), numbers[3]))
    return sorted(sizes, key=lambda size: size.unknowns)


def choose_sizes(text, max_unknowns):
    """All sizes, or those of a list, up to so many unknowns."""
    sizes = parse_sizes(text or ",".join(size.name for size in SIZES))
    return [size for size in sizes if size.unknowns <= max_unknowns]


@dataclass(frozen=True)
class Case:
    """One run of the program."""

    part: str
    variant: str  # in words, apart from size, ranks and repetition
    ranks: int
    chosen: tuple  # 'Section/Entry=value'
    size: Size = None
    repetition: int = 0

    parameter_file = PARAMETER_FILE

    @property
    def group(self):
        """What repetitions of the same run have in common."""
        return (self.part, self.variant, self.size, self.ranks)

    @property
    def series(self):
        """What larger sizes have in common."""
        return (self.part, self.variant, self.ranks)

    @property
    def words(self):
        """For people."""
        words = [self.part]
        if self.size:
            words.append(self.size.name)
        if self.variant:
            words.append(self.variant)
        words.append("1 rank" if self.ranks == 1 else f"{self.ranks} ranks")
        if self.repetition:
            words.append(f"again ({self.repetition})")
        return ", ".join(words)

    @property
    def label(self):
        """For names of files."""
        return re.sub(r"[^A-Za-z0-9.=-]+", "_", self.words)

    def settings(self, tolerance):
        """All that is set on the command line."""
        mesh = self.size.settings if self.size else ()
        return [f"Contact solver/Tolerance={short(tolerance)}", *mesh, *self.chosen]


MEASURED = (METHOD, YARDSTICK, "Output/Write solution=false")


def size_cases(sizes, ranks, repeat, repeat_up_to):
    """Small ones first, so that it is known what takes too long."""
    return [
        Case("sizes", "", number, MEASURED, size, repetition)
        for size in sizes
        for number in ranks
        for repetition in range(repeat if size.unknowns <= repeat_up_to else 1)
    ]


def friction_cases(sizes, coefficients):
    """Coefficients of friction on one rank."""
    return [
        Case(
            "friction",
            f"F = {coefficient:g}",
            1,
            (*MEASURED, f"Friction/Coefficient={coefficient:g}"),
            size,
        )
        for size in sizes
        for coefficient in coefficients
    ]


def traction(scale, border):
    """The loads of the brick in other units: on the top beyond y = border, and
    on the face y = 3 m."""

    def force(newtons):
        return repr(newtons * scale)

    return (
        f"Boundary conditions/Traction=5 : 0; 0; if(y > {border}, {force(-1e8)}, 0)"
        f" | 3 : {force(1e7)}; {force(2e7)}; {force(2e7)}"
    )


def unit_cases(refinement=3, modulus=2.119e11):
    """The same problem in other units, which must take the same steps."""
    size = Size(BRICK, refinement)
    cases = []
    for name, stress, length in (
        ("as shipped", 1.0, 1),
        ("stresses times 1e-6", 1e-6, 1),
        ("stresses times 1e6", 1e6, 1),
        ("millimetres and MPa", 1e-6, 1000),
    ):
        chosen = (
            *MEASURED,
            f"Material/Young's modulus={modulus * stress!r}",
            traction(stress, 1.5 * length),
            "Geometry/Lengths=" + ",".join(str(n * length) for n in BRICK),
        )
        cases.append(Case("units", name, 1, chosen, size))
    return cases


ROW_6 = ("Geometry/Table 1 level=6",)
ROW_6_CASES = (
    Case("row6", "whole run", 1, (*ROW_6, METHOD)),
    Case("row6", "with the yardstick", 1, (*ROW_6, METHOD, YARDSTICK)),
    Case("row6", "Method = newton", 1, (*ROW_6, "Contact solver/Method=newton")),
)
