#!/usr/bin/env python3
"""scene_check.py GONIO PROFILES: imports a rig for programs that are not run here, and lights points with what it wrote.

The formulas of Mitsuba's, LuxCore's, Godot's and UsdLux' lights, their frames and their look-ups of textures and of LM-63
are written here again, in photometric units; areas are integrated over their surfaces. Illuminances are compared light
by light with those of gonio probe; nothing else is shared with the tool.
"""
import json
import math
import os
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
POINTS = [(-1.2, 0.9, 0.0), (0.0, 0.0, 0.0), (0.7, -0.8, 0.0), (1.6, 1.4, 0.0), (0.3, 0.4, 0.2)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return tuple(x / math.sqrt(dot(a, a)) for x in a)


def numbers(text):
    return [float(word) for word in re.split(r"[,\s()]+", text.strip()) if word]


def punctual(position, intensity):
    """E of an intensity by world direction, on planes that look up."""

    def illuminance(p):
        away = minus(p, position)
        return intensity(away) * max(-away[2], 0.0) / dot(away, away) ** 1.5

    return illuminance


def surface(samples, nits):
    """E of a Lambertian surface: (point, normal, area) of each sample."""

    def illuminance(p):
        total = 0.0
        for at, normal, area in samples:
            away = minus(p, at)
            facing = dot(away, normal)
            if facing > 0.0 and away[2] < 0.0:
                total += area * facing * -away[2] / dot(away, away) ** 2
        return nits * total

    return illuminance


def flat(columns, kind, n=48):
    """A square of [-1, 1]², or the disk in it, through the columns x, y, z (its normal) and origin."""
    x, y, _, origin = columns
    normal = unit(cross(x, y))
    element = math.sqrt(dot(cross(x, y), cross(x, y)))
    samples = []
    for i in range(n):
        for j in range(n):
            if kind == "disk":
                inner, outer = i / n, (i + 1) / n
                turn = 2 * math.pi * (j + 0.5) / n
                radius = math.sqrt((inner * inner + outer * outer) / 2)
                u, v = radius * math.cos(turn), radius * math.sin(turn)
                area = math.pi * (outer * outer - inner * inner) / n
            else:
                u, v, area = (2 * i + 1) / n - 1, (2 * j + 1) / n - 1, 4 / n / n
            at = tuple(o + u * a + v * b for o, a, b in zip(origin, x, y))
            samples.append((at, normal, area * element))
    return samples


def sphere(center, radius, hidden=lambda p: False, n=72):
    samples = []
    for i in range(n):
        z = (2 * i + 1) / n - 1
        for j in range(2 * n):
            turn = math.pi * (j + 0.5) / n
            normal = (math.sqrt(1 - z * z) * math.cos(turn), math.sqrt(1 - z * z) * math.sin(turn), z)
            at = tuple(c + radius * m for c, m in zip(center, normal))
            if not hidden(at):
                samples.append((at, normal, 4 * math.pi * radius * radius / n / n / 2))
    return samples


def cylinder(p0, p1, radius, n=96):
    axis = minus(p1, p0)
    length = math.sqrt(dot(axis, axis))
    axis = unit(axis)
    x = unit(cross(axis, (0, 0, 1) if abs(axis[2]) < 0.9 else (1, 0, 0)))
    y = cross(axis, x)
    samples = []
    for i in range(n):
        for j in range(n):
            turn = 2 * math.pi * (j + 0.5) / n
            normal = tuple(math.cos(turn) * a + math.sin(turn) * b for a, b in zip(x, y))
            along = length * (i + 0.5) / n
            at = tuple(o + along * a + radius * m for o, a, m in zip(p0, axis, normal))
            samples.append((at, normal, 2 * math.pi * radius * length / n / n))
    return samples


class Picture:
    """Texels of a file, its luminance; `look` filters linearly and clamps at the edges."""

    def __init__(self, path, srgb=False):
        image = oiio.ImageBuf(path)
        self.width, self.height = image.spec().width, image.spec().height
        channels = image.spec().nchannels
        self.texels = []
        for j in range(self.height):
            row = []
            for i in range(self.width):
                pixel = image.getpixel(i, j)
                value = dot(pixel, LUMINANCE) if channels >= 3 else pixel[0]
                if srgb:
                    value = value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4
                row.append(value)
            self.texels.append(row)

    def look(self, u, v, wrap=False):
        x, y = u * self.width - 0.5, v * self.height - 0.5
        i, j = math.floor(x), math.floor(y)

        def at(i, j):
            i = i % self.width if wrap else min(max(i, 0), self.width - 1)
            return self.texels[min(max(j, 0), self.height - 1)][i]

        s, t = x - i, y - j
        return (at(i, j) * (1 - s) + at(i + 1, j) * s) * (1 - t) + (at(i, j + 1) * (1 - s) + at(i + 1, j + 1) * s) * t


class Ies:
    """The portable dialect: type C, planes over the full turn or a single one."""

    def __init__(self, path):
        with open(path, encoding="ascii") as file:
            text = file.read()
        words = text[text.index("TILT=NONE") + 9 :].split()
        rows, planes = int(words[3]), int(words[4])
        rest = [float(word) for word in words[13:]]
        self.gammas, self.planes = rest[:rows], rest[rows : rows + planes]
        table = rest[rows + planes :]
        self.candela = [table[k * rows : (k + 1) * rows] for k in range(planes)]

    @staticmethod
    def cell(angles, angle):
        if angle < angles[0] or angle > angles[-1]:
            return None
        for k in range(len(angles) - 1):
            if angle <= angles[k + 1]:
                return k, (angle - angles[k]) / (angles[k + 1] - angles[k])
        return 0, 0.0

    def look(self, c, gamma):
        row = self.cell(self.gammas, gamma)
        if row is None:
            return 0.0
        k, t = row
        def of(plane):
            values = self.candela[plane]
            return values[k] * (1 - t) + (values[k + 1] * t if t > 0 else 0.0)
        if len(self.planes) == 1:
            return of(0)
        plane, s = self.cell(self.planes, c % 360.0)
        return of(plane) * (1 - s) + of(min(plane + 1, len(self.planes) - 1)) * s

    def flux(self):
        """4π times the mean over directions, by a fine midpoint rule."""
        total = 0.0
        for i in range(720):
            gamma = math.radians((i + 0.5) / 4)
            ring = sum(self.look(j * 2.5, (i + 0.5) / 4) for j in range(144)) / 144
            total += ring * math.sin(gamma) * math.radians(0.25) * 2 * math.pi
        return total


def mitsuba(folder, rig):
    def matrix(element):
        m = numbers(element.find("transform/matrix").get("value"))
        return [(m[k], m[4 + k], m[8 + k]) for k in range(4)]  # columns x, y, z and the origin

    def luminance(element, name):
        return dot(numbers(element.find(f"rgb[@name='{name}']").get("value")), LUMINANCE)

    def named(element, kind, name):
        found = element.find(f"{kind}[@name='{name}']").get("value")
        return numbers(found) if kind == "point" or kind == "vector" else float(found)

    parser = ElementTree.XMLParser(target=ElementTree.TreeBuilder(insert_comments=True))
    root = ElementTree.parse(os.path.join(folder, rig + ".xml"), parser).getroot()
    lights, parts = {}, []
    for element in root:
        if element.tag is ElementTree.Comment:
            parts = lights.setdefault(element.text.strip(), [])
            continue
        kind = element.get("type")
        if kind == "point":
            intensity = luminance(element, "intensity")
            parts.append(punctual(named(element, "point", "position"), lambda away, i=intensity: i))
        elif kind == "spot":
            columns, intensity = matrix(element), luminance(element, "intensity")
            cutoff, beam = named(element, "float", "cutoff_angle"), named(element, "float", "beam_width")

            def spot(away, aim=columns[2], i=intensity, cutoff=cutoff, beam=beam):
                angle = math.degrees(math.acos(dot(unit(away), aim)))
                return i * min(max((cutoff - angle) / (cutoff - beam), 0.0), 1.0)

            parts.append(punctual(columns[3], spot))
        elif kind == "projector":
            columns, scale = matrix(element), named(element, "float", "scale")
            picture = Picture(os.path.join(folder, element.find("texture/string[@name='filename']").get("value")))
            assert named(element, "float", "fov") == 90.0

            def projector(away, c=columns, scale=scale, picture=picture):
                x, y, z = (dot(away, axis) for axis in c[:3])
                if z <= 0.0 or abs(x) > z or abs(y) > z:
                    return 0.0
                return math.pi * scale * picture.look(0.5 - 0.5 * x / z, 0.5 - 0.5 * y / z) / (
                    z / math.sqrt(dot(away, away))) ** 3

            parts.append(punctual(columns[3], projector))
        elif kind == "directional":
            aim, lux = named(element, "vector", "direction"), luminance(element, "irradiance")
            parts.append(lambda p, e=lux * -unit(aim)[2]: e)
        elif element.tag == "shape":
            nits = luminance(element.find("emitter"), "radiance")
            if kind in ("rectangle", "disk"):
                parts.append(surface(flat(matrix(element), kind), nits))
            elif kind == "sphere":
                parts.append((named(element, "point", "center"), named(element, "float", "radius"), nits))
            elif kind == "cylinder":
                p0, p1 = named(element, "point", "p0"), named(element, "point", "p1")
                radius = named(element, "float", "radius")
                axis, middle = unit(minus(p1, p0)), tuple((a + b) / 2 for a, b in zip(p0, p1))
                half = math.dist(p0, p1) / 2
                inside = lambda p: abs(dot(minus(p, middle), axis)) < half
                spheres = [part for part in parts if isinstance(part, tuple)]
                parts[:] = [surface(sphere(c, r, inside), n) for c, r, n in spheres]
                parts.append(surface(cylinder(p0, p1, radius), nits))
        else:
            raise ValueError(kind)
    for parts in lights.values():
        parts[:] = [surface(sphere(*part[:2]), part[2]) if isinstance(part, tuple) else part for part in parts]
    return {name: (lambda p, parts=parts: sum(part(p) for part in parts)) for name, parts in lights.items()}


def luxcore(folder, rig):
    properties = {}
    with open(os.path.join(folder, rig + ".scn"), encoding="ascii") as file:
        for line in file:
            if not line.startswith("#"):
                key, value = line.split("=", 1)
                properties[key.strip()] = value.strip().strip('"')
    lights = {}
    for name in {key.split(".")[2] for key in properties if key.startswith("scene.lights.")}:
        get = lambda key, name=name: properties[f"scene.lights.{name}.{key}"]
        kind, color = get("type"), numbers(get("color"))
        lumens = float(properties.get(f"scene.lights.{name}.power", 0)) * float(
            properties.get(f"scene.lights.{name}.efficency", 0)) * dot(color, LUMINANCE) / dot(color, LUMINANCE)
        if kind == "point":
            lights[name] = punctual(numbers(get("position")), lambda away, i=lumens / 4 / math.pi: i)
        elif kind == "sphere":
            radius = float(get("radius"))
            lights[name] = surface(sphere(numbers(get("position")), radius), lumens / (2 * math.pi * radius) ** 2)
        elif kind == "distant":
            lux = numbers(get("gain"))[0] * math.pi * math.sin(math.radians(float(get("theta")))) ** 2
            lights[name] = lambda p, e=lux * -unit(numbers(get("direction")))[2]: e
        elif kind == "mappoint":
            m = numbers(get("transformation"))
            columns = [m[4 * k : 4 * k + 3] for k in range(4)]
            profile = Ies(os.path.join(folder, get("iesfile")))
            mean = profile.flux() / 4 / math.pi
            assert get("flipz") == "1"

            def mappoint(away, c=columns, profile=profile, level=lumens / 4 / math.pi / mean):
                x, y, z = (dot(unit(away), axis) for axis in c[:3])
                return level * profile.look(math.degrees(math.atan2(y, x)), math.degrees(math.acos(-z)))

            lights[name] = punctual(columns[3], mappoint)
    for name in {key.split(".")[2] for key in properties if key.startswith("scene.shapes.")}:
        flat_points = numbers(properties[f"scene.shapes.{name}.vertices"])
        points = [tuple(flat_points[k : k + 3]) for k in range(0, len(flat_points), 3)]
        indices = [int(word) for word in properties[f"scene.shapes.{name}.faces"].split()]
        nits = numbers(properties[f"scene.materials.{name}.emission.gain"])[0]
        samples = []
        for k in range(0, len(indices), 3):
            a, b, c = (points[index] for index in indices[k : k + 3])
            normal = cross(minus(b, a), minus(c, a))
            n = math.ceil(max(math.dist(a, b), math.dist(b, c), math.dist(c, a)) / 0.03)
            for i in range(n):  # the middles of n² triangles of the same size
                for j in range(n - i):
                    for shift in (1 / 3, 2 / 3) if j < n - i - 1 else (1 / 3,):
                        u, v = (i + shift) / n, (j + shift) / n
                        at = tuple(o + u * (p - o) + v * (q - o) for o, p, q in zip(a, b, c))
                        samples.append((at, unit(normal), math.sqrt(dot(normal, normal)) / 2 / n / n))
        lights[name] = surface(samples, nits)
    return lights


def godot(folder, rig):
    with open(os.path.join(folder, rig + ".tscn"), encoding="ascii") as file:
        text = file.read()
    textures = dict(reversed(pair) for pair in re.findall(r'ext_resource type="Texture2D" path="(.*?)" id="(.*?)"', text))
    world = lambda v: (v[0], -v[2], v[1])  # from Y up
    lights = {}
    for name, kind, body in re.findall(r'\[node name="(\w+)" type="(\w+3D)" parent="\."\]\n(.*?)(?=\n\[|\Z)', text, re.S):
        get = dict(line.split(" = ", 1) for line in body.strip().split("\n"))
        m = numbers(get["transform"].replace("Transform3D", ""))
        basis = [world((m[k], m[3 + k], m[6 + k])) for k in range(3)]  # columns
        origin = world(m[9:])
        color = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in
                 numbers(get["light_color"].replace("Color", ""))[:3]]
        level = dot(color, LUMINANCE)
        if kind == "DirectionalLight3D":
            lights[name] = lambda p, e=float(get["light_intensity_lux"]) * level * basis[2][2]: e
            continue
        lumens = float(get["light_intensity_lumens"])
        if kind == "AreaLight3D":
            assert get["area_attenuation"] == "2.0" and get["area_normalize_energy"] == "true"
            width, height = numbers(get["area_size"].replace("Vector2", ""))
            nits = level * lumens / 2 / math.pi / width / height
            columns = [[width / 2 * c for c in basis[0]], [-height / 2 * c for c in basis[1]], None, origin]
            lights[name] = surface(flat(columns, "rectangle"), nits)
            continue
        picture = re.search(r'"(.*)"', get.get("light_projector", ""))
        picture = Picture(os.path.join(folder, textures[picture[1]]), srgb=True) if picture else None
        assert picture is None or get["shadow_enabled"] == "true"
        reach = float(get["omni_range" if kind == "OmniLight3D" else "spot_range"])
        assert get["omni_attenuation" if kind == "OmniLight3D" else "spot_attenuation"] == "2.0"
        window = lambda away, reach=reach: max(1 - (math.sqrt(dot(away, away)) / reach) ** 4, 0.0) ** 2

        def omni(away, basis=basis, level=level * lumens / 4 / math.pi, picture=picture, window=window):
            if picture is None:
                return level * window(away)
            x, y, z = unit(tuple(dot(away, axis) for axis in basis))
            # The half of the paraboloids, and the panorama's texel that stands there.
            u = math.atan2(-x, -z) if z >= 0 else 2 * math.pi - math.atan2(x, -z)
            return level * window(away) * picture.look(u / 2 / math.pi % 1.0, math.acos(-y) / math.pi, wrap=True)

        def spot(away, basis=basis, level=level * lumens / math.pi, picture=picture, window=window, get=get):
            x, y, z = (dot(away, axis) for axis in basis)
            edge = math.cos(math.radians(float(get["spot_angle"])))
            rim = (1 - max(-z / math.sqrt(dot(away, away)), edge)) / (1 - edge)
            value = level * window(away) * (1 - rim ** float(get["spot_angle_attenuation"]))
            if picture is None or value <= 0:
                return value
            across = -z * math.tan(math.radians(float(get["spot_angle"])))
            return value * picture.look(0.5 + 0.5 * x / across, 0.5 - 0.5 * y / across)

        lights[name] = punctual(origin, omni if kind == "OmniLight3D" else spot)
    return lights


