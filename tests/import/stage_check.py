#!/usr/bin/env python3
"""stage_check.py GONIO: exports a stage of every shape for programs that are not run here, and renders what was written.

Cameras, transformations, shapes, Lambertian materials and a point light of Mitsuba, pbrt, Radiance and UsdGeom are read and traced
here again: the luminance through the middle of each pixel, shadow included, against the picture that gonio preview
renders of the same request. Nothing else is shared with the tool.
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

WIDTH, HEIGHT = 44, 33
STAGE = {
    "name": "bodies",
    "surfaces": [
        {"name": "floor", "plane": {"point": [0, 0, 0], "normal": [0, 0, 1]}, "material": "lambert:albedo=0.5"},
        {"name": "wall", "plane": {"point": [0, 1.4, 0], "normal": [0.1, -1, 0]}, "material": "lambert:albedo=rgb(0.6,0.5,0.3)"},
        {"name": "panel", "panel": {"center": [0.8, 0.9, 0.7], "normal": [-1, -2, 0.5], "up": [0.2, 0, 1], "width": "0.8m",
                                    "height": "0.5m"}, "material": "lambert:albedo=rgb(0.2,0.7,0.4)"},
        {"name": "ball", "sphere": {"center": [-0.6, 0.1, 0.4], "radius": "0.4m"}, "material": "lambert:albedo=rgb(0.8,0.3,0.2)"},
        {"name": "box", "box": {"center": [0.4, 0.1, 0.25], "size": [0.4, 0.6, 0.3], "up": [0.2, 0.1, 1], "rotate": "30deg"},
         "material": "lambert:albedo=rgb(0.3,0.3,0.9)"},
        {"name": "capsule", "capsule": {"from": [-0.2, 0.7, 0.15], "to": [0.3, 0.8, 0.9], "radius": "12cm"},
         "material": "lambert:albedo=0.7"},
    ],
}
RIG = {
    "schema": "gonio.rig/1",
    "lights": [{"name": "bulb", "shape": "point", "intensity": "120cd", "color": "#ffd9a0", "position": [0.3, -0.9, 1.8]}],
    "stage": STAGE,
    "camera": {"position": [0.4, -2.8, 1.5], "target": [0.05, 0.3, 0.45], "up": [0.1, 0, 1], "fov": "38deg"},
}


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def plus(a, b, factor=1.0):
    return tuple(x + factor * y for x, y in zip(a, b))


def unit(a):
    return tuple(x / math.sqrt(dot(a, a)) for x in a)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def numbers(text):
    return [float(word) for word in re.split(r"[,\s()\[\]]+", text.strip()) if word]


# Bodies in space of their own, through the columns x, y, z and origin of a transformation without shear.
class Placed:
    def __init__(self, columns, color, hit):
        self.columns, self.color, self.hit = columns, color, hit

    def meet(self, origin, direction):
        """Distance and normal, of a ray in the world."""
        x, y, z, o = self.columns
        local = lambda v: tuple(dot(v, axis) / dot(axis, axis) for axis in (x, y, z))
        found = self.hit(local(plus(origin, o, -1.0)), local(direction))
        if found is None:
            return None
        t, n = found  # normals go by the inverse of the scale
        normal = (0.0, 0.0, 0.0)
        for component, axis in zip(n, (x, y, z)):
            normal = plus(normal, axis, component / dot(axis, axis))
        return t, unit(normal)


def square(half_width=1.0, half_height=1.0):
    """At z = 0, seen from both sides: its front is +Z."""
    def hit(o, d):
        if d[2] == 0.0:
            return None
        t = -o[2] / d[2]
        if t <= 1e-9 or abs(o[0] + t * d[0]) > half_width or abs(o[1] + t * d[1]) > half_height:
            return None
        return t, (0.0, 0.0, 1.0)

    return hit


def cube(half=(1.0, 1.0, 1.0)):
    def hit(o, d):
        enter, leave, axis = -math.inf, math.inf, 0
        for k in range(3):
            if d[k] == 0.0:
                if abs(o[k]) > half[k]:
                    return None
                continue
            a, b = sorted(((-half[k] - o[k]) / d[k], (half[k] - o[k]) / d[k]))
            if a > enter:
                enter, axis = a, k
            leave = min(leave, b)
        if enter > leave or enter <= 1e-9:
            return None
        return enter, tuple(-math.copysign(1.0, d[k]) if k == axis else 0.0 for k in range(3))

    return hit


def ball(center, radius):
    def hit(o, d):
        o = plus(o, center, -1.0)
        a, b, c = dot(d, d), dot(o, d), dot(o, o) - radius * radius
        if b * b < a * c:
            return None
        t = (-b - math.sqrt(b * b - a * c)) / a
        return (t, tuple(x / radius for x in plus(o, d, t))) if t > 1e-9 else None

    return hit


def cylinder(radius, low, high):
    def hit(o, d):
        a, b, c = d[0] ** 2 + d[1] ** 2, o[0] * d[0] + o[1] * d[1], o[0] ** 2 + o[1] ** 2 - radius * radius
        if a == 0.0 or b * b < a * c:
            return None
        t = (-b - math.sqrt(b * b - a * c)) / a
        if t <= 1e-9 or not low <= o[2] + t * d[2] <= high:
            return None
        return t, ((o[0] + t * d[0]) / radius, (o[1] + t * d[1]) / radius, 0.0)

    return hit


IDENTITY = ((1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, 0))


def mitsuba(folder):
    root = ElementTree.parse(os.path.join(folder, "scene.xml")).getroot()

    def columns(element):
        m = numbers(element.find("transform[@name='to_world']/matrix").get("value"))
        return [(m[k], m[4 + k], m[8 + k]) for k in range(4)]

    def value(element, name):
        return element.find(f"*[@name='{name}']").get("value")

    sensor = root.find("sensor")
    assert root.find("integrator").get("type") == "path" and value(root.find("integrator"), "max_depth") == "1026"
    assert value(sensor, "fov_axis") == "y"
    assert [value(sensor.find("film"), key) for key in ("width", "height")] == [str(WIDTH), str(HEIGHT)]
    left, up, forward, eye = columns(sensor)
    right = tuple(-x for x in left)
    tangent = math.tan(math.radians(float(value(sensor, "fov"))) / 2)
    colors = {bsdf.get("id"): numbers(value(bsdf, "reflectance")) for bsdf in root.findall("bsdf")}
    assert all(bsdf.get("type") == "diffuse" for bsdf in root.findall("bsdf"))
    bodies = []
    for shape in root.findall("shape"):
        kind, color = shape.get("type"), colors[shape.find("ref").get("id")]
        if kind == "sphere":
            bodies.append(Placed(IDENTITY, color, ball(numbers(value(shape, "center")), float(value(shape, "radius")))))
        elif kind == "cylinder":
            p0, p1 = numbers(value(shape, "p0")), numbers(value(shape, "p1"))
            z = unit(plus(p1, p0, -1.0))
            x = unit(cross(z, (0.3, 0.5, -0.7)))
            bodies.append(Placed((x, cross(z, x), z, p0), color, cylinder(float(value(shape, "radius")), 0.0, math.dist(p0, p1))))
        else:
            bodies.append(Placed(columns(shape), color, {"rectangle": square(), "cube": cube()}[kind]))
    light = root.find("emitter")
    assert light.get("type") == "point"
    return (eye, right, up, forward, tangent), bodies, (numbers(value(light, "position")), numbers(value(light, "intensity")))


def pbrt(folder):
    with open(os.path.join(folder, "scene.pbrt"), encoding="ascii") as file:
        text = "\n".join(line.split("#")[0] for line in file)
    tokens = re.findall(r'"[^"]*"|\[|\]|[^\s\[\]]+', text)
    at = 0

    def take():
        nonlocal at
        at += 1
        return tokens[at - 1]

    def parameters():
        found = {}
        while at < len(tokens) and tokens[at].startswith('"'):
            name, values = take().strip('"').split()[1], []
            if tokens[at] == "[":
                take()
                while tokens[at] != "]":
                    values.append(take())
                take()
            else:
                values.append(take())
            found[name] = [v.strip('"') if v.startswith('"') else v if v in ("true", "false") else float(v) for v in values]
        return found

    def listed():
        assert take() == "["
        values = []
        while tokens[at] != "]":
            values.append(float(take()))
        take()
        return values

    place = lambda ctm, p: tuple(sum(ctm[k][j] * p[k] for k in range(3)) + ctm[3][j] for j in range(3))
    turn = lambda ctm, v: tuple(sum(ctm[k][j] * v[k] for k in range(3)) for j in range(3))

    def times(ctm, inner):
        return [turn(ctm, inner[k]) for k in range(3)] + [place(ctm, inner[3])]

    ctm, material, saved, materials, bodies = list(IDENTITY), None, [], {}, []
    camera = light = None
    while at < len(tokens):
        word = take()
        if word == "Transform":
            m = listed()
            world_to_camera = [m[4 * k : 4 * k + 3] for k in range(4)]
        elif word == "Camera":
            assert take() == '"perspective"'
            fov = math.radians(parameters()["fov"][0])
        elif word in ("Film", "PixelFilter", "Sampler", "Integrator"):
            kind, given = take(), parameters()
            if word == "Film":
                assert given["xresolution"] == [WIDTH] and given["yresolution"] == [HEIGHT]
            if word == "Integrator":
                assert kind == '"path"' and given["maxdepth"] == [1025.0]
        elif word == "WorldBegin":
            rows = [tuple(world_to_camera[k][j] for k in range(3)) for j in range(3)]
            moved = world_to_camera[3]
            eye = tuple(-sum(rows[j][k] * moved[j] for j in range(3)) for k in range(3))
            # The field of view is that of the shorter side, which is the height here.
            assert WIDTH >= HEIGHT
            camera = (eye, *rows, math.tan(fov / 2))
        elif word == "MakeNamedMaterial":
            name, given = take(), parameters()
            assert given["type"] == ["diffuse"]
            materials[name] = given["reflectance"]
        elif word == "NamedMaterial":
            material = take()
        elif word == "AttributeBegin":
            saved.append((ctm, material))
        elif word == "AttributeEnd":
            ctm, material = saved.pop()
        elif word == "ConcatTransform":
            m = listed()
            ctm = times(ctm, [m[4 * k : 4 * k + 3] for k in range(4)])
        elif word == "Translate":
            ctm = times(ctm, [*IDENTITY[:3], tuple(float(take()) for _ in range(3))])
        elif word == "LightSource":
            assert take() == '"point"'
            given = parameters()
            light = ctm[3], [c * given["scale"][0] for c in given["I"]]
        elif word == "Shape":
            kind, given = take().strip('"'), parameters()
            color = materials[material]
            if kind == "sphere":
                hit = ball((0, 0, 0), given["radius"][0])
            elif kind == "cylinder":
                hit = cylinder(given["radius"][0], given["zmin"][0], given["zmax"][0])
            elif kind == "bilinearmesh":
                p = [given["P"][3 * k : 3 * k + 3] for k in range(4)]
                assert p[0][:2] == [-x for x in p[3][:2]] and p[1] == [p[3][0], p[0][1], 0] and p[2] == [p[0][0], p[3][1], 0]
                hit = square(p[3][0], p[3][1])
            else:
                assert kind == "trianglemesh"
                p = [given["P"][3 * k : 3 * k + 3] for k in range(8)]
                half = [max(q[k] for q in p) for k in range(3)]
                faces = given["indices"]
                normals = []
                for k in range(0, 36, 3):
                    a, b, c = (p[int(i)] for i in faces[k : k + 3])
                    normals.append(unit(cross(plus(b, a, -1.0), plus(c, a, -1.0))))
                    assert dot(normals[-1], a) > 0.0, "a face that looks inwards"
                assert len({tuple(round(x) for x in n) for n in normals}) == 6
                hit = cube(half)
            bodies.append(Placed(ctm, color, hit))
        else:
            raise ValueError(word)
    assert not saved
    return camera, bodies, light


def usd(folder):
    with open(os.path.join(folder, "scene.usda"), encoding="ascii") as file:
        text = file.read()
    assert text.startswith("#usda 1.0\n") and text.count("{") == text.count("}") and text.count("(") == text.count(")")
    colors = dict(re.findall(r'def Material "(\w+)".*?inputs:diffuseColor = \((.*?)\)', text, re.S))
    assert re.search(rf"resolution = \({WIDTH}, {HEIGHT}\)", text)
    bodies, camera, light = [], None, None
    for kind, name, body in re.findall(r'\n    def (\w+) "(\w+)"(.*?)\n    }(?=\n)', text, re.S):
        get = dict(re.findall(r"(?:\w+(?:\[\])?) ([\w:]+) = (.*)", body))
        if kind in ("Scope", "RenderSettings"):
            continue
        m = numbers(get["xformOp:transform"])
        columns = [tuple(m[4 * k : 4 * k + 3]) for k in range(4)]
        if kind == "Camera":
            height = float(get["verticalAperture"])
            assert abs(float(get["horizontalAperture"]) / height - WIDTH / HEIGHT) < 1e-9
            x, y, z, eye = columns
            camera = eye, x, y, tuple(-c for c in z), height / 2 / float(get["focalLength"])
            continue
        if kind == "SphereLight":
            level = float(get["inputs:intensity"]) * math.pi * float(get["inputs:radius"]) ** 2
            light = columns[3], [c * level for c in numbers(get["inputs:color"])]
            continue
        color = numbers(colors[get["material:binding"].strip("<>").split("/")[-1]])
        if kind == "Mesh":
            p = re.findall(r"\((.*?)\)", get["points"])
            corner = numbers(p[2])
            assert get["faceVertexIndices"] == "[0, 1, 2, 3]" and numbers(p[0])[:2] == [-c for c in corner[:2]]
            bodies.append(Placed(columns, color, square(*corner[:2])))
        elif kind == "Cube":
            bodies.append(Placed(columns, color, cube([float(get["size"]) / 2] * 3)))
        elif kind == "Sphere":
            bodies.append(Placed(columns, color, ball((0, 0, 0), float(get["radius"]))))
        elif kind == "Capsule":
            radius, half = float(get["radius"]), float(get["height"]) / 2
            assert get["axis"] == '"Z"'
            for z in (-half, half):
                bodies.append(Placed(columns, color, ball((0, 0, z), radius)))
            bodies.append(Placed(columns, color, cylinder(radius, -half, half)))
        else:
            raise ValueError(kind)
    return camera, bodies, light


def times(matrix, v):
    return tuple(dot(row, v) for row in matrix)


def inverse(m):
    columns = [cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])]
    determinant = dot(m[0], columns[0])
    return [[column[row] / determinant for column in columns] for row in range(3)]


def product(a, b):
    return [[dot(row, [line[k] for line in b]) for k in range(3)] for row in a]


def scaled_columns(m, factors):
    return [[x * f for x, f in zip(row, factors)] for row in m]


def rgb_to_xyz(primaries, white):
    of = [[p[0] for p in primaries], [p[1] for p in primaries], [1 - p[0] - p[1] for p in primaries]]
    return scaled_columns(of, times(inverse(of), white))


def radiance_to_rec709():
    """Between the primaries, the white points adapted by Bradford's cone responses."""
    d65, equal = (0.3127 / 0.329, 1.0, (1 - 0.3127 - 0.329) / 0.329), (1.0, 1.0, 1.0)
    rec709 = rgb_to_xyz(((0.64, 0.33), (0.3, 0.6), (0.15, 0.06)), d65)
    own = rgb_to_xyz(((0.64, 0.33), (0.29, 0.6), (0.15, 0.06)), equal)
    cones = [[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]]
    factors = [b / a for a, b in zip(times(cones, equal), times(cones, d65))]
    adapted = product(scaled_columns(inverse(cones), factors), cones)
    return product(inverse(rec709), product(adapted, own))


