#!/usr/bin/env python3
"""Writes assets/meshes/*.ply: the board, its parts and the arms, from the numbers of the task.

    tools/make_meshes.py            writes the meshes
    tools/make_meshes.py --check    fails if a committed mesh is not what this script would write

Standard library only. Lengths here are millimetres; files are in metres. The frames are described at each part.
"""
import math
import os
import sys

CREASE_COS = math.cos(math.radians(38.0))


class Solid:
    """Polygons (lists of points, counter-clockwise from outside)."""

    def __init__(self):
        self.faces = []

    def face(self, *points):
        self.faces.append([tuple(p) for p in points])

    def add(self, other, move=(0.0, 0.0, 0.0), axes=((1, 0, 0), (0, 1, 0), (0, 0, 1))):
        """Adds `other`, its x, y, z laid along `axes` (right-handed), then moved."""
        def place(p):
            return tuple(move[i] + sum(p[k] * axes[k][i] for k in range(3)) for i in range(3))
        self.faces += [[place(p) for p in face] for face in other.faces]
        return self


ALONG_X = ((0, 1, 0), (0, 0, 1), (1, 0, 0))  # a solid made along z, laid along x
ALONG_Y = ((0, 0, 1), (1, 0, 0), (0, 1, 0))  # … along y


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def unit(a):
    length = math.sqrt(dot(a, a))
    return (a[0] / length, a[1] / length, a[2] / length) if length > 1e-12 else (0.0, 0.0, 0.0)


# ---- making solids ---------------------------------------------------------------------------------------------------


def loft(rings, cap_first=True, cap_last=True):
    """Joins rings of equally many points, each counter-clockwise seen from +z, from low z to high z."""
    solid = Solid()
    for low, high in zip(rings, rings[1:]):
        for i in range(len(low)):
            j = (i + 1) % len(low)
            solid.face(low[i], low[j], high[j], high[i])
    if cap_first:
        solid.face(*reversed(rings[0]))
    if cap_last:
        solid.face(*rings[-1])
    return solid


def revolve(profile, segments):
    """Turns (radius, z) points, z ascending along the outside, about z; radius 0 closes an end."""
    def ring(radius, z):
        return [(radius * math.cos(2 * math.pi * i / segments), radius * math.sin(2 * math.pi * i / segments), z)
                for i in range(segments)]
    solid = Solid()
    for (r0, z0), (r1, z1) in zip(profile, profile[1:]):
        low, high = ring(r0, z0), ring(r1, z1)
        for i in range(segments):
            j = (i + 1) % segments
            if r0 == 0.0:
                solid.face(low[i], high[j], high[i])
            elif r1 == 0.0:
                solid.face(low[i], low[j], high[i])
            else:
                solid.face(low[i], low[j], high[j], high[i])
    return solid


def cylinder(radius, z0, z1, segments=24, bevel=0.2):
    return revolve([(0.0, z0), (radius - bevel, z0), (radius, z0 + bevel), (radius, z1 - bevel), (radius - bevel, z1),
                    (0.0, z1)], segments)


def rectangle(half_x, half_y, radius, z, steps=4, centre=(0.0, 0.0)):
    """A rounded rectangle as a ring of 4 · (steps + 1) points."""
    ring = []
    for quarter, (sx, sy) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
        for k in range(steps + 1):
            angle = math.pi / 2 * (quarter + k / steps)
            ring.append((centre[0] + sx * (half_x - radius) + radius * math.cos(angle),
                         centre[1] + sy * (half_y - radius) + radius * math.sin(angle), z))
    return ring


def inset(ring, distance):
    """A convex ring (in x, y) with each side moved inwards."""
    count = len(ring)
    lines = []
    for i in range(count):
        a, b = ring[i], ring[(i + 1) % count]
        nx, ny = unit((-(b[1] - a[1]), b[0] - a[0], 0.0))[:2]
        lines.append((nx, ny, nx * a[0] + ny * a[1] + distance))
    moved = []
    for i in range(count):
        (a, b, c), (d, e, f) = lines[i - 1], lines[i]
        det = a * e - b * d
        moved.append(((c * e - b * f) / det, (a * f - c * d) / det, ring[i][2]))
    return moved