def usd(folder, rig):
    with open(os.path.join(folder, rig + ".usda"), encoding="ascii") as file:
        text = file.read()
    metres = float(re.search(r"metersPerUnit = (\S+)", text)[1])
    lights = {}
    for kind, name, body in re.findall(r'    def (\w+) "(\w+)" \((.*?)\n    }\n', text, re.S):
        get = {key.split(":", 1)[-1]: value for key, value in
               re.findall(r"(?:float|bool|color3f|asset) ([\w:]+) = (.*)", body)}
        m = numbers(re.search(r"matrix4d xformOp:transform = (.*)", body)[1])
        x, y, z, origin = (m[4 * k : 4 * k + 3] for k in range(4))
        nits = float(get["intensity"]) * dot(numbers(get["color"]), LUMINANCE)
        unscaled = lambda p: tuple(c / metres for c in p)
        if kind == "DistantLight":
            e = nits * math.pi * math.sin(math.radians(float(get["angle"]) / 2)) ** 2 * z[2]
            lights[name] = lambda p, e=e: e
        elif "treatAsPoint" in get:
            candela = nits * math.pi * float(get["radius"]) ** 2
            profile = Ies(os.path.join(folder, get["shaping:ies:file"].strip("@").removeprefix("./"))) if (
                "shaping:ies:file" in get) else None

            def point(away, x=x, y=y, z=z, candela=candela, profile=profile, get=get):
                a, b, c = (dot(unit(away), axis) for axis in (x, y, z))
                angle = math.degrees(math.acos(-c))
                if profile:
                    return candela * profile.look(math.degrees(math.atan2(b, a)), angle)
                if "shaping:cone:angle" not in get:
                    return candela
                outer, soft = float(get["shaping:cone:angle"]), float(get["shaping:cone:softness"])
                t = min(max((outer - angle) / (outer * soft), 0.0), 1.0)
                return candela * t * t * (3 - 2 * t)

            lights[name] = lambda p, e=punctual(origin, point): e(unscaled(p))
        elif kind == "SphereLight":
            lights[name] = lambda p, e=surface(sphere(origin, float(get["radius"])), nits): e(unscaled(p))
        elif kind in ("RectLight", "DiskLight"):
            w, h = ((float(get["width"]) / 2, float(get["height"]) / 2) if kind == "RectLight"
                    else (float(get["radius"]),) * 2)
            columns = [[w * c for c in x], [-h * c for c in y], None, origin]
            samples = flat(columns, "disk" if kind == "DiskLight" else "rectangle")
            lights[name] = lambda p, e=surface(samples, nits): e(unscaled(p))
        # A CylinderLight has no caps, which ours have: it is another shape of the same flux.
    return lights


