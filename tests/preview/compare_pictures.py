"""Blender's picture against gonio's cd/m2, both of the same exported scene: compare_pictures.py BLENDER.exr GONIO.exr
[LIGHT_NT [DIFFERENCE.png]]

Prints the mean difference in lit areas, and how far apart edges stand: a pixel is within k pixels where its value lies
between the least and the greatest of gonio's picture that far around it, or not more than 1 % of itself and the mean
from there. Where a light itself is seen (above LIGHT_NT: brighter than all that it lights) is left out with the two pixels around
it. Exits with 1 unless the mean and, in the mean, blocks of 8 x 8 pixels
agree to 1 %, and 998 of 1000 pixels within two.
"""

import sys

import OpenImageIO as oiio

LUMINANCE = (0.21263900587151027, 0.71516867876775592, 0.072192315360733714)


def luminance(path, factor):
    """Rows of cd/m2."""
    picture = oiio.ImageBuf(path)
    size = picture.spec()
    return [
        [factor * sum(a * b for a, b in zip(LUMINANCE, picture.getpixel(i, j))) for i in range(size.width)]
        for j in range(size.height)
    ]


def around(rows, reach, choose):
    """The least or greatest of the square of 2 reach + 1 pixels around each."""
    def across(row):
        return [choose(row[max(i - reach, 0) : i + reach + 1]) for i in range(len(row))]

    def turned(rows):
        return [list(column) for column in zip(*rows)]

    return turned([across(row) for row in turned([across(row) for row in rows])])


blender = luminance(sys.argv[1], 177.83)
gonio = luminance(sys.argv[2], 1.0)
light_nt = float(sys.argv[3]) if len(sys.argv) > 3 else float("inf")
height, width = len(gonio), len(gonio[0])
assert (len(blender), len(blender[0])) == (height, width)
seen = around([[max(a, b) > light_nt for a, b in zip(*rows)] for rows in zip(blender, gonio)], 2, max)
kept = [(j, i) for j in range(height) for i in range(width) if not seen[j][i]]
mean = sum(gonio[j][i] for j, i in kept) / len(kept)
lit = [(j, i) for j, i in kept if gonio[j][i] > 0.05 * mean]
sums = sum(blender[j][i] for j, i in lit), sum(gonio[j][i] for j, i in lit)
ratio = sums[0] / sums[1]
off = sum(abs(blender[j][i] - gonio[j][i]) for j, i in lit) / sums[1]
blocks = {}
for j, i in lit:
    block = blocks.setdefault((j // 8, i // 8), [0.0, 0.0])
    block[0] += blender[j][i]
    block[1] += gonio[j][i]
off_blocks = sum(abs(a - b) for a, b in blocks.values()) / sums[1]  # with less of Cycles' noise
within = []
for reach in (0, 1, 2):
    low, high = around(gonio, reach, min), around(gonio, reach, max)
    near = 0
    for j, i in kept:
        slack = 0.01 * (gonio[j][i] + mean)
        near += low[j][i] - slack <= blender[j][i] <= high[j][i] + slack
    within.append(near / len(kept))
print(f"{len(kept)} pixels, {len(lit)} lit: mean {ratio:.5f} of gonio's, mean difference {100 * off:.2f} %, "
      f"of blocks of 8 x 8 {100 * off_blocks:.2f} %; within "
      + ", ".join(f"{k} pixels {100 * share:.2f} %" for k, share in enumerate(within)))
if len(sys.argv) > 4:  # the difference over the value and the mean: red where Blender has more, white at 10 %
    out = oiio.ImageBuf(oiio.ImageSpec(width, height, 3, oiio.UINT8))
    for j in range(height):
        for i in range(width):
            change = 10.0 * (blender[j][i] - gonio[j][i]) / (gonio[j][i] + mean)
            out.setpixel(i, j, 0, (max(change, 0.0), 0.0, max(-change, 0.0)))
    out.write(sys.argv[4])
sys.exit(0 if abs(ratio - 1.0) < 0.01 and off_blocks < 0.01 and within[2] > 0.998 else 1)
