"""A cube of hexahedra as Gmsh writes it, its nodes and cells in any order."""

import random


def cube(n, seed=None):
    """n³ hexahedra in the unit cube, with the faces wall: x = 0, top: z = 1 and sole:
    z = 0 and the volume steel. seed: of the order; none: as they come."""
    order = list(range((n + 1) ** 3))
    rng = random.Random(seed)
    if seed is not None:
        rng.shuffle(order)

    def node(i, j, k):
        return 1 + order[i + (n + 1) * (j + (n + 1) * k)]

    text = ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n4\n2 1 \"wall\"\n"
            "2 2 \"top\"\n2 3 \"sole\"\n3 4 \"steel\"\n$EndPhysicalNames\n")
    places = [(i, j, k) for k in range(n + 1) for j in range(n + 1) for i in range(n + 1)]
    text += f"$Nodes\n{len(places)}\n" + "".join(
        f"{node(*place)} {place[0] / n} {place[1] / n} {place[2] / n}\n"
        for place in places) + "$EndNodes\n"
    elements = []
    for a in range(n):
        for b in range(n):
            elements += [
                f"3 2 1 1 {node(0, a, b)} {node(0, a + 1, b)} {node(0, a + 1, b + 1)} "
                f"{node(0, a, b + 1)}",
                f"3 2 2 2 {node(a, b, n)} {node(a + 1, b, n)} {node(a + 1, b + 1, n)} "
                f"{node(a, b + 1, n)}",
                f"3 2 3 3 {node(a, b, 0)} {node(a + 1, b, 0)} {node(a + 1, b + 1, 0)} "
                f"{node(a, b + 1, 0)}"]
            elements += ["5 2 4 4 " + " ".join(str(node(a + x, b + y, c + z)) for x, y, z in (
                (0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1),
                (0, 1, 1))) for c in range(n)]
    if seed is not None:
        rng.shuffle(elements)
    return text + f"$Elements\n{len(elements)}\n" + "".join(
        f"{number} {element}\n" for number, element in enumerate(elements, 1)
    ) + "$EndElements\n"