gonio, profiles = sys.argv[1:]
lights = [
    {"name": "bulb", "shape": "sphere:r=8cm", "intensity": "800lm", "color": "2700K", "position": [0.5, 1, 1.5]},
    {"name": "disk", "shape": "disk:r=20cm", "intensity": "900lm", "position": [-1.2, 0.5, 1.8], "direction": [0.3, 0, -1]},
    {"name": "ellipse", "shape": "ellipse:w=70cm,h=25cm", "intensity": "900lm", "position": [-0.6, -0.9, 1.9],
     "direction": [0.2, 0.3, -1], "rotate": "20deg"},
    {"name": "panel", "shape": "rect:w=60cm,h=30cm,two-sided", "intensity": "2000lm", "color": "4000K",
     "position": [1, -1, 2], "direction": [-0.4, 0.3, -1], "rotate": "30deg"},
    {"name": "tube", "shape": "tube:r=5cm,l=90cm", "intensity": "1500lm", "position": [0, -1.4, 2.2],
     "direction": [0, 0.1, -1], "up": [0.5, 1, 0]},
    {"name": "linear", "shape": "spot:outer=55deg,inner=20deg,falloff=linear-angle", "intensity": "3000cd",
     "position": [-1, -1, 2.5], "direction": [0.4, 0.5, -1]},
    {"name": "soft", "shape": "spot:outer=60deg,inner=15deg,falloff=smoothstep-angle", "intensity": "900lm",
     "position": [1.5, 1.2, 2], "direction": [-0.5, -0.3, -1], "range": "9m"},
    {"name": "cone", "shape": "spot:outer=60deg,falloff=linear-cos", "intensity": "700cd", "color": "#ffd9a0",
     "position": [0, 1.2, 2], "direction": [0.1, -0.6, -1]},
    {"name": "street", "shape": f"ies:{os.path.abspath(profiles)}/street.ies", "color": "3000K",
     "position": [0.2, 0.1, 2.6], "direction": [0.1, 0.2, -1], "rotate": "40deg"},
    {"name": "accent", "shape": f"ies:{os.path.abspath(profiles)}/accent.ies", "intensity": "400lm",
     "position": [0.3, -0.3, 2.2], "direction": [0.1, 0.2, -1]},
    {"name": "point", "shape": "point", "intensity": "40cd", "position": [-0.3, -0.5, 1]},
    {"name": "sun", "shape": "sun:angle=0.53deg", "intensity": "500lx", "direction": [0.3, 0.4, -1]},
]
failed = False
with tempfile.TemporaryDirectory() as folder:
    with open(os.path.join(folder, "studio.json"), "w", encoding="ascii") as rig:
        json.dump({"schema": "gonio.rig/1", "lights": lights}, rig)
    targets = {"mitsuba": mitsuba, "luxcore": luxcore, "godot": godot, "usd": usd}
    subprocess.run([gonio, "import", os.path.join(folder, "studio.json"), "--allow-outside", "--to", ",".join(targets),
                    "-O", folder, "-q"], check=True)
    # A range is left out where a target has no window: compared without.
    for light in lights:
        light.pop("range", None)
    with open(os.path.join(folder, "open.json"), "w", encoding="ascii") as rig:
        json.dump({"schema": "gonio.rig/1", "lights": lights}, rig)
    truth = []
    for point in POINTS:
        said = subprocess.run([gonio, "probe", "--rig", os.path.join(folder, "open.json"), "--allow-outside",
                               "--at", ",".join(map(str, point)), "--normal", "0,0,1", "--json"],
                              check=True, capture_output=True, text=True).stdout
        truth.append({light["name"]: light["illuminance_lx"] for light in json.loads(said)["points"][0]["lights"]})
    for target, read in targets.items():
        written = read(os.path.join(folder, target), "studio")
        written = {name: light for name, light in written.items() if not name.endswith("_back")}
        expected = [light["name"] for light in lights if not (target == "usd" and light["name"] == "tube")]
        assert sorted(written) == sorted(expected), (target, sorted(written))
        for name in expected:
            if target == "godot" and name == "soft":
                continue  # its window is Godot's own
            brightest = max(values[name] for values in truth)
            assert brightest > 1.0, name
            # Far-field profiles stand for the areas that Godot has not: those are near here.
            if target == "godot" and name in ("bulb", "disk", "ellipse", "tube"):
                continue
            worst = max(abs(written[name](point) - values[name]) for point, values in zip(POINTS, truth)) / brightest
            # 8-bit and filtered textures against the table; meshes of flat faces; quadrature.
            most = 0.02 if name in ("street", "accent") and target in ("godot", "mitsuba") else 0.005
            if worst > most:
                print(f"{target}: {name} is off by {worst:.4f} of {brightest:.4g} lx")
                failed = True
        print(f"{target}: {len(expected)} lights at {len(POINTS)} points")
sys.exit(1 if failed else 0)