def at_z(ring, z):
    return [(p[0], p[1], z) for p in ring]


def bevelled(outline, z0, z1, bevel):
    """A convex outline extruded, with bevelled edges."""
    small = inset(outline, bevel)
    return loft([at_z(small, z0), at_z(outline, z0 + bevel), at_z(outline, z1 - bevel), at_z(small, z1)])


def stadium(length, radius, back, steps=10):
    """A plate from x = −back to a round end about (length, 0), `radius` high to each side; in x, y."""
    ring = [(length + radius * math.cos(a), radius * math.sin(a), 0.0)
            for a in (math.pi * (k / steps - 0.5) for k in range(steps + 1))]
    return ring + [(-back, radius, 0.0), (-back, -radius, 0.0)]


# ---- the parts -------------------------------------------------------------------------------------------------------


def board():
    """In W: 103 × 154 × 22, top at z = 0, rounded corners, chamfered edges."""
    outline = rectangle(51.5, 77.0, 5.0, 0.0, steps=6)
    return loft([at_z(inset(outline, 0.8), -22.0), at_z(outline, -21.2), at_z(outline, -1.1), at_z(inset(outline, 0.35), -0.35),
                 at_z(inset(outline, 1.1), 0.0)])


def table():
    """In W: a square at the table's height, wider than the circle where everything has faded into the background."""
    solid = Solid()
    solid.face((-450.0, -450.0, -21.1), (450.0, -450.0, -21.1), (450.0, 450.0, -21.1), (-450.0, 450.0, -21.1))
    return solid


def peg():
    """Foot at the origin, along z: radius 1.5, 26 high, round tip, a low collar on the board."""
    tip = [(1.5 * math.cos(a), 24.5 + 1.5 * math.sin(a)) for a in (math.pi / 2 * k / 5 for k in range(5))]
    return revolve([(2.7, -0.5), (2.7, 0.45), (2.4, 0.8), (1.5, 0.8)] + tip + [(0.0, 26.0)], 20)


def block():
    """In K (centre): the triangular prism; wall normals at 60°, 180°, 300° from x, hexagonal hole through z."""
    half, chamfer_at, apothem = 7.25, 8.9, 4.157
    outer, hole = [], []
    for side in range(3):
        normal = math.pi * (2 * side + 1) / 3
        along = (-math.sin(normal), math.cos(normal))
        # The side is at the inradius 5; it ends where the corner, 10 from the centre, is cut at `chamfer_at`.
        reach = 5.0 * math.sqrt(3.0) - (10.0 - chamfer_at) / math.cos(math.pi / 6)
        corner = apothem / math.cos(math.pi / 6)
        for sign in (-1, 1):
            outer.append((5.0 * math.cos(normal) + sign * reach * along[0],
                          5.0 * math.sin(normal) + sign * reach * along[1], 0.0))
            hole.append((corner * math.cos(normal + sign * math.pi / 6),
                         corner * math.sin(normal + sign * math.pi / 6), 0.0))
    bevel, hole_bevel = 0.28, 0.12
    solid = loft([at_z(inset(outer, bevel), -half), at_z(inset(outer, 0.08), -half + 0.08), at_z(outer, -half + bevel),
                  at_z(outer, half - bevel), at_z(inset(outer, 0.08), half - 0.08), at_z(inset(outer, bevel), half)],
                 cap_first=False, cap_last=False)
    wall = loft([at_z(inset(hole, -hole_bevel), -half), at_z(hole, -half + hole_bevel), at_z(hole, half - hole_bevel),
                 at_z(inset(hole, -hole_bevel), half)], cap_first=False, cap_last=False)
    solid.faces += [list(reversed(face)) for face in wall.faces]
    rim, edge = inset(outer, bevel), inset(hole, -hole_bevel)
    for i in range(6):
        j = (i + 1) % 6
        solid.face(*at_z([edge[i], rim[i], rim[j], edge[j]], half))
        solid.face(*at_z([edge[j], rim[j], rim[i], edge[i]], -half))
    return solid


