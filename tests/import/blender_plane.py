"""Renders the plane z = -1 under the lights that an imported script made, and writes the illuminance of its pixels.

blender --background --factory-startup --python blender_plane.py -- LAMP.py OUT.csv [SAMPLES]
"""

import os
import sys

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from plane import render_plane

lamp, out, *samples = sys.argv[sys.argv.index("--") + 1 :]

for thing in list(bpy.data.objects):
    bpy.data.objects.remove(thing)
with open(lamp, encoding="ascii") as script:
    exec(compile(script.read(), lamp, "exec"), {"__name__": "lamp", "__file__": os.path.abspath(lamp)})
render_plane(out, int(samples[0]) if samples else 256, -0.5)
