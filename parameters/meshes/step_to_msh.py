#!/usr/bin/python3
"""Make a mesh for stiction of a STEP file, with Gmsh.

    ./run mesh PART.step                      lists the surfaces of the part
    ./run mesh PART.step PART.msh --size 5 --boundary wall=3,4 --boundary hole=9

The first shows numbers, areas and places of the surfaces; the second makes
tetrahedra, of second order so that they follow curved surfaces, and names
boundaries by these numbers. Faces without a name are boundary 0. Several volumes
are glued where they touch; '--material steel=1,2' names them by their numbers.
Lengths are mm whatever the unit of the file is, or what --unit says.
Needs the Debian package python3-gmsh.
"""

import argparse
import os
import sys

try:
    import gmsh
except ImportError as error:
    sys.exit(f"step_to_msh.py: {sys.executable}: {error}; install the package "
             "python3-gmsh and call Debian's own /usr/bin/python3.")


def fail(sentence):
    """End with one sentence on stderr and exit status 1."""
    sys.exit(f"step_to_msh.py: {sentence}")


def read_arguments():
    """The command line."""
    parser = argparse.ArgumentParser(
        prog="./run mesh", description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("step", help="the STEP file")
    parser.add_argument("msh", nargs="?", help="the mesh file to be written")
    parser.add_argument("--size", type=float, help="edge length of the tetrahedra")
    parser.add_argument("--fine", action="append", default=[], metavar="NAME=SIZE",
                        help="a smaller edge length at the edges of a boundary")
    parser.add_argument("--boundary", action="append", default=[],
                        metavar="NAME=NUMBERS", help="surfaces and their name")
    parser.add_argument("--material", action="append", default=[],
                        metavar="NAME=NUMBERS", help="volumes and their name")
    parser.add_argument("--order", type=int, choices=(1, 2), default=2,
                        help="of the tetrahedra, 2 if it is not given")
    parser.add_argument("--unit", choices=("MM", "CM", "M", "IN"), default="MM",
                        help="of all lengths")
    return parser.parse_args()


def named_numbers(options, known, what):
    """Of options 'NAME=1,2': name -> numbers, each of them known and used once."""
    named, used = {}, set()
    for option in options:
        name, equals, numbers = option.partition("=")
        if not name or not equals or not all(
                word.strip().isdigit() for word in numbers.split(",")):
            fail(f"'{option}' must be a name and numbers of {what}s, such as 'wall=3,4'.")
        if set(name) & set(":|;,#"):  # which separate names in a parameter file
            fail(f"the name in '{option}' must be without ':', '|', ';', ',' and '#'.")
        named.setdefault(name, [])
        for number in map(int, numbers.split(",")):
            if number not in known:
                fail(f"there is no {what} {number}, there are {min(known)} to "
                     f"{max(known)}.")
            if number in used:
                fail(f"{what} {number} has two names, must have one.")
            used.add(number)
            named[name].append(number)
    return named


def read_part(path, unit):
    """Read the STEP file, volumes that touch glued together."""
    if not os.path.isfile(path):
        fail(f"there is no file '{path}'.")
    gmsh.option.setString("Geometry.OCCTargetUnit", unit)
    try:
        gmsh.model.occ.importShapes(path)
    except Exception:  # pylint: disable=broad-except # which is all that Gmsh throws
        fail(f"'{path}' is no STEP file that Gmsh could read.")
    gmsh.model.occ.synchronize()
    volumes = gmsh.model.getEntities(3)
    if not volumes:
        fail(f"'{path}' has no volume, must be a solid part.")
    if len(volumes) > 1:
        gmsh.model.occ.fragment(volumes[:1], volumes[1:])
        gmsh.model.occ.synchronize()


def list_entities():
    """Print what can be named."""
    print(f"{'surface':>8} {'kind':<12} {'area':>10}  centre")
    for dimension, number in gmsh.model.getEntities(2):
        centre = gmsh.model.occ.getCenterOfMass(dimension, number)
        print(f"{number:8} {gmsh.model.getType(dimension, number):<12} "
              f"{gmsh.model.occ.getMass(dimension, number):10.4g}  "
              + ", ".join(f"{0. if abs(x) < 1e-9 else x:.4g}" for x in centre))
    for dimension, number in gmsh.model.getEntities(3):
        print(f"volume {number} of {gmsh.model.occ.getMass(dimension, number):.4g}")


def name_groups(boundaries, materials):
    """Make physical groups; volumes without a name are 'body'."""
    for name, numbers in boundaries.items():
        group = gmsh.model.addPhysicalGroup(2, numbers)
        gmsh.model.setPhysicalName(2, group, name)
    rest = {number for _, number in gmsh.model.getEntities(3)}
    for name, numbers in materials.items():
        group = gmsh.model.addPhysicalGroup(3, numbers)
        gmsh.model.setPhysicalName(3, group, name)
        rest -= set(numbers)
    if rest:
        group = gmsh.model.addPhysicalGroup(3, sorted(rest))
        gmsh.model.setPhysicalName(3, group, "body")


def set_sizes(size, fine, boundaries):
    """Edge lengths at all points, smaller ones at those of some boundaries."""
    gmsh.option.setNumber("Mesh.CharacteristicLengthMax", size)
    gmsh.model.mesh.setSize(gmsh.model.getEntities(0), size)
    for option in fine:
        name, _, value = option.partition("=")
        if name not in boundaries:
            fail(f"'{option}' must begin with the name of a boundary.")
        try:
            smaller = float(value)
        except ValueError:
            fail(f"'{option}' must be a name and an edge length, such as 'hole=2'.")
        surfaces = [(2, number) for number in boundaries[name]]
        gmsh.model.mesh.setSize(
            gmsh.model.getBoundary(surfaces, False, False, True), smaller)


def write_mesh(path, order):
    """Make the tetrahedra and write them."""
    gmsh.option.setNumber("Mesh.ElementOrder", order)
    gmsh.option.setNumber("Mesh.HighOrderOptimize", 1)  # where curved ones fold
    gmsh.option.setNumber("Mesh.MshFileVersion", 4.1)
    gmsh.option.setNumber("Mesh.Binary", 0)
    gmsh.model.mesh.generate(3)
    try:
        gmsh.write(path)
    except Exception:  # pylint: disable=broad-except
        fail(f"'{path}' cannot be written.")
    _, elements, _ = gmsh.model.mesh.getElements(3)
    print(f"Wrote {path}: {sum(map(len, elements))} tetrahedra")


def main():
    """List the surfaces or make the mesh."""
    arguments = read_arguments()
    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 0)
    read_part(arguments.step, arguments.unit)
    if arguments.msh is None:
        list_entities()
        return
    if not arguments.msh.endswith(".msh"):
        fail(f"'{arguments.msh}' must be a file .msh.")
    if arguments.size is None or not arguments.size > 0.:
        fail("--size must say how long edges are, such as '--size 5'.")
    numbers = [{number for _, number in gmsh.model.getEntities(dimension)}
               for dimension in (2, 3)]
    boundaries = named_numbers(arguments.boundary, numbers[0], "surface")
    name_groups(boundaries, named_numbers(arguments.material, numbers[1], "volume"))
    set_sizes(arguments.size, arguments.fine, boundaries)
    write_mesh(arguments.msh, arguments.order)


if __name__ == "__main__":
    main()
