#!/usr/bin/env python3
"""Writes assets/arms/psm1.urdf and psm2.urdf: the two patient-side arms as other programs can read them.

The numbers are those of the dVRK's modified Denavit-Hartenberg table and of the scene; a test holds the files to
engine/kinematics, joint by joint.

    tools/make_arms.py            write the files
    tools/make_arms.py --check    exit 1 if the files differ from what would be written
"""
import argparse
import math
import pathlib
import sys

# name, type, alpha (degrees), a (m), d (m), theta offset (degrees), low, high (degrees, or metres for the insertion)
CHAIN = [
    ("yaw", "revolute", 90, 0.0, 0.0, 90, -91, 91),
    ("pitch", "revolute", -90, 0.0, 0.0, -90, -53, 53),
    ("insertion", "prismatic", 90, 0.0, -0.4318, 0, 0.0, 0.240),
    ("roll", "revolute", 0, 0.0, 0.4162, 0, -260, 260),
    ("wrist_pitch", "revolute", -90, 0.0, 0.0, -90, -80, 80),
    ("wrist_yaw", "revolute", -90, 0.0091, 0.0, -90, -80, 80),
]
JAW_DEGREES = (-40, 80)
TIP_FROM_WRIST_M = 0.0102
TIP_AXES = [[0, -1, 0], [0, 0, 1], [-1, 0, 0]]  # R_6T of the dVRK's tool-tip offset
BASES = {
    "psm1": ((-0.04293, 0.07364, 0.15530), -110),  # right, the assistant's
    "psm2": ((-0.04293, -0.07364, 0.15530), -70),  # left, the user's
}


def number(value):
    """The shortest text that reads back as the same double; whole zeros without a sign."""
    return repr(float(value) + 0.0)


def numbers(values):
    return " ".join(number(v) for v in values)


def roll_pitch_yaw(rotation):
    """URDF's fixed-axis angles: R = Rz(yaw) Ry(pitch) Rx(roll)."""
    pitch = math.atan2(-rotation[2][0], math.hypot(rotation[0][0], rotation[1][0]))
    if abs(abs(pitch) - math.pi / 2) < 1e-9:
        return 0.0, pitch, math.atan2(-rotation[0][1], rotation[1][1])
    return math.atan2(rotation[2][1], rotation[2][2]), pitch, math.atan2(rotation[1][0], rotation[0][0])


def turned(alpha, theta):
    """Rx(alpha) Rz(theta), exact for quarter turns."""
    ca, sa = quarter(alpha)
    ct, st = quarter(theta)
    return [[ct, -st, 0.0], [ca * st, ca * ct, -sa], [sa * st, sa * ct, ca]]


def quarter(degrees):
    return {0: (1.0, 0.0), 90: (0.0, 1.0), -90: (0.0, -1.0)}[degrees]


def joint(name, kind, parent, child, xyz, rpy, limit=None):
    lines = [
        f'  <link name="{child}"/>',
        f'  <joint name="{name}" type="{kind}">',
        f'    <parent link="{parent}"/>',
        f'    <child link="{child}"/>',
        f'    <origin xyz="{numbers(xyz)}" rpy="{numbers(rpy)}"/>',
    ]
    if limit:
        lines.append('    <axis xyz="0 0 1"/>')
        lines.append(f'    <limit lower="{number(limit[0])}" upper="{number(limit[1])}" effort="0" velocity="0"/>')
    lines.append("  </joint>")
    return lines


def urdf(arm):
    position, turn_degrees = BASES[arm]
    lines = [
        '<?xml version="1.0"?>',
        "<!-- Made by tools/make_arms.py. Metres and radians. board is the frame W, tip is T: z out along the jaws, x the",
        f"     jaws' hinge axis. Jaw opening {JAW_DEGREES[0]} to {JAW_DEGREES[1]} degrees. -->",
        f'<robot name="{arm}">',
        '  <link name="board"/>',
    ]
    lines += joint("base", "fixed", "board", "base_link", position, (0.0, 0.0, math.radians(turn_degrees)))
    parent = "base_link"
    for name, kind, alpha, a, d, theta, low, high in CHAIN:
        ca, sa = quarter(alpha)
        limit = (low, high) if kind == "prismatic" else (math.radians(low), math.radians(high))
        lines += joint(name, kind, parent, name + "_link", (a, -sa * d, ca * d), roll_pitch_yaw(turned(alpha, theta)),
                       limit)
        parent = name + "_link"
    lines += joint("tip", "fixed", parent, "tip", (0.0, TIP_FROM_WRIST_M, 0.0), roll_pitch_yaw(TIP_AXES))
    lines.append("</robot>")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true", help="compare instead of writing")
    check = parser.parse_args().check
    folder = pathlib.Path(__file__).resolve().parent.parent / "assets" / "arms"
    folder.mkdir(parents=True, exist_ok=True)
    different = []
    for arm in BASES:
        path = folder / f"{arm}.urdf"
        text = urdf(arm)
        if check and (not path.exists() or path.read_text() != text):
            different.append(path.name)
        elif not check:
            path.write_text(text)
    if different:
        print("differ from what tools/make_arms.py writes: " + ", ".join(different), file=sys.stderr)
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