def shaft():
    """Origin at the wrist-pitch joint, whose axis is y; z out along the tool. The tube ends 34 mm up, where the stage lets it fade."""
    solid = revolve([(4.2, -34.0), (4.2, -12.4), (3.95, -12.2), (3.95, -11.4), (4.2, -11.2),
                     (4.2, -7.0), (3.7, -5.4), (0.0, -5.4)], 32)
    # Revolving leaves the outside facing out whichever way z runs; the ears hold the wrist between them.
    ear = bevelled(stadium(0.0, 2.7, 6.6), -0.65, 0.65, 0.18)
    for y in (-2.95, 2.95):
        solid.add(ear, move=(0.0, y, 0.0), axes=((0, 0, 1), (1, 0, 0), (0, 1, 0)))
    return solid


def shaft_pins():
    """In the shaft's frame: the wrist-pitch joint's pin."""
    return Solid().add(cylinder(1.15, -3.9, 3.9, 16, 0.15), axes=ALONG_Y)


def shaft_band():
    """In the shaft's frame: a band round the tube, in the colour of the arm."""
    return revolve([(4.2, -22.0), (4.42, -21.8), (4.42, -15.2), (4.2, -15.0)], 32)


def wrist():
    """Origin at the wrist-pitch joint (axis y), z towards the wrist-yaw joint (axis x) 9.1 mm away."""
    solid = Solid()
    hub = revolve([(0.0, -2.2), (2.5, -2.2), (2.5, -1.5), (2.1, -1.2), (2.1, 1.2), (2.5, 1.5), (2.5, 2.2), (0.0, 2.2)],
                  24)
    solid.add(hub, axes=ALONG_Y)
    solid.add(loft([rectangle(2.0, 2.1, 0.6, 0.8), rectangle(2.9, 2.3, 0.7, 3.4), rectangle(3.3, 2.3, 0.7, 4.6),
                    rectangle(3.3, 2.3, 0.7, 5.6), rectangle(3.0, 2.0, 0.6, 6.0)]))
    cheek = bevelled(stadium(9.1, 2.2, -5.0), -0.5, 0.5, 0.15)
    for x in (-2.75, 2.75):
        solid.add(cheek, move=(x, 0.0, 0.0), axes=((0, 0, 1), (0, -1, 0), (1, 0, 0)))
    return solid


def wrist_pins():
    """In the wrist's frame: the wrist-yaw joint's pin."""
    return Solid().add(cylinder(0.95, -3.6, 3.6, 16, 0.15), move=(0.0, 0.0, 9.1), axes=ALONG_X)


def jaw():
    """Origin at the wrist-yaw joint (axis x), z along the closed jaw to the tip 10.2 mm away; this jaw opens to +y."""
    solid = Solid()
    solid.add(cylinder(1.9, 0.15, 2.1, 24, 0.15), axes=ALONG_X)

    def section(z, y_in, y_out, half_x):
        corner = min(0.22, 0.4 * (y_out - y_in))
        y_mid = 0.5 * (y_in + y_out)
        # Bevelled outside only: the gripping face is flat to its edges.
        ring = [(half_x, y_in), (half_x, y_out - corner), (half_x - corner, y_out), (-half_x + corner, y_out),
                (-half_x, y_out - corner), (-half_x, y_in)]
        assert y_in < y_mid < y_out
        return [(x, y, z) for x, y in ring]

    def outline(z):
        s = (z - 1.4) / (10.2 - 1.4)
        return 1.85 - 1.0 * s, 1.15 - 0.4 * s

    rings = []
    for z in (0.4, 1.4, 2.6, 3.4):
        rings.append(section(z, 0.06, outline(max(z, 1.4))[0], outline(max(z, 1.4))[1]))
    tooth, z = 0.5, 3.4
    while z + tooth < 9.9:
        rings.append(section(z + 0.5 * tooth, 0.2, *outline(z + 0.5 * tooth)))
        rings.append(section(z + tooth, 0.06, *outline(z + tooth)))
        z += tooth
    rings.append(section(10.05, 0.06, 0.62, 0.62))
    rings.append(section(10.2, 0.1, 0.42, 0.45))
    solid.faces += loft(rings).faces
    return solid


