#!/usr/bin/env python3
"""image_check.py GONIO: imports lights with images for programs that are not run here, and lights points with what it wrote.

The formulas of the programs' projectors and textured rectangles, with their frames and the corners where their pictures
begin, are written here again. Illuminances are compared light by light with those of gonio probe; nothing else is shared
with the tool. The picture has another colour in each pixel, so that nothing fits when it is turned or mirrored.
"""
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

try:
    import OpenImageIO as oiio
except ImportError:
    print("no python3-openimageio: skipped")
    sys.exit(77)

LUMINANCE = (0.21263900587151027, 0.71516867876775592, 0.072192315360733714)
POINTS = [(-0.6, 0.5, 0.0), (0.1, -0.2, 0.0), (0.5, -0.6, 0.0), (0.7, 0.6, 0.1), (0.2, 0.4, 0.2), (-0.3, -0.5, 0.0)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def numbers(text):
    return [float(word) for word in re.split(r"[,\s()\[\]]+", text.strip()) if word]


class Picture:
    """Luminances of a file; (0, 0) is its top left corner."""

    def __init__(self, folder, file, srgb=False):
        self.image, self.srgb = oiio.ImageBuf(os.path.join(folder, file)), srgb
        self.width, self.height = self.image.spec().width, self.image.spec().height

    def texel(self, i, j):
        pixel = self.image.getpixel(i, j)[:3]
        if self.srgb:
            pixel = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in pixel]
        return dot(pixel, LUMINANCE)

    def nearest(self, u, v):
        if not (0 <= u <= 1 and 0 <= v <= 1):
            return 0.0
        return self.texel(min(int(u * self.width), self.width - 1), min(int(v * self.height), self.height - 1))

    def look(self, u, v):
        """Filtered, clamped at the edges, black outside."""
        if not (0 <= u <= 1 and 0 <= v <= 1):
            return 0.0
        x, y = u * self.width - 0.5, v * self.height - 0.5
        i, j = math.floor(x), math.floor(y)
        at = lambda i, j: self.texel(min(max(i, 0), self.width - 1), min(max(j, 0), self.height - 1))
        s, t = x - i, y - j
        return (at(i, j) * (1 - s) + at(i + 1, j) * s) * (1 - t) + (at(i, j + 1) * (1 - s) + at(i + 1, j + 1) * s) * t


def projector(columns, intensity):
    """E on planes that look up; intensity(x, y, z) by the direction along the columns x, y, z of the frame."""
    x, y, z, origin = columns

    def lux(p):
        away = minus(p, origin)
        value = intensity(*(dot(away, axis) / math.sqrt(dot(away, away)) for axis in (x, y, z)))
        return value * max(-away[2], 0.0) / dot(away, away) ** 1.5

    return lux


def panel(corners, picture, nits):
    """E of a rectangle by its corners where the picture has its top left, top right and bottom left, seen from the side
    from which these are clockwise."""
    origin, right, below = corners
    across, down = minus(right, origin), minus(below, origin)
    normal = (across[1] * down[2] - across[2] * down[1], across[2] * down[0] - across[0] * down[2],
              across[0] * down[1] - across[1] * down[0])
    normal = tuple(-c for c in normal)  # of its length is the area

    def lux(p):
        total = 0.0
        columns, rows = 4 * picture.width, 4 * picture.height
        for j in range(rows):
            for i in range(columns):
                u, v = (i + 0.5) / columns, (j + 0.5) / rows
                away = minus(p, tuple(o + u * a + v * d for o, a, d in zip(origin, across, down)))
                facing = dot(away, normal)
                if facing > 0.0 and away[2] < 0.0:
                    total += picture.nearest(u, v) * facing * -away[2] / dot(away, away) ** 2
        return nits * total / columns / rows

    return lux


def affine(columns, p):
    return tuple(o + p[0] * a + p[1] * b + p[2] * c for a, b, c, o in zip(*columns))


