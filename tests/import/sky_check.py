#!/usr/bin/env python3
"""sky_check.py GONIO: exports a sky for every target that stores one, and reads the files again.

What each program documents of its panorama is written here once more: where a point of the picture lies in its own
axes, how the file turns them, and how many nits a pixel is. By that the picture has to give the illuminances of the sky
on the horizontal and on four walls, per channel, and its brightest spot has to be where it is in the sky.
"""
import json
import math
import os
import re
import subprocess
import sys
import tempfile

try:
    import OpenImageIO as oiio
except ImportError:
    print("no python3-openimageio: skipped")
    sys.exit(77)

SKY = "cie:12,sun=120/25,horizontal=20klx,color=4000K,ground=0.2"
# Turned once more, a picture of it is the sky: nothing may depend on north in the middle of the source.
TURN_DEG = 40.0
TARGETS = "babylon,blender,godot,luxcore,mitsuba,pbrt,radiance,raw,threejs,unity,unreal,usd"
LUMINANCE = (0.2126390059, 0.7151686788, 0.0721923154)
NORMALS = {"up": (0, 0, 1), "north": (0, 1, 0), "east": (1, 0, 0), "south": (0, -1, 0), "west": (-1, 0, 0)}
SUBDIVISION = 2  # of a texel, in each direction


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


class Picture:
    def __init__(self, path):
        image = oiio.ImageBuf(path)
        self.width, self.height = image.spec().width, image.spec().height
        self.pixels = [[image.getpixel(i, j)[:3] for i in range(self.width)] for j in range(self.height)]

    def at(self, u, v):
        """Of a point in [0, 1]², from the upper left."""
        i = min(int(u % 1.0 * self.width), self.width - 1)
        return self.pixels[min(max(int(v * self.height), 0), self.height - 1)][i]


def middle_read(pixel):
    """As Radiance reads a pixel: the middle of what each mantissa stands for."""
    most = max(pixel)
    if most <= 0.0:
        return pixel
    half = math.ldexp(0.5, math.frexp(most)[1] - 8)
    return tuple(x + half for x in pixel)


def measured(lookup):
    """Illuminances [lx] per channel, by directions of gonio's world: Z up, +Y north, +X east; and the brightest direction."""
    rows = 64 * SUBDIVISION
    totals = {name: [0.0, 0.0, 0.0] for name in NORMALS}
    best, spot = 0.0, None
    for j in range(rows):
        theta0, theta1 = math.pi * j / rows, math.pi * (j + 1) / rows
        theta = 0.5 * (theta0 + theta1)
        step = math.pi / rows
        solid = (math.cos(theta0) - math.cos(theta1)) * step
        for i in range(2 * rows):
            azimuth = (i + 0.5) * step
            d = (math.sin(theta) * math.sin(azimuth), math.sin(theta) * math.cos(azimuth), math.cos(theta))
            rgb = lookup(d)
            if dot(rgb, LUMINANCE) > best:
                best, spot = dot(rgb, LUMINANCE), d
            for name, normal in NORMALS.items():
                facing = dot(d, normal) * solid
                if facing > 0.0:
                    for c in range(3):
                        totals[name][c] += facing * rgb[c]
    return totals, spot


def atan2_turns(y, x):
    return math.atan2(y, x) / (2 * math.pi)


def local(columns, d):
    """The components along a transformation's columns."""
    return tuple(dot(column, d) for column in columns)


def text_of(folder, target, ending):
    with open(os.path.join(folder, target, "rig." + ending), encoding="ascii") as file:
        return file.read()


def found(pattern, text):
    return re.search(pattern, text, re.S).group(1)


def numbers(text):
    return [float(word) for word in re.split(r"[,\s()\[\]]+", text.strip()) if word]


# Each: the picture's name, and the nits per channel of a direction by the picture.


