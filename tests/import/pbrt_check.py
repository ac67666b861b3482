#!/usr/bin/env python3
"""pbrt_check.py GONIO PROFILES: imports profiles for pbrt and looks the images up as pbrt-v4 does.

The mapping from the sphere to the square, the frame of the light and the look-up without filtering are written here
again, from P. Clarberg's "Fast Equal-Area Mapping of the (Hemi)Sphere using SIMD" (2008) and the description of pbrt's
goniometric light; nothing is shared with the tool.
"""
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile

try:
    import OpenImageIO as oiio
except ImportError:
    print("no python3-openimageio: skipped")
    sys.exit(77)


def to_square(x, y, z):
    r = math.sqrt(1 - abs(z))
    phi = math.atan2(abs(y), abs(x)) * 2 / math.pi
    v = phi * r
    u = r - v
    if z < 0:
        u, v = 1 - v, 1 - u
    return (math.copysign(u, x) + 1) / 2, (math.copysign(v, y) + 1) / 2


gonio, profiles = sys.argv[1:]
random.seed(7)
failed = False
with tempfile.TemporaryDirectory() as folder:
    names = ("street", "wall-washer", "pendant", "batwing")
    files = [os.path.join(profiles, name + ".ies") for name in names]
    subprocess.run([gonio, "import", *files, "--to", "pbrt", "-O", folder, "-q"], check=True)
    for name, file in zip(names, files):
        with open(os.path.join(folder, "pbrt", name + ".pbrt"), encoding="ascii") as scene:
            text = scene.read()
        assert "Rotate -90 1 0 0" in text and f'"string filename" "{name}.exr"' in text
        power = float(re.search(r'"float power" \[ (\S+) \]', text)[1])
        image = oiio.ImageBuf(os.path.join(folder, "pbrt", name + ".exr"))
        spec = image.spec()
        assert spec.width == spec.height and spec.channelnames == ("Y",), (spec.width, spec.channelnames)
        texels = [[image.getpixel(i, j)[0] for i in range(spec.width)] for j in range(spec.height)]
        mean = math.fsum(math.fsum(row) for row in texels) / (spec.width * spec.height)
        # Equal areas: 4π times the mean is the flux, which `power` asks for.
        flux_error = abs(4 * math.pi * mean / power - 1)
        angles = [(360 * random.random(), math.degrees(math.acos(1 - 2 * random.random()))) for _ in range(2000)]
        said = subprocess.run([gonio, "sample", file, "-", "--json"], check=True, capture_output=True, text=True,
                              input="".join(f"{c},{gamma}\n" for c, gamma in angles)).stdout
        candela = [sample["cd"] for sample in json.loads(said)["samples"]]
        peak = max(candela)
        errors = []
        for (c, gamma), cd in zip(angles, candela):
            c, gamma = math.radians(c), math.radians(gamma)
            world = (math.sin(gamma) * math.cos(c), math.sin(gamma) * math.sin(c), -math.cos(gamma))
            x, y, z = world[0], -world[2], world[1]  # back through "Rotate -90 1 0 0"
            u, v = to_square(x, z, y)  # pbrt exchanges y and z
            i = min(int(u * spec.width), spec.width - 1)
            j = min(int(v * spec.height), spec.height - 1)
            errors.append(abs(texels[j][i] - cd) / peak)
        errors.sort()
        median, worst = errors[len(errors) // 2], errors[-1]
        print(f"{name}: flux off by {flux_error:.1e}, nearest texel by {median:.1e} (median) and {worst:.1e} of the peak")
        # A texel spans 0.4°; the steepest profile changes by 2 % of its peak in half of that.
        failed |= flux_error > 1e-6 or median > 2e-3 or worst > 3e-2
sys.exit(1 if failed else 0)
