"""check.py GONIO: what import and preview --export write for Radiance, by Radiance's rtrace, against probe.

First lights of every kind without a stage: direct illuminance. Then whole stages with all bounces: illuminance at 20
points of each, by rtrace's ambient calculation without its cache (-aa 0).
"""
import json
import math
import os
import random
import subprocess
import sys

AMBIENT = ["-ab", "16", "-aa", "0", "-ad", "16384", "-lw", "1e-9", "-lr", "16"]
DIRECT = ["-dt", "0", "-dc", "1", "-ds", "0.01", "-dj", "0", "-ab", "0"]
MATTE = "lambert:albedo=0.5"
gonio = os.path.abspath(sys.argv[1])
here = os.path.dirname(os.path.abspath(__file__))
profiles = os.path.join(here, "..", "..", "profiles")


def run(*command, text=None, folder="."):
    done = subprocess.run(command, input=text, capture_output=True, text=True, cwd=folder)
    if done.returncode:
        sys.exit(f"{' '.join(command)}: {done.stderr.strip() or done.stdout.strip()}")
    return done.stdout


def scene(file, octree):
    with open(octree, "wb") as out:
        done = subprocess.run(["oconv", file], stdout=out, stderr=subprocess.PIPE, cwd=os.path.dirname(octree) or ".")
    if done.returncode:
        sys.exit(f"oconv: {done.stderr.decode().strip()}")


def rtrace(octree, points, options):
    text = "".join(" ".join(map(repr, [*position, *normal])) + "\n" for position, normal in points)
    rows = run("rtrace", "-h", "-I+", *options, os.path.basename(octree), text=text, folder=os.path.dirname(octree) or ".")
    return [179 * sum(w * float(v) for w, v in zip((0.265074126, 0.670114631, 0.064811243), row.split()))
            for row in rows.splitlines()]


def probe(points, *options):
    lux = []
    for position, normal in points:
        at = ",".join(f"{x:.9g}" for x in position)
        to = ",".join(f"{x:.9g}" for x in normal)
        out = run(gonio, "probe", *options, f"--at={at}", f"--normal={to}", "--json", "-q")
        lux.append(json.loads(out)["points"][0]["illuminance_lx"])
    return lux


def compare(name, theirs, ours, limit):
    mean = sum(ours) / len(ours)
    worst = max(abs(a - b) / max(b, 0.05 * mean) for a, b in zip(theirs, ours))
    bias = sum(theirs) / sum(ours) - 1
    passed = worst <= limit
    print(f"{name}: {len(ours)} points, mean {mean:.4g} lx, Radiance's mean {100 * bias:+.3f} %, "
          f"largest difference {100 * worst:.3f} % of the value or a twentieth of the mean (limit {100 * limit:g}){'' if passed else ': FAILED'}")
    return passed


def lights():
    """Each kind of light alone."""
    rng = random.Random(1)
    points = []
    for _ in range(20):
        position = (rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(-4, -1.5))
        length = math.hypot(*position)
        points.append((position, tuple(-x / length for x in position)))
    passed = True
    for name, light in {
        "point": ["--shape", "point", "--intensity", "800lm"],
        "spot": ["--shape", "spot:outer=50deg,inner=30deg", "--intensity", "900cd"],
        "sphere": ["--shape", "sphere:r=20cm", "--intensity", "800lm", "--cct", "2700K"],
        "disk": ["--shape", "disk:r=25cm", "--intensity", "1000lm"],
        "ellipse": ["--shape", "ellipse:w=60cm,h=20cm", "--intensity", "1000lm"],
        "rect": ["--shape", "rect:w=60cm,h=30cm", "--intensity", "1000lm", "--cct", "6500K"],
        "tube": ["--shape", "tube:r=2cm,l=1.2m", "--intensity", "1000lm"],
        **{lamp: [os.path.join(profiles, lamp + ".ies")] for lamp in ("street", "wall-washer", "batwing", "bare-tube")},
    }.items():
        shape = [word.replace("--cct", "--color") for word in light]
        files = ["import", *shape, "--to", "radiance", "-O", ".", "--overwrite", "-q"]
        run(gonio, *files)
        made = os.path.splitext(os.path.basename(shape[0]))[0] if len(shape) == 1 else shape[1].split(":")[0]
        scene(f"{made}.rad", f"radiance/{name}.oct")
        passed &= compare(name, rtrace(f"radiance/{name}.oct", points, DIRECT), probe(points, *shape), 0.01 if name == "tube" else 0.005)
    return passed