def radiance(folder):
    with open(os.path.join(folder, "scene.rad"), encoding="ascii") as file:
        words = "\n".join(line.split("#")[0] for line in file).split()
    with open(os.path.join(folder, "scene.vf"), encoding="ascii") as file:
        view = file.read().split()
    to_rec709 = radiance_to_rec709()

    def option(name, count):
        at = view.index(name) + 1
        return [float(word) for word in view[at : at + count]]

    forward, up = unit(option("-vd", 3)), unit(option("-vu", 3))
    tangent = math.tan(math.radians(option("-vv", 1)[0]) / 2)
    assert "-vtv" in view and abs(math.tan(math.radians(option("-vh", 1)[0]) / 2) / tangent - WIDTH / HEIGHT) < 1e-9
    colors, bodies, light, at = {}, [], {}, 0
    while at < len(words):
        modifier, kind, name = words[at : at + 3]
        assert words[at + 3 : at + 5] == ["0", "0"]
        count = int(words[at + 5])
        v = [float(word) for word in words[at + 6 : at + 6 + count]]
        at += 6 + count
        if kind == "plastic":
            assert v[3:] == [0.0, 0.0]
            colors[name] = times(to_rec709, v[:3])
        elif kind == "light":
            # Its luminance is what Radiance's own weights give, which the adaptation of white would change a little.
            rgb = times(to_rec709, v)
            nits = 179.0 * dot(v, (0.265074126, 0.670114631, 0.064811243))
            light[name] = [nits / dot(rgb, (0.2126390, 0.7151687, 0.0721923)) * x for x in rgb]
        elif modifier in light:
            assert kind == "sphere"
            found = v[:3], [math.pi * v[3] ** 2 * x for x in light[modifier]]
        elif kind == "sphere":
            bodies.append(Placed(IDENTITY, colors[modifier], ball(v[:3], v[3])))
        elif kind == "cylinder":
            z = unit(plus(v[3:6], v[:3], -1.0))
            x = unit(cross(z, (0.3, 0.5, -0.7)))
            bodies.append(Placed((x, cross(z, x), z, v[:3]), colors[modifier], cylinder(v[6], 0.0, math.dist(v[:3], v[3:6]))))
        else:
            assert kind == "polygon" and count == 12
            a, b, c, d = (v[3 * k : 3 * k + 3] for k in range(4))
            x, y = ([0.5 * (q - p) for p, q in zip(a, end)] for end in (b, d))
            assert math.dist(plus(b, plus(d, a, -1.0)), c) < 1e-9 * math.dist(a, c)
            middle = [0.5 * (p + q) for p, q in zip(a, c)]
            bodies.append(Placed((x, y, unit(cross(x, y)), middle), colors[modifier], square()))
    return (option("-vp", 3), unit(cross(forward, up)), up, forward, tangent), bodies, found


