#!/usr/bin/python3
"""Writes bracket.step: a plate with two bolt holes and an arm with an eye.

    /usr/bin/python3 make_bracket.py DIRECTORY

Units: mm. The plate lies in 0 < x < 8 with its back at x = 0; the arm reaches along
x to an eye of radius 11 around the y axis at x = 45, with a hole of radius 5; the
corners between both are rounded. Needs the Debian package python3-gmsh.
"""
import os
import sys

import gmsh

gmsh.initialize()
gmsh.option.setNumber("General.Verbosity", 0)
occ = gmsh.model.occ
plate = (3, occ.addBox(0, 0, -32, 8, 30, 64))
arm = (3, occ.addBox(8, 7, -9, 37, 16, 18))
eye = (3, occ.addCylinder(45, 7, 0, 0, 16, 0, 11))
body, _ = occ.fuse([plate], [arm, eye])
occ.synchronize()
corners = [edge for _, edge in gmsh.model.getEntitiesInBoundingBox(
    7.9, 6.9, -9.1, 8.1, 23.1, 9.1, 1) if abs(
        occ.getCenterOfMass(1, edge)[2]) > 8.9]
body = occ.fillet([body[0][1]], corners, [5])
holes = [(3, occ.addCylinder(45, 0, 0, 0, 30, 0, 5))]
for height in (-23, 23):
    holes.append((3, occ.addCylinder(-1, 15, height, 10, 0, 0, 4)))
occ.cut(body, holes)
occ.synchronize()
gmsh.write(os.path.join(sys.argv[1], "bracket.step"))
