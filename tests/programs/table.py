"""Prints lib/gonio/asset/PROGRAMS.md: what each target holds, and what was measured in programs.

table.py GONIO MEASURED.csv

What a target holds is asked of the tool: it writes every light of lights.json for every target, and says what it writes
instead. What it reads is asked of `gonio list scene-formats`. The deviations are those that run.sh wrote into MEASURED.csv.
"""

import csv
import json
import os
import subprocess
import sys
import tempfile

here = os.path.dirname(os.path.abspath(__file__))
root = os.path.dirname(os.path.dirname(here))
gonio, measured_file = map(os.path.abspath, sys.argv[1:])
COLUMNS = ["point", "spot", "profile", "projector", "sphere", "disk", "rect", "tube", "cylinder", "sun", "sky"]
FALLOFFS = ["frostbite", "smoothstep-cos", "smoothstep-angle", "linear-angle", "linear-cos"]
PROGRAMS = {  # as run.sh names them: as they are called
    "threejs": "three.js, WebGPURenderer",
    "threejs-webgl": "three.js, WebGLRenderer",
    "gltf": "three.js, GLTFLoader",
    "babylon": "Babylon.js",
    "playcanvas": "PlayCanvas",
    "filament": "Filament",
    "pathtracer": "three-gpu-pathtracer",
    "cycles": "Blender, Cycles",
    "eevee": "Blender, EEVEE",
}
FIRST = {"threejs": "threejs", "babylon": "babylon", "playcanvas": "playcanvas", "filament": "filament",
         "blender": "cycles"}
READ = {"unreal": "by a script in it", "unity": "by a script in it", "blender": "by the add-on", "raw": "as profiles"}
ELSEWHERE = {"radiance": "Radiance 5.3, rtrace: tests/radiance"}


