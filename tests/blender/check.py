"""Run by run.sh in Blender: check.py -- FOLDER. Leaves rigs and the planes that Cycles renders under the same lights."""

import json
import os
import sys

import bpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "import"))
from plane import render_plane

folder = sys.argv[sys.argv.index("--") + 1]
scene = bpy.context.scene
bpy.ops.preferences.addon_install(filepath=os.path.join(folder, "gonio_lights.zip"), overwrite=True)
bpy.ops.preferences.addon_enable(module="gonio_lights")


def path(name):
    return os.path.join(folder, name)


def clear():
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)


def load(*names, **options):
    bpy.ops.import_scene.photometric_light(
        filepath=path(names[0]), directory=folder, files=[{"name": name} for name in names], **options
    )
    return {thing.name: thing for thing in bpy.context.selected_objects}


def refused(*names):
    """What the dialog says: Blender raises it where there is none."""
    try:
        load(*names)
    except RuntimeError as error:
        return str(error)
    raise AssertionError(f"{names} was imported")


# What the tool says of broken files, in its own sentences, and nothing is left in the scene.
clear()
for name, sentence in (("cut off.ies", "cut off.ies"), ("text.ies", "text.ies"), ("missing.ies", "cannot read")):
    said = refused(name)
    assert "Traceback" not in said and sentence in said and "error[" in said, said
assert not bpy.data.objects

# The good ones of several, by a file name with a comma, too.
try:
    load("street.ies", "text.ies", "wall, washer.ies")
except RuntimeError as error:
    assert "text.ies" in str(error)
assert {"street", "wall, washer"} <= {thing.name for thing in bpy.data.objects}, list(bpy.data.objects)

# Lumens and kelvin, opening and point, turned and moved.
clear()
street = load("street.ies")["street"]
assert street.type == "EMPTY" and street.gonio.has_opening and abs(street.gonio.lumens - 6000.0) < 0.01
street.location = (-0.6, 0.4, 0.1)
street.rotation_euler = (0.3, -0.2, 0.5)
street.gonio.lumens = 1500.0
street.gonio.has_kelvin = True
street.gonio.kelvin = 2700.0
batwing = load("batwing.ldt", size="POINT")["batwing"]
assert batwing.type == "LIGHT" and not batwing.gonio.has_opening
batwing.location = (0.7, -0.5, 0.8)
batwing.rotation_euler = (-0.2, 0.3, 1.0)
pendant = load("pendant.ies")["pendant"]
pendant.location = (0.9, 0.9, 0.2)
pendant.gonio.lumens = 400.0

# A duplicate of an empty and its faces has an amount and axes of its own.
for thing in bpy.data.objects:
    thing.select_set(thing in (street, *street.children))
bpy.context.view_layer.objects.active = street
bpy.ops.object.duplicate()
twin = next(thing for thing in bpy.context.selected_objects if thing.type == "EMPTY")
assert twin != street and twin.gonio.lumens == 1500.0 and len(twin.children) == len(street.children)
twin.location = (0.2, -1.1, 0.3)
twin.rotation_euler = (-0.6, 0.3, 2.0)
twin.gonio.lumens = 700.0
assert street.gonio.lumens == 1500.0
bpy.context.view_layer.update()
assert bpy.ops.export_scene.photometric_rig(filepath=path("measured.json")) == {"FINISHED"}
render_plane(path("measured.csv"), 1024, -0.9)

# Blender's own lights.
clear()
for kind, place, watts in (("POINT", (-0.8, -0.6, 0.4), 60.0), ("AREA", (0.6, 0.8, 0.0), 40.0), ("SUN", (0, 0, 2), 1.0)):
    light = bpy.data.lights.new(kind.lower(), kind)
    light.energy = watts
    light.color = (1.0, 0.8, 0.6)
    thing = bpy.data.objects.new(kind.lower(), light)
    thing.location = place
    thing.rotation_euler = (0.2, 0.3, 0.4)
    scene.collection.objects.link(thing)
bpy.data.lights["point"].shadow_soft_size = 0.0
bpy.data.lights["area"].shape = "RECTANGLE"
bpy.data.lights["area"].size, bpy.data.lights["area"].size_y = 0.5, 0.3
bpy.data.lights["sun"].angle = 0.01
bpy.context.view_layer.update()
assert bpy.ops.export_scene.photometric_rig(filepath=path("own.json")) == {"FINISHED"}
names = [light["name"] for light in json.load(open(path("own.json"), encoding="utf-8"))["lights"]]
assert names == ["area", "point", "sun"], names
render_plane(path("own.csv"), 1024, -0.9)

clear()
try:
    bpy.ops.export_scene.photometric_rig(filepath=path("empty.json"))
    raise AssertionError("a rig without lights was written")
except RuntimeError as error:
    assert "no lights" in str(error), error
assert not os.path.exists(path("empty.json"))

bpy.ops.preferences.addon_disable(module="gonio_lights")
print("the add-on holds")