PARTS = {
    "board": board, "table": table, "peg": peg, "block": block, "psm_shaft": shaft, "psm_shaft_pin": shaft_pins,
    "psm_shaft_band": shaft_band, "psm_wrist": wrist, "psm_wrist_pin": wrist_pins, "psm_jaw": jaw,
}

# ---- writing ---------------------------------------------------------------------------------------------------------


def area_normal(face):
    total = (0.0, 0.0, 0.0)
    for i in range(1, len(face) - 1):
        n = cross(sub(face[i], face[0]), sub(face[i + 1], face[0]))
        total = (total[0] + n[0], total[1] + n[1], total[2] + n[2])
    return total


def split(ring):
    """A convex polygon as triangles, the widest first: slivers cost a software renderer more than area does."""
    count = len(ring)
    if count == 3:
        return [tuple(ring)]
    if count == 4:
        return [(ring[0], ring[1], ring[2]), (ring[0], ring[2], ring[3])]
    a, b = count // 3, 2 * count // 3
    parts = [(ring[0], ring[a], ring[b])]
    for arc in (ring[:a + 1], ring[a:b + 1], ring[b:] + ring[:1]):
        if len(arc) > 2:
            parts += split(arc)
    return parts


def key(p):
    return (round(p[0] * 1e4), round(p[1] * 1e4), round(p[2] * 1e4))


def triangles_of(solid):
    """Vertices (position, normal) shared where the surface is smooth, and triangles."""
    normals = [area_normal(face) for face in solid.faces]
    around = {}
    for index, face in enumerate(solid.faces):
        for point in face:
            around.setdefault(key(point), set()).add(index)
    vertices, triangles = {}, []
    for index, face in enumerate(solid.faces):
        own = unit(normals[index])
        if own == (0.0, 0.0, 0.0):
            continue
        corners = []
        for point in face:
            total = (0.0, 0.0, 0.0)
            for other in sorted(around[key(point)]):
                if dot(own, unit(normals[other])) >= CREASE_COS:
                    total = tuple(total[i] + normals[other][i] for i in range(3))
            line = " ".join("%.7g" % (round(c * 1e4) / 1e7 + 0.0) for c in point)
            line += " " + " ".join("%.4f" % (c if abs(c) > 5e-5 else 0.0) for c in unit(total))
            corners.append(vertices.setdefault(line, len(vertices)))
        triangles += [t for t in split(corners) if len(set(t)) == 3]
    return list(vertices), triangles


def ply(name, solid):
    vertices, triangles = triangles_of(solid)
    lines = ["ply", "format ascii 1.0", "comment %s, written by tools/make_meshes.py; metres" % name,
             "element vertex %d" % len(vertices)]
    lines += ["property float %s" % axis for axis in ("x", "y", "z", "nx", "ny", "nz")]
    lines += ["element face %d" % len(triangles), "property list uchar uint vertex_indices", "end_header"]
    lines += vertices + ["3 %d %d %d" % t for t in triangles]
    return "\n".join(lines) + "\n", len(triangles)


def main():
    folder = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "assets", "meshes")
    check = "--check" in sys.argv[1:]
    os.makedirs(folder, exist_ok=True)
    stale = []
    for name, make in PARTS.items():
        text, count = ply(name, make())
        path = os.path.join(folder, name + ".ply")
        if check:
            with open(path, encoding="ascii") as committed:
                if committed.read() != text:
                    stale.append(path)
        else:
            with open(path, "w", encoding="ascii") as out:
                out.write(text)
            print("%-16s %5d triangles" % (name, count))
    if stale:
        sys.exit("not what tools/make_meshes.py writes: " + " ".join(stale))


if __name__ == "__main__":
    main()