def run(*arguments, folder, may_fail=False):
    done = subprocess.run([gonio, *arguments], cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode and not may_fail:
        sys.exit(done.stderr)
    return done.stdout


def percent(number):
    return "< 0.01 %" if number < 0.01 else f"{number:.2g} %" if number < 99.5 else f"{number:.0f} %"


def held(folder, lights, targets):
    """By target and light: None if it is lost, else what the tool says it writes instead."""
    for name, light in lights.items():
        rig = {"schema": "gonio.rig/1", "lights": []}
        if isinstance(light, str):
            # As a small picture, since each target has a call of its own, which would work it out again.
            run("sky", "convert", light, "-s", "64", "-o", name + ".exr", "-q", folder=folder)
            rig["sky"] = f"image:{name}.exr"
        else:
            rig["lights"] = [{"name": name, **light}]
        with open(os.path.join(folder, name + ".json"), "w", encoding="ascii") as file:
            json.dump(rig, file)
    os.mkdir(os.path.join(folder, "assets"))
    # What one target refuses is written for none of a call: raw has no sun, several have no sky.
    everywhere = [name for name in lights if name not in ("sun", "sky")]
    calls = [(everywhere, targets)] + [([name], [target]) for name in ("sun", "sky") for target in targets]
    for names, into in calls:
        run("import", *(name + ".json" for name in names), "--to", ",".join(into), "-O", "assets", "-q", folder=folder,
            may_fail=len(into) == 1)
    found = {}
    for target in targets:
        for name in lights:
            record = os.path.join(folder, "assets", target, name + ".asset.json")
            found[target, name] = None
            if os.path.exists(record):
                with open(record, encoding="ascii") as file:
                    found[target, name] = json.load(file).get("instead", [])
    return found


with open(os.path.join(here, "lights.json"), encoding="ascii") as file:
    lights = json.load(file)
for falloff in FALLOFFS:
    for inner in (15, 0):
        lights[f"{falloff}-{inner}"] = {"shape": f"spot:outer=40deg,inner={inner}deg,falloff={falloff}", "intensity": "9cd"}
with open(measured_file, encoding="ascii") as file:
    measured = list(csv.DictReader(file))
with tempfile.TemporaryDirectory() as folder:
    for profile in ("street.ies", "pendant.ies"):
        with open(os.path.join(root, "profiles", profile), "rb") as file, open(os.path.join(folder, profile), "wb") as copy:
            copy.write(file.read())
    run("preview", "--stage", "room", "--preset", "incandescent-60", "--size", "48x48", "-o", "picture.png", "-q", folder=folder)
    targets = [one["name"] for one in json.loads(run("list", "targets", "--json", folder=folder))["entries"]]
    read = {one["name"] for one in json.loads(run("list", "scene-formats", "--json", folder=folder))["entries"]}
    found = held(folder, lights, targets)

deviation = {(one["program"], one["light"]): float(one["percent"]) for one in measured}
version = {one["program"]: one["version"] for one in measured}


def cell(target, light):
    instead = found[target, light]
    number = deviation.get((FIRST.get(target), light))
    if instead is None:
        return "lost"
    if light == "spot":
        exact = [one for one in FALLOFFS if found[target, f"{one}-15"] == []]
        exact = exact or [one + " from the axis on" for one in FALLOFFS if found[target, f"{one}-0"] == []]
        number = deviation.get((FIRST.get(target), {"smoothstep-cos": "spot-smooth"}.get(exact[0], "spot"))) if exact else number
        return ("as a profile" if not exact else exact[0]) + ("" if number is None or number < 1 else f" ({percent(number)})")
    if not instead:
        return "exact" if number is None or number < 1 else f"{percent(number)}"
    return "approximate" if number is None else f"≈ {percent(number)}"


print("""# asset: what programs do with the lights

Printed by `python3 tests/programs/table.py GONIO tests/programs/measured.csv`; a test compares this page with it.

"exact" is the program's own light of that kind. A number is the greatest difference of the illuminance of a floor of 2 by 2 m,
1.1 to 1.3 m below the light, from that of `gonio probe`, as a share of the brightest point; with ≈ the tool says that it writes something
else instead, mostly a point with the same intensities. "approximate" was not run. The lights are those of
[lights.json](../../../tests/programs/lights.json).
""")
print("| target | " + " | ".join(COLUMNS) + " | read by `gonio lights` | run in |")
print("|---" * (len(COLUMNS) + 3) + "|")
for target in targets:
    names = [f"{PROGRAMS[name]} {version[name]}" for name in PROGRAMS
             if name in version and any(one["program"] == name and one["target"] == target for one in measured)]
    if target in ELSEWHERE:
        names.append(ELSEWHERE[target])
    print(f"| `{target}` | " + " | ".join(cell(target, light) for light in COLUMNS) +
          f" | {READ.get(target, 'yes' if target in read else 'no')} | {'; '.join(names) or 'not run'} |")

shown = [name for name in PROGRAMS if name in version]
names = [light for light in lights if any(one["light"] == light for one in measured)]
print("""
## Measured

`bash tests/programs/run.sh` renders each light in each program, in headless Chromium or Blender. The numbers are as above;
those of three-gpu-pathtracer, with 32 samples, are of blocks of 4 by 4 pixels.
`spot` falls as glTF's, `spot-smooth` as smoothstep over the cosine; `profile` is a street light, `profile-up` an axial pendant.
""")
print("| program | " + " | ".join(names) + " |")
print("|---" * (len(names) + 1) + "|")
notes = """
Why numbers are large:

* three.js' WebGLRenderer ignores profiles. Before r187, WebGPURenderer took C = 180 for every azimuth, and IESLoader squared the
  candela of a file, which `import` does not use: its textures hold intensities.
* three.js' GLTFLoader reads neither EXT_lights_ies nor EXT_lights_area, so that the light of the same flux is seen; and three.js
  draws every spot as smoothstep over the cosine, which glTF's is not.
* Babylon.js looks profiles up by the angle to the axis alone: azimuths are averaged.
* three-gpu-pathtracer does so too, at C = 180, and from the edges of texels, not their middles. It ignores projected images.
* Filament has neither profiles nor areas: the light of the same flux is seen.
* EEVEE ignores nodes of lights, so that profiles, spots and images are lost, and meshes do not light it.
* PlayCanvas has 16/(d² + 1) for the inverse square and no 1/π in its diffuse reflection. What `import` writes puts 1/d² in its place
  and divides by π. Without that, a floor 1 m below a point is 8π times too bright, one 2.1 m below 41 times.
  With clustered lighting, its default, which copies profiles into 8 bits, spots are off by 2 % and the street light by 59 %.
* Areas that are written as points stand two to seven times their size above the floor.
* EEVEE, three.js and Babylon.js approximate how the edges of areas are seen: 0.3 to 1.9 %.
"""
for name in shown:
    cells = [percent(deviation[name, light]) if (name, light) in deviation else "-" for light in names]
    print(f"| {PROGRAMS[name]} {version[name]} | " + " | ".join(cells) + " |")
print(notes.rstrip())
