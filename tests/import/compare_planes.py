"""Blender's plane against gonio probe's: compare_planes.py BLENDER.csv PROBE.csv [MEAN WORST]

Exits with 1 unless the mean agrees to 0.1 % and every pixel to 1 % of the brightest (or as said), which leaves room for
the cubic interpolation of Cycles between the table's lines.
"""

import csv
import sys


def cells(path, column):
    """Values by pixel, 32 by 32 over 4 m; means of what lies in one."""
    sums = {}
    with open(path, encoding="ascii") as table:
        for row in csv.DictReader(line for line in table if not line.startswith("#")):
            at = int((float(row["x"]) + 2.0) * 8.0), int((float(row["y"]) + 2.0) * 8.0)
            total, count = sums.get(at, (0.0, 0))
            sums[at] = total + float(row[column]), count + 1
    return {at: total / count for at, (total, count) in sums.items()}


blender = cells(sys.argv[1], "lux")
probe = cells(sys.argv[2], "illuminance_lx")
assert blender.keys() == probe.keys() and len(probe) == 1024
brightest = max(probe.values())
worst = max(abs(blender[at] - probe[at]) for at in probe) / brightest
ratio = sum(blender.values()) / sum(probe.values())
print(f"{sys.argv[1]}: {len(probe)} pixels, mean {ratio:.5f} of gonio's, worst {worst:.4f} of the brightest")
most_mean, most_worst = map(float, sys.argv[3:5]) if len(sys.argv) > 3 else (1e-3, 0.01)
sys.exit(0 if abs(ratio - 1.0) < most_mean and worst < most_worst else 1)