def pbrt(folder):
    with open(os.path.join(folder, "images.pbrt"), encoding="ascii") as file:
        text = file.read()
    lights = {}
    for body in re.findall(r"AttributeBegin\n(.*?)AttributeEnd\n", text, re.S):
        name = re.search(r"# (\w+)", body)[1]
        m = numbers(re.search(r"ConcatTransform \[(.*?)\]", body)[1])
        columns = [m[4 * k : 4 * k + 3] for k in range(4)]
        picture = Picture(folder, re.search(r'"string filename" "(.*?)"', body)[1])
        scale = float(re.search(r'"float scale" \[ (\S+) \]', body)[1])
        if "projection" in body:
            assert "Scale 1 1 -1" in body
            columns[2] = [-c for c in columns[2]]
            slope = math.tan(math.radians(float(re.search(r'"float fov" \[ (\S+) \]', body)[1]) / 2))
            aspect = picture.width / picture.height

            def intensity(x, y, z, picture=picture, scale=scale, slope=slope, aspect=aspect):
                if z <= 0:
                    return 0.0
                wide, high = max(aspect, 1.0), max(1 / aspect, 1.0)
                return scale * picture.nearest(0.5 + 0.5 * x / z / slope / wide, 0.5 - 0.5 * y / z / slope / high)

            lights[name] = projector(columns, intensity)
        else:
            p = numbers(re.search(r'"point3 P" \[(.*?)\]', body)[1])
            p00, p10, p01, p11 = (affine(columns, p[3 * k : 3 * k + 3]) for k in range(4))
            lights[name] = panel((p01, p11, p00), picture, scale)  # v = 1 is the top
    return lights


def mitsuba(folder):
    parser = ElementTree.XMLParser(target=ElementTree.TreeBuilder(insert_comments=True))
    lights, name = {}, None
    for element in ElementTree.parse(os.path.join(folder, "images.xml"), parser).getroot():
        if element.tag is ElementTree.Comment:
            name = element.text.strip()
            continue
        m = numbers(element.find("transform/matrix").get("value"))
        columns = [(m[k], m[4 + k], m[8 + k]) for k in range(4)]
        texture = element.find(".//texture")
        picture = Picture(folder, texture.find("string[@name='filename']").get("value"))
        if element.get("type") == "projector":
            assert element.find("string[@name='fov_axis']").get("value") == "x"
            wide = math.tan(math.radians(float(element.find("float[@name='fov']").get("value")) / 2))
            high = wide * picture.height / picture.width
            scale = float(element.find("float[@name='scale']").get("value"))

            def intensity(x, y, z, picture=picture, scale=scale, wide=wide, high=high):
                if z <= 0:
                    return 0.0
                return math.pi * scale * picture.look(0.5 - 0.5 * x / z / wide, 0.5 - 0.5 * y / z / high) / z**3

            lights[name] = projector(columns, intensity)
        else:
            assert element.get("type") == "rectangle" and texture.get("name") == "radiance"
            # The place of a texel: x = 2u − 1, y = 2v − 1, where (u, v) is turned by to_uv into its row from the top.
            stretch = float(texture.find("transform[@name='to_uv']/scale").get("y"))
            shift = float(texture.find("transform[@name='to_uv']/translate").get("y"))
            at = lambda u, row: affine(columns, (2 * u - 1, 2 * (row - shift) / stretch - 1, 0))
            lights.setdefault(name, panel((at(0, 0), at(1, 0), at(0, 1)), picture, 1.0))
    return lights


def usd(folder):
    with open(os.path.join(folder, "images.usda"), encoding="ascii") as file:
        text = file.read()
    lights = {}
    for name, body in re.findall(r'    def RectLight "(\w+)" \((.*?)\n    }\n', text, re.S):
        get = {key.split(":", 1)[-1]: value for key, value in re.findall(r"(?:float|color3f|asset) ([\w:]+) = (.*)", body)}
        m = numbers(re.search(r"matrix4d xformOp:transform = (.*)", body)[1])
        columns = [m[4 * k : 4 * k + 3] for k in range(4)]
        picture = Picture(folder, get["texture:file"].strip("@").removeprefix("./"))
        x, y = float(get["width"]) / 2, float(get["height"]) / 2
        at = lambda x, y: affine(columns, (x, y, 0))
        lights[name] = panel((at(x, y), at(-x, y), at(x, -y)), picture, float(get["intensity"]))
    return lights