def usd(folder):
    """OpenEXR's lat-long: u = 1/2 − longitude/360°, longitude 0 at +Z, 90° at +X, latitude towards +Y."""
    text = found(r'def DomeLight(.*)', text_of(folder, "usd", "usda"))
    m = numbers(found(r"xformOp:transform = (.*?)\n", text))
    columns = [m[4 * k : 4 * k + 3] for k in range(3)]  # rows of a matrix for row vectors
    scale = float(found(r"intensity = (\S+)", text))
    assert found(r"inputs:color = \((.*?)\)", text) == "1, 1, 1" and 'format = "latlong"' in text
    name = found(r"@\./(.*?)@", text)
    picture = Picture(os.path.join(folder, "usd", name))

    def lookup(d):
        x, y, z = local(columns, d)
        return [scale * c for c in picture.at(0.5 - atan2_turns(x, z), math.acos(y) / math.pi)]

    return lookup


def mitsuba(folder):
    """u = atan2(x, −z)/2π, v = acos(y)/π in the emitter's axes."""
    text = found(r'type="envmap">(.*)', text_of(folder, "mitsuba", "xml"))
    m = numbers(found(r'matrix value="(.*?)"', text))
    columns = [[m[4 * row + k] for row in range(3)] for k in range(3)]
    scale = float(found(r'name="scale" value="(.*?)"', text))
    picture = Picture(os.path.join(folder, "mitsuba", found(r'name="filename" value="(.*?)"', text)))

    def lookup(d):
        x, y, z = local(columns, d)
        return [scale * c for c in picture.at(atan2_turns(x, -z), math.acos(y) / math.pi)]

    return lookup


def luxcore(folder):
    """u = φ/2π counted from +X towards +Y, v = acos(z)/π in the light's axes, which may be a mirror image."""
    text = text_of(folder, "luxcore", "scn")
    prefix = r"scene\.lights\.(?:sky)\."
    m = numbers(found(prefix + r"transformation = (.*?)\n", text))
    columns = [m[4 * k : 4 * k + 3] for k in range(3)]
    gain = numbers(found(prefix + r"gain = (.*?)\n", text))
    assert found(prefix + r"gamma = (\S+)", text) == "1"
    picture = Picture(os.path.join(folder, "luxcore", found(prefix + r'file = "(.*?)"', text)))

    def lookup(d):
        x, y, z = local(columns, d)
        return [g * c for g, c in zip(gain, picture.at(atan2_turns(y, x), math.acos(z) / math.pi))]

    return lookup


def pbrt(folder):
    """EqualAreaSphereToSquare in world axes."""
    text = found(r"AttributeBegin\n  # sky(.*?)AttributeEnd", text_of(folder, "pbrt", "pbrt"))
    assert "Transform" not in text and "Rotate" not in text
    scale = float(found(r'"float scale" \[ (\S+) \]', text))
    picture = Picture(os.path.join(folder, "pbrt", found(r'"string filename" "(.*?)"', text)))
    assert picture.width == picture.height

    def lookup(d):
        x, y, z = (abs(c) for c in d)
        r = math.sqrt(max(1 - z, 0.0))
        turn = math.atan2(y, x) * 2 / math.pi
        v = turn * r
        u = r - v
        if d[2] < 0:
            u, v = 1 - v, 1 - u
        u, v = math.copysign(u, d[0]), math.copysign(v, d[1])
        return [scale * c for c in picture.at(min((u + 1) / 2, 1 - 1e-12), min((v + 1) / 2, 1 - 1e-12))]

    return lookup


def blender(folder):
    """u = 1/2 − φ/2π, v = acos(z)/π from above; the mapping node turns the direction. A watt is 177.83 lm."""
    text = text_of(folder, "blender", "py")
    turn = math.radians(float(found(r"math\.radians\((\S+?)\)", text)))
    strength, name = re.search(r'sky_world\("sky", \(1, 1, 1\), (\S+), "(.*?)"\)', text).groups()
    picture = Picture(os.path.join(folder, "blender", name))

    def lookup(d):
        x = math.cos(turn) * d[0] - math.sin(turn) * d[1]
        y = math.sin(turn) * d[0] + math.cos(turn) * d[1]
        return [177.83 * float(strength) * c for c in picture.at(0.5 - atan2_turns(y, x), math.acos(d[2]) / math.pi)]

    return lookup


