"""How long 'newton multigrid' takes on more ranks than there are here: a model.

A rank holds a cube of the mesh. Times of arithmetic and numbers of iterations
are measured on this machine; what is sent is counted from the algorithm; how
fast it is sent is assumed. Nothing overlaps.
"""

import math
from dataclasses import dataclass, replace

COMPONENTS = 3
DOUBLE = 8
FLOAT = 4
REFINEMENT = 8  # cells of a refined cell
NEIGHBOURS = 26  # of a cube

# Three vectors of the contact nodes follow each direction; taking an older
# one's part away from one of them reads two and writes one.
ORTHOGONALIZATION_PASSES = 9

# What one rank needs for a contact problem, in the order of the tables.
SHARES = ("compute", "ghosts", "sums", "contact_sums", "contact_work", "coarse")


@dataclass(frozen=True)
class Network:
    """What is assumed of the machine."""

    latency: float = 2e-6  # of a message, s
    bandwidth: float = 10e9  # of a rank's network, bytes/s
    memory_bandwidth: float = 10e9  # of a rank's memory, bytes/s


@dataclass(frozen=True)
class Solver:
    """What is measured of the solver, and what is counted from it."""

    # measured
    seconds_per_unknown: float  # of the whole contact solve on one rank
    unknowns: float  # at which it was measured, and what follows
    n_levels: int  # meshes of that run
    krylov_iterations: float  # on the finest mesh
    coarse_iterations: float = 0.0  # on each coarser mesh, the mean
    growth: float = 0.0  # of iterations: like unknowns to this power
    contact_factor: float = 1.1  # contact nodes are this times unknowns^(2/3)
    newton_steps: float = 5.0  # on the finest mesh
    coarsest_unknowns: float = 120.0
    # counted
    products: float = 4.0  # with K in float, a cycle and level
    transfers: float = 2.0  # between levels, a cycle and level
    outer_products: float = 1.0  # with K in double, an iteration
    sums: float = 3.0  # over all ranks, of some numbers, an iteration
    contact_sums: float = 4.0  # the same of vectors of all contact unknowns
    contact_passes: float = 30.0  # over such vectors in memory, an iteration
    # assumed
    coarse_seconds: float = 2e-5  # for the coarsest level, a cycle

    def levels(self, unknowns):
        """How many meshes there are, from the finest to the coarsest."""
        finer = math.log(unknowns / self.unknowns, REFINEMENT)
        return max(self.n_levels + round(finer), 1)

    def more_iterations(self, unknowns):
        """How many times as many iterations as in the measured run."""
        return (unknowns / self.unknowns) ** self.growth

    def contact_unknowns(self, unknowns):
        """Of a mesh with that many unknowns."""
        return COMPONENTS * self.contact_factor * unknowns ** (2 / 3)


def surface_unknowns(unknowns):
    """On the surface of a cube of that many unknowns; at most all of them."""
    surface = COMPONENTS * 6 * (unknowns / COMPONENTS) ** (2 / 3)
    return min(surface, unknowns)


def exchange(network, numbers, size, ranks):
    """Seconds to get numbers of that size from all neighbours."""
    messages = min(NEIGHBOURS, ranks - 1)
    if messages == 0:
        return 0.0
    return messages * network.latency + numbers * size / network.bandwidth


def sum_over_ranks(network, numbers, ranks):
    """Seconds to add up vectors of doubles: a tree of messages, and each byte
    sent and received once, as in a reduction and a gathering."""
    if ranks == 1:
        return 0.0
    rounds = math.log2(ranks)
    volume = 2 * numbers * DOUBLE * (1 - 1 / ranks)
    return rounds * network.latency + volume / network.bandwidth


def cycle_exchange(solver, network, unknowns, ranks, levels):
    """Seconds that one cycle over that many levels spends on its neighbours.

    unknowns: of a rank on the finest of these levels.
    """
    seconds = 0.0
    exchanges = solver.products + solver.transfers
    for depth in range(levels - 1):  # the coarsest one is solved
        surface = surface_unknowns(unknowns / REFINEMENT**depth)
        seconds += exchanges * exchange(network, surface, FLOAT, ranks)
    return seconds