def luxcore(folder):
    properties = {}
    with open(os.path.join(folder, "images.scn"), encoding="ascii") as file:
        for line in file:
            if not line.startswith("#"):
                key, value = line.split("=", 1)
                properties[key.strip()] = value.strip().strip('"')
    lights = {}
    for name in {key.split(".")[2] for key in properties if key.startswith("scene.textures.")}:
        shape, texture = f"scene.shapes.{name}.", f"scene.textures.{name}."
        assert properties[texture + "gamma"] == "1" and properties[f"scene.materials.{name}.emission"] == name
        flat, places = numbers(properties[shape + "vertices"]), numbers(properties[shape + "uvs"])
        corner = {(places[2 * k], places[2 * k + 1]): tuple(flat[3 * k : 3 * k + 3]) for k in range(4)}
        gain = numbers(properties[f"scene.materials.{name}.emission.gain"])[0]
        lights[name] = panel((corner[0, 0], corner[1, 0], corner[0, 1]), Picture(folder, properties[texture + "file"]), gain)
    return lights


def threejs(folder):
    with open(os.path.join(folder, "images.js"), encoding="ascii") as file:
        text = file.read()
    lights = {}
    world = lambda v: (v[0], -v[2], v[1])  # from Y up
    number, vector = r"([-\d.e]+)", r"\[(.*?)\]"
    call = rf'place\(projectorLight\(new Color\((.*?)\), {number}, {number}, {number}, "(.*?)", {vector}\), "(\w+)", {vector}, {vector}\)'
    for color, candela, _, angle, file, up, name, position, aim in re.findall(call, text):
        assert numbers(color) == [1, 1, 1]
        z, up = world(numbers(aim)), world(numbers(up))
        z = tuple(c / math.sqrt(dot(z, z)) for c in z)
        x = (z[1] * up[2] - z[2] * up[1], z[2] * up[0] - z[0] * up[2], z[0] * up[1] - z[1] * up[0])
        slope, picture = math.tan(float(angle)), Picture(folder, file)

        def intensity(x, y, z, picture=picture, slope=slope, candela=float(candela)):
            return candela * picture.look(0.5 + 0.5 * x / z / slope, 0.5 - 0.5 * y / z / slope) if z > 0 else 0.0

        lights[name] = projector((x, up, z, world(numbers(position))), intensity)
    return lights


def godot(folder):
    with open(os.path.join(folder, "images.tscn"), encoding="ascii") as file:
        text = file.read()
    textures = dict(reversed(pair) for pair in re.findall(r'ext_resource type="Texture2D" path="(.*?)" id="(.*?)"', text))
    world = lambda v: (v[0], -v[2], v[1])
    lights = {}
    for name, body in re.findall(r'\[node name="(\w+)" type="SpotLight3D" parent="\."\]\n(.*?)(?=\n\[|\Z)', text, re.S):
        get = dict(line.split(" = ", 1) for line in body.strip().split("\n"))
        projected = re.search(r'"(.*)"', get["light_projector"])[1]
        if not projected.startswith("image"):
            continue  # the far profile of a panel
        m = numbers(get["transform"].replace("Transform3D", ""))
        columns = [world((m[k], m[3 + k], m[6 + k])) for k in range(3)] + [world(m[9:])]
        picture = Picture(folder, textures[projected], srgb=True)
        assert get["shadow_enabled"] == "true"
        assert all(abs(c - 1) < 1e-9 for c in numbers(get["light_color"].replace("Color", "")))
        outer, level = math.radians(float(get["spot_angle"])), float(get["light_intensity_lumens"]) / math.pi

        def intensity(x, y, z, picture=picture, outer=outer, level=level, power=float(get["spot_angle_attenuation"])):
            rim = (1 - max(-z, math.cos(outer))) / (1 - math.cos(outer))
            if rim >= 1:
                return 0.0
            across = -z * math.tan(outer)
            return level * (1 - rim**power) * picture.look(0.5 + 0.5 * x / across, 0.5 - 0.5 * y / across)

        lights[name] = projector(columns, intensity)
    return lights


def unity(folder):
    with open(os.path.join(folder, "images.cs"), encoding="ascii") as file:
        text = file.read()
    world = lambda v: (v[0], v[2], v[1])  # from left-handed and Y up
    triple = lambda words: world(numbers(words.replace("f", "")))
    lights = {}
    call = (r'Add\(root, "(\w+)", LightType.Spot, new Vector3\((.*?)\),\s*new Vector3\((.*?)\), new Vector3\((.*?)\),\s*'
            r'new Color\(1f, 1f, 1f\), (\S+)f, LightUnit.Candela\);\s*light.spotAngle = (\S+)f;.*?Cookie\("(.*?)"\)')
    for name, position, aim, up, candela, angle, cookie in re.findall(call, text, re.S):
        z, y = triple(aim), triple(up)
        # Right of a light that looks along its +Z with +Y up, left-handed: Y × Z, mirrored in these axes.
        x = (z[1] * y[2] - z[2] * y[1], z[2] * y[0] - z[0] * y[2], z[0] * y[1] - z[1] * y[0])
        slope, picture = math.tan(math.radians(float(angle) / 2)), Picture(folder, cookie + ".exr")

        def intensity(x, y, z, picture=picture, slope=slope, candela=float(candela)):
            return candela * picture.look(0.5 + 0.5 * x / z / slope, 0.5 - 0.5 * y / z / slope) if z > 0 else 0.0

        lights[name] = projector((x, y, z, triple(position)), intensity)
    return lights


