#!/usr/bin/python3
"""Writes lug.msh: a plate with a hole, of hexahedra of second order.

    /usr/bin/python3 make_lug.py DIRECTORY

Units: mm. The plate is 60 x 40 x 10 around the z axis, from z = 0; the hole around
this axis has a radius of 10. Needs the Debian package python3-gmsh.
"""
import math
import os
import sys

import gmsh

LENGTH, WIDTH, THICKNESS, RADIUS = 60.0, 40.0, 10.0, 10.0
AROUND, ACROSS, ALONG, LAYERS = 6, 4, 2, 2  # cells

gmsh.initialize()
gmsh.option.setNumber("General.Verbosity", 0)
geo = gmsh.model.geo

# a square with the hole in four parts, and the rest on either side of it
half = WIDTH / 2
corners = [geo.addPoint(x * half, y * half, 0) for x, y in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
slant = RADIUS * math.sqrt(0.5)
circle = [geo.addPoint(x * slant, y * slant, 0) for x, y in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
centre = geo.addPoint(0, 0, 0)
ends = [geo.addPoint(x * LENGTH / 2, y * half, 0) for x, y in ((1, 1), (-1, 1), (-1, -1), (1, -1))]

arcs = [geo.addCircleArc(circle[i], centre, circle[(i + 1) % 4]) for i in range(4)]
sides = [geo.addLine(corners[i], corners[(i + 1) % 4]) for i in range(4)]
spokes = [geo.addLine(circle[i], corners[i]) for i in range(4)]
reaches = [geo.addLine(corners[i], ends[i]) for i in range(4)]
left, right = geo.addLine(ends[1], ends[2]), geo.addLine(ends[3], ends[0])


def surface(*lines):
    """Of a loop of four lines, meshed with quadrilaterals."""
    face = geo.addPlaneSurface([geo.addCurveLoop(list(lines))])
    geo.mesh.setTransfiniteSurface(face)
    geo.mesh.setRecombine(2, face)
    return face


faces = [surface(arcs[i], spokes[(i + 1) % 4], -sides[i], -spokes[i]) for i in range(4)]
faces.append(surface(sides[1], reaches[2], -left, -reaches[1]))
faces.append(surface(sides[3], reaches[0], -right, -reaches[3]))
for line in arcs + sides + [left, right]:
    geo.mesh.setTransfiniteCurve(line, AROUND + 1)
for line in spokes:
    geo.mesh.setTransfiniteCurve(line, ACROSS + 1, "Progression", 1.3)
for line in reaches:
    geo.mesh.setTransfiniteCurve(line, ALONG + 1)
volumes = []
for face in faces:
    made = geo.extrude([(2, face)], 0, 0, THICKNESS, [LAYERS], recombine=True)
    volumes.append(made[1][1])
geo.synchronize()


def boundary(name, low, high):
    """Names the faces inside of a box."""
    found = gmsh.model.getEntitiesInBoundingBox(
        *[x - 1e-6 for x in low], *[x + 1e-6 for x in high], 2)
    group = gmsh.model.addPhysicalGroup(2, [tag for _, tag in found])
    gmsh.model.setPhysicalName(2, group, name)


boundary("hole", (-RADIUS, -RADIUS, 0), (RADIUS, RADIUS, THICKNESS))
boundary("left", (-LENGTH / 2, -half, 0), (-LENGTH / 2, half, THICKNESS))
boundary("right", (LENGTH / 2, -half, 0), (LENGTH / 2, half, THICKNESS))
boundary("bottom", (-LENGTH / 2, -half, 0), (LENGTH / 2, half, 0))
gmsh.model.setPhysicalName(3, gmsh.model.addPhysicalGroup(3, volumes), "lug")
gmsh.model.mesh.generate(3)
gmsh.model.mesh.setOrder(2)
gmsh.write(os.path.join(sys.argv[1], "lug.msh"))
