"""Blender's picture against gonio's lux: compare_pictures.py BLENDER.exr LUX.exr

Exits with 1 unless the mean agrees to 1 % and 95 of 100 pixels do to 2 % of the mean beside their own value: what is
left are outlines, penumbrae (gonio's shadows weigh all parts of a light alike) and noise.
"""

import math
import sys

import OpenImageIO as oiio

blender = oiio.ImageBuf(sys.argv[1])
lux = oiio.ImageBuf(sys.argv[2])
assert (blender.spec().width, blender.spec().height) == (lux.spec().width, lux.spec().height)
pairs = []
for y in range(lux.spec().height):
    for x in range(lux.spec().width):
        red, green, blue = blender.getpixel(x, y)[:3]
        luminance = 0.21263900587151027 * red + 0.71516867876775592 * green + 0.072192315360733714 * blue
        pairs.append((luminance * math.pi * 177.83, lux.getpixel(x, y)[0]))
ratio = sum(a for a, _ in pairs) / sum(b for _, b in pairs)
mean = sum(b for _, b in pairs) / len(pairs)
far = sorted(abs(a - b) / (b + mean) for a, b in pairs)
at_95 = far[int(0.95 * (len(far) - 1))]
print(f"{len(pairs)} pixels: mean {ratio:.5f} of gonio's; half are within {far[len(far) // 2]:.4f}, 95 % within "
      f"{at_95:.4f}, the worst {far[-1]:.3f} of their value and the mean")
sys.exit(0 if abs(ratio - 1.0) < 0.01 and at_95 < 0.02 else 1)