def radiance(folder):
    """By the functions of the .cal, in watts of 179 lm and Radiance's own channels, whose luminance alone is compared."""
    text = text_of(folder, "radiance", "rad")
    name = found(r"sky_red sky_green sky_blue (\S+)", text)
    assert found(r"\n(4 0 0 1 360)\n", text)
    glow = numbers(found(r"glow sky\n0\n0\n4 (.*?)\n", text))
    assert glow[3] == 0.0
    cal = re.sub(r"\{.*?\}", "", text_of(folder, "radiance", "cal"), flags=re.S).replace("if(", "choose(")
    world = {"atan2": math.atan2, "sqrt": math.sqrt, "PI": math.pi, "max": max}
    program = ["def choose(a, b, c): return b if a > 0 else c"]
    coordinates = []
    for line in cal.replace("\n", " ").split(";"):
        if "=" not in line:
            continue
        left, right = (part.strip() for part in line.split("=", 1))
        if not left.startswith(("sky", "own", "kept")):
            continue
        if "(" in left:
            # The division for black is not evaluated lazily here.
            program.append(f"def {left}: return {right}" if "kept" not in left else
                           f"def {left}: return {right} if own_luminance(r, g, b) > 0 else 0")
        else:
            program.append(f"def {left}(Dx, Dy, Dz): return {right}")
            coordinates.append(left)
    exec("\n".join(program), world)
    assert coordinates == ["sky_u", "sky_v"]
    picture = Picture(os.path.join(folder, "radiance", name))
    weights = (0.265074126, 0.670114631, 0.064811243)

    def lookup(d):
        # Two wide and one high, between the middles of the first and last pixels, from below.
        u = (world["sky_u"](*d) / 2 * (picture.width - 1) + 0.5) / picture.width
        v = (world["sky_v"](*d) * (picture.height - 1) + 0.5) / picture.height
        rgb = middle_read(picture.at(u, 1 - v))
        own = [g * world[f"sky_{c}"](*rgb) for g, c in zip(glow, ("red", "green", "blue"))]
        return [179.0 * dot(own, weights)] * 3

    return lookup


def y_up(d):
    return d[0], d[2], -d[1]


def left_handed_y_up(d):
    return d[0], d[2], d[1]


def godot(folder):
    """u = atan2(x, −z)/2π, v = acos(y)/π after the environment's rotation, of half a turn: either sense."""
    text = text_of(folder, "godot", "tscn")
    turn = numbers(found(r"sky_rotation = Vector3(\(.*?\))", text))
    assert turn[0] == turn[2] == 0.0 and abs(turn[1] - math.pi) < 1e-9 and "background_mode = 2" in text
    scale = float(found(r"background_intensity = (\S+)", text))
    assert found(r"\nenergy_multiplier = (\S+)", text) == found(r"background_energy_multiplier = (\S+)", text) == "1.0"
    picture = Picture(os.path.join(folder, "godot", found(r'path="([^"]*)" id="sky"', text)))

    def lookup(d):
        x, y, z = y_up(d)
        x, z = -x, -z
        return [scale * c for c in picture.at(atan2_turns(x, -z), math.acos(y) / math.pi)]

    return lookup


def threejs(folder):
    """u = 1/2 + atan2(z, x)/2π, after addSky() has moved the first quarter of each row to its end."""
    text = text_of(folder, "threejs", "js")
    scale = float(found(r"environmentIntensity = ([\d.e+-]+);", text))
    picture = Picture(os.path.join(folder, "threejs", found(r"new URL\('(.*?)'", text)))
    assert "data.copyWithin(start, start + row / 4, start + row)" in text and "data.set(west, start + 3 * row / 4)" in text

    def lookup(d):
        x, y, z = y_up(d)
        return [scale * c for c in picture.at(0.5 + atan2_turns(z, x) + 0.25, math.acos(y) / math.pi)]

    return lookup


def babylon(folder):
    """u = 1/2 + atan2(x, z)/2π: the faces of PanoramaToCubeMapTools on those of a cube map."""
    text = text_of(folder, "babylon", "js")
    scale = float(found(r"environmentIntensity = ([\d.e+-]+);", text))
    picture = Picture(os.path.join(folder, "babylon", found(r"new URL\('(.*?)'", text)))

    def lookup(d):
        x, y, z = left_handed_y_up(d)
        return [scale * c for c in picture.at(0.5 + atan2_turns(x, z), math.acos(y) / math.pi)]

    return lookup