def on(count, rng, origin, x, y, normal):
    """Points on a rectangle, a millimetre in front of it."""
    found = []
    for _ in range(count):
        u, v = (rng.uniform(0.1, 0.9) for _ in range(2))
        found.append((tuple(origin[i] + u * x[i] + v * y[i] + 1e-3 * normal[i] for i in range(3)), normal))
    return found


def stages():
    """Small lights: in Radiance, a light with a size also absorbs what others send to it."""
    bulb = {"shape": "point", "intensity": "2000lm"}
    lamp = {"shape": "ies:batwing.ies", "intensity": "3000lm", "color": "3000K"}
    room = [(5, (-2, -2.5, 0), (1.8, 0, 0), (0, 2.8, 0), (0, 0, 1)), # the floor without the sphere's foot
            (5, (-2, -2.5, 2.6), (4, 0, 0), (0, 5, 0), (0, 0, -1)), (5, (-2, -2.5, 0), (0, 5, 0), (0, 0, 2.6), (1, 0, 0)),
            (5, (0.2, 0.2, 0.74), (1.2, 0, 0), (0, 0.9, 0), (0, 0, 1))]
    corridor = [(7, (-1.1, 0, 0), (2.2, 0, 0), (0, 10, 0), (0, 0, 1)), (7, (-1.1, 0, 0), (0, 10, 0), (0, 0, 2.7), (1, 0, 0)),
                (6, (-1.1, 0, 2.7), (2.2, 0, 0), (0, 10, 0), (0, 0, -1))]
    coloured = {"floor": "lambert:albedo=rgb(0.45,0.3,0.2)", "ceiling": "lambert:albedo=0.8",
                "wall": "lambert:albedo=rgb(0.5,0.45,0.4)", "box": "lambert:albedo=0.3", "sphere": "lambert:albedo=0.6"}
    cases = {
        "room-point": (room, {**bulb, "position": [0, 0, 2]}, "room",
                       dict.fromkeys(("floor", "ceiling", "wall", "box", "sphere"), MATTE)),
        "room-profile": (room, {**lamp, "position": [0, 0, 2.4]}, "room", coloured),
        "corridor-profile": (corridor, {**lamp, "position": [0, 4, 2.55]}, "corridor",
                             {name: coloured[name] for name in ("floor", "ceiling", "wall")}),
    }
    with open(os.path.join(profiles, "batwing.ies"), "rb") as source, open("batwing.ies", "wb") as copy:
        copy.write(source.read())
    passed = True
    for name, (planes, light, stage, materials) in cases.items():
        with open(f"{name}.json", "w", encoding="ascii") as file:
            json.dump({"schema": "gonio.rig/1", "lights": [light], "stage": stage, "materials": materials}, file)
        run(gonio, "preview", "--rig", f"{name}.json", "--export", f"{name}.rad", "--overwrite", "-q")
        scene(f"{name}.rad", f"{name}.oct")
        # The lamp's bright place on the ceiling is small as seen from the other end: more rays for each ambient value.
        options = [*DIRECT[:-2], *AMBIENT, *(["-ad", "65536"] if stage == "corridor" else [])]
        rng = random.Random(2)
        points = [point for plane in planes for point in on(plane[0], rng, *plane[1:])]
        passed &= compare(name, rtrace(f"{name}.oct", points, options),
                          probe(points, "--rig", f"{name}.json", "--indirect"), 0.025 if stage == "corridor" else 0.02)
    print(f"rtrace {' '.join(options)}")
    return passed


everything = [lights(), stages()]
sys.exit(0 if all(everything) else 1)
