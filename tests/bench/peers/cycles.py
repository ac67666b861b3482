"""A disk light over a floor by Cycles on one thread: blender --background --python cycles.py -- SAMPLES."""
import math
import sys
import time

import bpy

samples = int(sys.argv[sys.argv.index("--") + 1])
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
bpy.ops.mesh.primitive_plane_add(size=200)
bpy.ops.mesh.primitive_uv_sphere_add(radius=0.5, location=(0, 0, 0.5), segments=64, ring_count=32)
light = bpy.data.lights.new("disk", "AREA")
light.shape = "DISK"
light.size = 0.4
light.energy = 100
placed = bpy.data.objects.new("disk", light)
placed.location = (0, 0, 2.5)
scene.collection.objects.link(placed)
camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
camera.location = (0, -5, 1.5)
camera.rotation_euler = (math.radians(85), 0, 0)
scene.collection.objects.link(camera)
scene.camera = camera
scene.render.engine = "CYCLES"
scene.cycles.device = "CPU"
scene.cycles.samples = samples
scene.cycles.use_adaptive_sampling = False
scene.cycles.use_denoising = False
scene.render.threads_mode = "FIXED"
scene.render.threads = 1
scene.render.resolution_x = scene.render.resolution_y = 256
scene.render.resolution_percentage = 100
start = time.perf_counter()
bpy.ops.render.render()
print(f"| Cycles {bpy.app.version_string}, one thread, {samples} samples, without its start | "
      f"{time.perf_counter() - start:.3f} |")