def first(bodies, origin, direction):
    hits = [(found[0], found[1], body) for body in bodies if (found := body.meet(origin, direction))]
    return min(hits, key=lambda hit: hit[0]) if hits else None


def luminance(scene, i, j):
    """Of the three channels through the middle of a pixel."""
    (eye, right, up, forward, tangent), bodies, (position, intensity) = scene
    x = (2 * (i + 0.5) - WIDTH) / HEIGHT * tangent
    y = (1 - 2 * (j + 0.5) / HEIGHT) * tangent
    direction = unit(plus(plus(forward, right, x), up, y))
    hit = first(bodies, eye, direction)
    if hit is None:
        return (0.0,) * 3
    t, normal, body = hit
    at = plus(eye, direction, t)
    away = plus(position, at, -1.0)
    facing = dot(normal, away)
    if facing <= 0.0 or dot(normal, direction) >= 0.0:
        return (0.0,) * 3
    blocked = first(bodies, plus(at, normal, 1e-6), away)
    if blocked and blocked[0] < 1.0:
        return (0.0,) * 3
    return tuple(i * c / math.pi * facing / dot(away, away) ** 1.5 for i, c in zip(intensity, body.color))


gonio = sys.argv[1]
failed = False
with tempfile.TemporaryDirectory() as folder:
    with open(os.path.join(folder, "rig.json"), "w", encoding="ascii") as rig:
        json.dump(RIG, rig)
    # Twenty-five pixels for each of ours: where they differ there is an edge.
    fine = 5
    for name in ("scene.xml", "scene.pbrt", "scene.rad", "scene.usda"):
        subprocess.run([gonio, "preview", "--rig", "rig.json", "-s", f"{WIDTH}x{HEIGHT}", "--export", name],
                       cwd=folder, check=True)
    subprocess.run([gonio, "preview", "--rig", "rig.json", "-s", f"{fine * WIDTH}x{fine * HEIGHT}", "--indirect", "off", "-o", "a.exr"],
                   cwd=folder, check=True)
    picture = oiio.ImageBuf(os.path.join(folder, "a.exr"))
    for read in (mitsuba, pbrt, radiance, usd):
        scene = read(folder)
        compared, worst = 0, 0.0
        for j in range(HEIGHT):
            for i in range(WIDTH):
                block = [picture.getpixel(fine * i + a, fine * j + b)[:3] for a in range(fine) for b in range(fine)]
                green = [pixel[1] for pixel in block]
                if max(green) > 1.2 * min(green):
                    continue
                truth = picture.getpixel(fine * i + fine // 2, fine * j + fine // 2)[:3]
                mine = luminance(scene, i, j)
                compared += 1
                worst = max(worst, *(abs(a - b) / max(abs(a), 1e-3) for a, b in zip(truth, mine)))
        print(f"{read.__name__}: {compared} of {WIDTH * HEIGHT} pixels, worst {worst:.1e}")
        # gonio's picture is of floats.
        failed |= worst > 1e-5 or compared < 0.7 * WIDTH * HEIGHT
sys.exit(1 if failed else 0)
