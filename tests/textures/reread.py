#!/usr/bin/env python3
"""reread.py GONIO PROFILES: bakes every layout, reads it with OpenImageIO and adds up its flux by its own solid angles.

What the sidecar calls the flux of the web must come out within 1e-5 of float texels (a cookie: the flux of its cone).
Nothing here is shared with the tool but the sidecar's numbers and the layouts' definitions.
"""
import json
import math
import os
import subprocess
import sys
import tempfile

try:
    import OpenImageIO as oiio
except ImportError:
    print("no python3-openimageio: skipped")
    sys.exit(77)


def triangle(a, b, c):
    """Solid angle of a triangle of directions of any length (Van Oosterom and Strackee, 1983)."""
    la, lb, lc = (math.sqrt(sum(x * x for x in v)) for v in (a, b, c))
    triple = (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
              a[2] * (b[0] * c[1] - b[1] * c[0]))
    dot = lambda u, v: sum(x * y for x, y in zip(u, v))
    return abs(2 * math.atan2(triple, la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb))


def octahedral(u, v):
    z = abs(u) + abs(v) - 1
    if z <= 0:
        return (u, v, z)
    return (math.copysign(1 - abs(v), u), math.copysign(1 - abs(u), v), z)


def octahedral_texel(width, _height, i, j):
    u0, u1 = 2 * i / width - 1, 2 * (i + 1) / width - 1
    v0, v1 = 1 - 2 * (j + 1) / width, 1 - 2 * j / width
    # Both halves of an even grid meet on diagonals of texels: each is cut along that which the fold may run along.
    corners = {(a, b): octahedral(*(c + 1e-9 * (m - c) for c, m in ((a, (u0 + u1) / 2), (b, (v0 + v1) / 2))))
               for a in (u0, u1) for b in (v0, v1)}
    if (u0 + u1) * (v0 + v1) > 0:
        cut = ((u0, v1), (u1, v0))
        ends = ((u0, v0), (u1, v1))
    else:
        cut = ((u0, v0), (u1, v1))
        ends = ((u0, v1), (u1, v0))
    return sum(triangle(corners[cut[0]], corners[cut[1]], corners[end]) for end in ends)


def plane(x0, x1, y0, y1):
    """Solid angle of a rectangle in the plane at distance 1."""
    corner = lambda x, y: math.atan2(x * y, math.sqrt(x * x + y * y + 1))
    return corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0)


def face_texel(face, i, j):
    i, j = i % face, j % face
    return plane(2 * i / face - 1, 2 * (i + 1) / face - 1, 2 * j / face - 1, 2 * (j + 1) / face - 1)


def cookie_texel(width, i, j, reach=math.tan(math.radians(35)), border=1):
    inside = width - 2 * border
    i, j = i - border, j - border
    if not (0 <= i < inside and 0 <= j < inside):
        return 0.0
    at = lambda k: reach * (2 * k / inside - 1)
    return plane(at(i), at(i + 1), at(j), at(j + 1))


def ring(j, height):
    return math.cos(math.pi * j / height) - math.cos(math.pi * (j + 1) / height)


layouts = {
    "latlong": ("96x48", lambda w, h, i, j: 2 * math.pi / w * ring(j, h)),
    "v180": ("90x1", lambda w, h, i, j: 2 * math.pi * ring(i, w)),
    "v180 of rows": ("90x24", lambda w, h, i, j: 2 * math.pi / h * ring(i, w)),
    "cube": ("32x32", lambda w, h, i, j: face_texel(h, i, j)),
    "octahedral": ("64x64", octahedral_texel),
    "octahedral-equal-area": ("64x64", lambda w, h, i, j: 4 * math.pi / (w * h)),
    "cube-strip": ("192x32", lambda w, h, i, j: face_texel(h, i, j)),
    "cube-cross": ("128x96", lambda w, h, i, j: face_texel(h // 3, i, j)),
    "panorama": ("96x48", lambda w, h, i, j: 2 * math.pi / w * ring(j, h)),
    "gnomonic": ("66x66", lambda w, h, i, j: cookie_texel(w, i, j)),
}


def lost_attributes(spec, fields, name, before="gonio:"):
    """How many of the sidecar's fields the file does not carry as attributes."""
    lost = 0
    for key, value in fields.items():
        if isinstance(value, dict):
            lost += lost_attributes(spec, value, name, before + key + ".")
        elif not isinstance(value, list):
            kept = spec.getattribute(before + key)
            same = kept == value if isinstance(value, str) else \
                kept is not None and abs(kept - value) <= 1e-6 * abs(value)
            if not same:
                print(f"{name}: attribute {before + key} is {kept!r}, not {value!r}: FAILED")
                lost += 1
    return lost


def main():
    gonio, profiles = sys.argv[1:3]
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for profile in ("street", "downlight", "batwing"):
            for layout, (size, solid_angle) in layouts.items():
                out = os.path.join(folder, f"{profile}-{layout}.exr")
                cone = ["--cone", "70deg", "--border", "1"] if layout == "gnomonic" else []
                subprocess.run([gonio, "bake", os.path.join(profiles, profile + ".ies"), "--layout",
                                layout.split()[0], "-s", size, "-o", out] + cone, check=True)
                with open(out + ".json", encoding="utf-8") as file:
                    sidecar = json.load(file)
                flux = 0.0
                for name in sidecar.get("face_files", [os.path.basename(out)]):
                    picture = oiio.ImageBuf(os.path.join(folder, name))
                    width, height = picture.spec().width, picture.spec().height
                    assert (width, height) == (sidecar["width"], sidecar["height"]), name
                    failed += lost_attributes(picture.spec(), sidecar, name)
                    flux += sum(picture.getpixel(i, j)[0] * sidecar["cd_per_unit"] * solid_angle(width, height, i, j)
                                for j in range(height) for i in range(width))
                wanted = sidecar["texture_flux_lm" if layout == "gnomonic" else "flux_lm"]
                error = abs(flux / wanted - 1)
                verdict = "ok" if error <= 1e-5 else "FAILED"
                failed += error > 1e-5
                print(f"{profile} {layout} {size}: {flux:.6f} of {wanted:.6f} lm, {error:.1e} off: {verdict}")
    sys.exit(1 if failed else 0)


main()
