#!/usr/bin/env python3
"""Which folder may include which: the arrows of CONTRIBUTING.md.

A folder includes only itself and those that stand before it in LAYERS, and what
needs no deal.II does not come by it through others either.
"""

import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LAYERS = (  # from the ground up
    "base",
    "base/text",
    "qp/sets",
    "qp/operators",
    "qp/solvers",
    "qp/methods",
    "qp",
    "elasticity/kernels/loops",
    "elasticity/kernels",
    "elasticity/linear_algebra",
    "elasticity/mesh/readers",
    "elasticity/mesh/readers/abaqus",
    "elasticity/mesh",
    "elasticity/model",
    "elasticity/stiffness",
    "elasticity/levels",
    "elasticity/multigrid",
    "elasticity/solvers",
    "contact/obstacles",
    "contact/pairs",
    "contact/interface",
    "contact/dual",
    "contact/primal",
    "contact/certificate",
    "output",
    "output/problem",
    "output/results",
    "output/history",
    "simulation/parameters",
    "simulation/checkpoint",
    "simulation/solvers",
    "simulation/warnings",
    "simulation",
    "",  # main.cc
)
NEVER = (  # beside what the order says
    ("qp", "base/text"),
    ("elasticity", "qp"),
    ("output/problem", "elasticity"),
)
WITHOUT_DEAL_II = ("qp", "elasticity/kernels")
LARGEST = 12  # files of a folder, a source and its header counted once


def is_in(folder, parent):
    """Whether the folder is the parent or one in it."""
    return (folder + "/").startswith(parent + "/")


def read_includes():
    """Path -> list of what it includes, ours by their paths from ROOT."""
    includes = {}
    for top in ("include/stiction", "source"):
        for directory, _, names in os.walk(os.path.join(ROOT, top)):
            for name in names:
                if not name.endswith((".h", ".cc")):
                    continue
                path = os.path.relpath(os.path.join(directory, name), ROOT)
                with open(os.path.join(ROOT, path), encoding="utf-8") as file:
                    found = re.findall(r'^#\s*include\s*(["<])([^">]+)', file.read(), re.M)
                includes[path] = [
                    os.path.normpath(os.path.join(os.path.dirname(path), include))
                    if quote == '"'
                    else re.sub("^stiction/", "include/stiction/", include)
                    for quote, include in found
                ]
    return includes


def folder_of(path):
    """The folder, the same for a source and its header."""
    return os.path.dirname(re.sub("^(include/stiction|source)/", "", path))


def reaches(path, includes, seen):
    """All that is included, straight or through others."""
    for include in includes.get(path, ()):
        if include not in seen:
            seen.add(include)
            reaches(include, includes, seen)
    return seen


def faults():
    """A sentence for each."""
    includes = read_includes()
    rooms = {}
    for path, found in sorted(includes.items()):
        folder = folder_of(path)
        if folder not in LAYERS:
            yield f"{path}: its folder is not in LAYERS"
            continue
        rooms.setdefault(folder, set()).add(os.path.splitext(os.path.basename(path))[0])
        for include in found:
            if include not in includes:
                continue
            other = folder_of(include)
            if LAYERS.index(other) > LAYERS.index(folder):
                yield f"{path} includes {include}, which stands above it"
            for above, below in NEVER:
                if is_in(folder, above) and is_in(other, below):
                    yield f"{path} includes {include}: never {above} -> {below}"
        if any(is_in(folder, parent) for parent in WITHOUT_DEAL_II):
            for include in sorted(reaches(path, includes, set())):
                if include.startswith("deal.II/"):
                    yield f"{path} comes by {include}"
    for folder, names in rooms.items():
        if len(names) > LARGEST:
            yield f"{folder} has {len(names)} files, at most {LARGEST} can be seen at once"


if __name__ == "__main__":
    FAULTS = list(faults())
    print("\n".join(FAULTS) or "All arrows point down.")
    sys.exit(1 if FAULTS else 0)