def unity(folder):
    """u = 1 − atan2(x, −z)/2π, of HDRP's DirectionToLatLongCoordinate."""
    text = text_of(folder, "unity", "cs")
    scale = float(found(r'"multiplier", ([\d.e+-]+)f', text))
    assert '"rotation", 0f' in text and '"skyIntensityMode", 2' in text
    picture = Picture(os.path.join(folder, "unity", found(r'EndsWith\("/(rig\.sky\.exr)"\)', text)))

    def lookup(d):
        x, y, z = left_handed_y_up(d)
        return [scale * c for c in picture.at(1 - atan2_turns(x, -z), math.acos(y) / math.pi)]

    return lookup


def unreal(folder):
    """u = 1/2 + atan2(x, −y)/2π, left-handed with Z up."""
    text = text_of(folder, "unreal", "py")
    name, scale = re.search(r'\nsky\("sky", "(.*?)", (\S+)\)', text).groups()
    assert "source_cubemap_angle=0.0" in text
    picture = Picture(os.path.join(folder, "unreal", name))

    def lookup(d):
        x, y, z = d[0], -d[1], d[2]
        return [float(scale) * c for c in picture.at(0.5 + atan2_turns(x, -y), math.acos(z) / math.pi)]

    return lookup


def raw(folder):
    """As the sidecar says: azimuths from north over east, north in the middle."""
    with open(os.path.join(folder, "raw", "rig.sky.exr.json"), encoding="utf-8") as file:
        sidecar = json.load(file)
    picture = Picture(os.path.join(folder, "raw", sidecar["files"][0]["file"]))
    scale = sidecar["nits_per_unit"]

    def lookup(d):
        return [scale * c for c in picture.at(0.5 + atan2_turns(d[0], d[1]), math.acos(d[2]) / math.pi)]

    return lookup


def main(gonio):
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        run = lambda *words: subprocess.run([gonio, *words], cwd=folder, check=True, stdout=subprocess.PIPE).stdout
        run("sky", "convert", SKY, "-s", "128", "-o", "source.exr", "-q")
        with open(os.path.join(folder, "rig.json"), "w", encoding="ascii") as rig:
            json.dump({"schema": "gonio.rig/1", "lights": [], "sky": f"image:source.exr,rotate={TURN_DEG}deg"}, rig)
        run("import", "rig.json", "--to", TARGETS, "-O", ".", "-q")
        truth = json.loads(run("sky", "info", f"image:source.exr,rotate={TURN_DEG}deg", "--json"))
        of_sky = {"up": truth["horizontal_lx"], **truth["vertical_lx"]}
        azimuth = math.radians(truth["brightest"]["azimuth_deg"])
        elevation = math.radians(truth["brightest"]["elevation_deg"])
        sun = (math.sin(azimuth) * math.cos(elevation), math.cos(azimuth) * math.cos(elevation), math.sin(elevation))
        own_color = None
        for target in (raw, usd, mitsuba, luxcore, pbrt, blender, radiance, godot, threejs, babylon, unity, unreal):
            totals, spot = measured(target(folder))
            lux = {name: dot(rgb, LUMINANCE) for name, rgb in totals.items()}
            if target is radiance:
                lux = {name: rgb[0] for name, rgb in totals.items()}
            worst = max(abs(lux[name] / of_sky[name] - 1) for name in lux)
            horizontal = abs(lux["up"] / of_sky["up"] - 1)
            away = math.degrees(math.acos(min(dot(spot, sun), 1.0)))
            color = [c / lux["up"] for c in totals["up"]]
            own_color = own_color or color
            shift = 0.0 if target is radiance else max(abs(a - b) for a, b in zip(color, own_color))
            print(f"{target.__name__}: horizontal {horizontal:.1e}, five planes {worst:.1e}, colour {shift:.1e}, "
                  f"spot {away:.1f} degrees away")
            # A texel is 2.8 degrees.
            failed |= not (horizontal < 1e-3 and worst < 4e-3 and away < 4.0 and shift < 2e-3)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[1])))