def iteration(solver, network, unknowns, ranks, levels, kept):
    """Seconds of one Krylov iteration without its arithmetic, by share.

    unknowns: of a rank on the mesh on which it is done; kept: directions that
    the new one is made orthogonal to.
    """
    ghosts = cycle_exchange(solver, network, unknowns, ranks, levels)
    ghosts += solver.outer_products * exchange(
        network, surface_unknowns(unknowns), DOUBLE, ranks
    )
    contact = solver.contact_unknowns(unknowns * ranks)
    # What every rank does with these vectors, and one rank does not do
    # besides: its own part is in the measured time.
    repeated = 1 - 1 / ranks
    passes = solver.contact_passes + ORTHOGONALIZATION_PASSES * kept
    coarse = 0.0
    if ranks > 1:
        coarse = solver.coarse_seconds
        coarse += sum_over_ranks(network, solver.coarsest_unknowns, ranks)
    return {
        "ghosts": ghosts,
        "sums": sum_over_ranks(network, kept + 4, ranks)
        + (solver.sums - 1) * sum_over_ranks(network, 2, ranks),
        "contact_sums": solver.contact_sums * sum_over_ranks(network, contact, ranks),
        "contact_work": repeated
        * passes
        * contact
        * DOUBLE
        / network.memory_bandwidth,
        "coarse": coarse,
    }


def predict(solver, network, unknowns_per_rank, ranks):
    """Seconds of the contact solve: those of SHARES and their 'total'."""
    unknowns = unknowns_per_rank * ranks
    more = solver.more_iterations(unknowns)
    shares = dict.fromkeys(SHARES, 0.0)
    shares["compute"] = solver.seconds_per_unknown * unknowns_per_rank * more
    kept = solver.krylov_iterations * more / max(solver.newton_steps, 1.0) / 2
    levels = solver.levels(unknowns)
    for depth in range(levels):
        number = solver.coarse_iterations if depth else solver.krylov_iterations
        of_one = iteration(
            solver,
            network,
            unknowns_per_rank / REFINEMENT**depth,
            ranks,
            levels - depth,
            kept,
        )
        for name, seconds in of_one.items():
            shares[name] += number * more * seconds
    shares["total"] = sum(shares.values())
    return shares


def table(solver, network, unknowns_per_rank, sizes):
    """A dict for each size: unknowns, ranks, seconds by share, efficiency."""
    alone = predict(solver, network, unknowns_per_rank, 1)["total"]
    rows = []
    for size in sizes:
        ranks = max(round(size / unknowns_per_rank), 1)
        seconds = predict(solver, network, unknowns_per_rank, ranks)
        rows.append(
            {
                "unknowns": ranks * unknowns_per_rank,
                "ranks": ranks,
                "efficiency": alone / seconds["total"],
                **seconds,
            }
        )
    return rows


def contact_seconds(seconds):
    """Of what does not shrink with more ranks: the replicated vectors."""
    return seconds["contact_sums"] + seconds["contact_work"]


def contact_limit(solver, network, unknowns_per_rank, largest=1e9):
    """Unknowns from which the replicated contact vectors cost more than all
    the rest; None if that is not so on this many ranks."""

    def too_much(ranks):
        seconds = predict(solver, network, unknowns_per_rank, ranks)
        return 2 * contact_seconds(seconds) >= seconds["total"]

    low, high = 1.0, float(largest)
    if not too_much(high):
        return None
    while high > 1.01 * low:
        middle = math.sqrt(low * high)
        low, high = (low, middle) if too_much(middle) else (middle, high)
    return high * unknowns_per_rank


def without_contact(solver):
    """The same solver if it kept its contact vectors distributed."""
    return replace(solver, contact_sums=0.0, contact_passes=0.0, contact_factor=0.0)
