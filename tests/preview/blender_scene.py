"""Renders the stage of a rig under the lights that an imported script made: the illuminance of what is seen.

blender --background --factory-startup --python blender_scene.py -- RIG.json LIGHTS.py OUT.exr WIDTH HEIGHT [SAMPLES]

Planes and spheres, white and matte, by direct light alone. The picture holds Blender's own radiance; its W/m2 times
177.83, the lumens that Blender counts for a watt of an IES profile, times pi are lux.
"""

import json
import math
import sys

import bpy
from mathutils import Vector

rig_file, lights, out, width, height, *samples = sys.argv[sys.argv.index("--") + 1 :]
with open(rig_file, encoding="utf-8") as text:
    rig = json.load(text)

for thing in list(bpy.data.objects):
    bpy.data.objects.remove(thing)
with open(lights, encoding="ascii") as script:
    exec(compile(script.read(), lights, "exec"), {"__name__": "lights"})

white = bpy.data.materials.new("white")
white.use_nodes = True
nodes = white.node_tree.nodes
nodes.clear()
diffuse = nodes.new("ShaderNodeBsdfDiffuse")
diffuse.inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
white.node_tree.links.new(diffuse.outputs[0], nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])

for surface in rig["stage"]["surfaces"]:
    if "plane" in surface:
        plane = surface["plane"]
        bpy.ops.mesh.primitive_plane_add(size=60.0, location=plane["point"])
        bpy.context.object.rotation_euler = Vector(plane["normal"]).to_track_quat("Z", "Y").to_euler()
    else:
        ball = surface["sphere"]
        bpy.ops.mesh.primitive_uv_sphere_add(
            segments=512, ring_count=256, radius=float(ball["radius"].removesuffix("m")), location=ball["center"]
        )
        bpy.ops.object.shade_smooth()
    bpy.context.object.data.materials.append(white)

view = rig["camera"]
eye = bpy.data.cameras.new("eye")
eye.sensor_fit = "VERTICAL"
eye.angle = math.radians(float(view["fov"].removesuffix("deg")))
camera = bpy.data.objects.new("eye", eye)
camera.location = view["position"]
camera.rotation_euler = (Vector(view["target"]) - Vector(view["position"])).to_track_quat("-Z", "Y").to_euler()
scene = bpy.context.scene
scene.collection.objects.link(camera)
scene.camera = camera

scene.world = bpy.data.worlds.new("dark")
scene.world.color = (0.0, 0.0, 0.0)
scene.render.engine = "CYCLES"
scene.cycles.device = "CPU"
scene.cycles.samples = int(samples[0]) if samples else 512
scene.cycles.use_adaptive_sampling = False
scene.cycles.use_denoising = False
scene.cycles.max_bounces = 0
scene.cycles.pixel_filter_type = "BOX"
scene.render.resolution_x = int(width)
scene.render.resolution_y = int(height)
scene.render.resolution_percentage = 100
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_depth = "32"
scene.render.filepath = out
bpy.ops.render.render(write_still=True)
