"""Renders a grey floor under the lights that an imported script made, by Cycles or EEVEE:

blender --background --factory-startup --python blender_floor.py -- cycles|eevee LAMP.py OUT.json LIGHT

Adds the illuminance of 32 by 32 pixels to OUT.json, the lowest row first.
"""

import json
import math
import os
import sys
import tempfile

import bpy
import numpy

engine, lamp, out, light = sys.argv[sys.argv.index("--") + 1 :]
SIZE = 32
NITS_PER_UNIT = 177.83  # Blender's IES node counts lumens of a watt so

for thing in list(bpy.data.objects):
    bpy.data.objects.remove(thing)
bpy.context.scene.world.use_nodes = False
bpy.context.scene.world.color = (0.0, 0.0, 0.0)
with open(lamp, encoding="ascii") as script:
    exec(compile(script.read(), lamp, "exec"), {"__name__": "lamp", "__file__": os.path.abspath(lamp)})

grey = bpy.data.materials.new("grey")
grey.use_nodes = True
grey.node_tree.nodes.clear()
diffuse = grey.node_tree.nodes.new("ShaderNodeBsdfDiffuse")
diffuse.inputs["Color"].default_value = (0.5, 0.5, 0.5, 1.0)
surface = grey.node_tree.nodes.new("ShaderNodeOutputMaterial")
grey.node_tree.links.new(diffuse.outputs[0], surface.inputs["Surface"])
bpy.ops.mesh.primitive_plane_add(size=2.0)
bpy.context.object.data.materials.append(grey)

# Below the lights: their bodies must not hide the floor.
camera = bpy.data.cameras.new("camera")
camera.type = "ORTHO"
camera.ortho_scale = 2.0
camera.clip_start, camera.clip_end = 0.01, 1.0
placed = bpy.data.objects.new("camera", camera)
placed.location = (0.0, 0.0, 0.5)
scene = bpy.context.scene
scene.collection.objects.link(placed)
scene.camera = placed
scene.render.resolution_x = scene.render.resolution_y = SIZE
scene.render.resolution_percentage = 100
scene.view_settings.view_transform = "Raw"
if engine == "cycles":
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 1024
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.use_denoising = False
    scene.cycles.max_bounces = 0
    scene.cycles.sample_clamp_direct = 0.0
    scene.cycles.pixel_filter_type = "BLACKMAN_HARRIS"  # a box would be as wide as a pixel
    scene.cycles.filter_width = 0.01
else:
    scene.render.engine = "BLENDER_EEVEE"
    scene.eevee.taa_render_samples = 16
    scene.eevee.gi_diffuse_bounces = 0
    scene.eevee.light_threshold = 1e-6  # the default of 0.01 cuts off faint lights
    scene.render.filter_size = 0.01
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_depth = "32"
scene.render.filepath = os.path.join(tempfile.mkdtemp(), "floor.exr")
bpy.ops.render.render(write_still=True)

picture = bpy.data.images.load(scene.render.filepath)
picture.colorspace_settings.name = "Non-Color"
pixels = numpy.empty(SIZE * SIZE * 4, dtype=numpy.float32)
picture.pixels.foreach_get(pixels)
luminance = pixels.reshape(-1, 4)[:, :3] @ numpy.array([0.212639, 0.715169, 0.072192])
rendered = {"program": engine, "version": bpy.app.version_string, "lux": {}, "failed": {}}
if os.path.exists(out):
    with open(out, encoding="ascii") as file:
        rendered = json.load(file)
rendered["lux"][light] = (luminance * NITS_PER_UNIT * math.pi / 0.5).tolist()
with open(out, "w", encoding="ascii") as file:
    json.dump(rendered, file)