(gonio,) = sys.argv[1:]
lights = [
    {"name": "spot", "shape": "spot:outer=32deg,inner=10deg,mask=picture.exr", "intensity": "900lm",
     "position": [0.2, 0.1, 2], "direction": [-0.1, 0.05, -1], "rotate": "25deg"},
    {"name": "tall", "shape": "frustum:h=40deg,v=62deg,mask=picture.exr", "intensity": "900lm", "color": "3000K",
     "position": [-0.2, 0.1, 2], "direction": [0.1, -0.1, -1], "up": [1, 0.3, 0]},
    {"name": "wide", "shape": "frustum:h=66deg,v=44deg,mask=picture.exr", "intensity": "1200cd",
     "position": [0.1, -0.1, 1.9], "direction": [0.05, 0.1, -1]},
    {"name": "panel", "shape": "rect:w=60cm,h=40cm,mask=picture.exr", "intensity": "2000lm", "color": "4000K",
     "position": [0.3, -0.2, 0.9], "direction": [-0.4, 0.3, -1], "rotate": "30deg"},
    {"name": "twin", "shape": "rect:w=30cm,h=50cm,two-sided,mask=picture.exr", "intensity": "2000lm",
     "position": [-0.4, 0.2, 0.8], "direction": [0.3, 0.2, -1]},
]
panels, projectors = {"panel", "twin"}, {"spot", "tall", "wide"}
random.seed(11)
failed = False
with tempfile.TemporaryDirectory() as folder:
    picture = oiio.ImageBuf(oiio.ImageSpec(9, 6, 3, oiio.HALF))
    for j in range(6):
        for i in range(9):
            picture.setpixel(i, j, tuple(random.uniform(0.05, 1.0) for _ in range(3)))
    picture.write(os.path.join(folder, "picture.exr"))
    rig = os.path.join(folder, "images.json")
    with open(rig, "w", encoding="ascii") as file:
        json.dump({"schema": "gonio.rig/1", "lights": lights}, file)
    targets = {"pbrt": (pbrt, panels | projectors), "mitsuba": (mitsuba, panels | projectors), "usd": (usd, panels),
               "luxcore": (luxcore, panels), "threejs": (threejs, projectors), "godot": (godot, projectors),
               "unity": (unity, projectors)}
    subprocess.run([gonio, "import", rig, "--to", ",".join(targets), "-O", folder, "-q"], check=True)
    truth = []
    for point in POINTS:
        said = subprocess.run([gonio, "probe", "--rig", rig, "--at", ",".join(map(str, point)), "--normal", "0,0,1",
                               "--json"], check=True, capture_output=True, text=True).stdout
        truth.append({light["name"]: light["illuminance_lx"] for light in json.loads(said)["points"][0]["lights"]})
    for target, (read, expected) in targets.items():
        written = {name: light for name, light in read(os.path.join(folder, target)).items() if name in panels | projectors}
        assert set(written) == expected, (target, sorted(written))
        for name in sorted(expected):
            brightest = max(values[name] for values in truth)
            lit = sum(values[name] > 0.05 * brightest for values in truth)
            assert lit >= 3, (name, lit)
            worst = max(abs(written[name](point) - values[name]) for point, values in zip(POINTS, truth)) / brightest
            # Texels that cut the pixels' bilinear pieces, nearest ones, 8 bits in Godot; midpoints of panels.
            if worst > (0.01 if target == "godot" else 0.005):
                print(f"{target}: {name} is off by {worst:.4f} of {brightest:.4g} lx")
                failed = True
        print(f"{target}: {len(expected)} lights at {len(POINTS)} points")
sys.exit(1 if failed else 0)
